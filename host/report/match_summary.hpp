// SPDX-License-Identifier: MIT
// What `regista match` says about a match that was played.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "campaign/match_json.hpp"
#include "report/what_was_played.hpp"

namespace regista::report {

// Both end with a newline, and begin with what was played.
std::string summary_text(const campaign::PlayedMatch& match, const WhatWasPlayed& played);
std::string summary_json(const campaign::PlayedMatch& match, const WhatWasPlayed& played);

// All its numbers as a long table with a head: a line for each number, without a side those of the match, then home's
// and away's. Elements of a list are counted from 1.
std::string metrics_csv(const campaign::PlayedMatch& match,
                        std::span<const match::MetricRow> table = match::metric_table());
inline constexpr std::string_view metrics_csv_head = "side,metric,value\n";

}  // namespace regista::report
