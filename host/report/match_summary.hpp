// SPDX-License-Identifier: MIT
// The report of `regista match` on a played match.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "campaign/match_encoding.hpp"
#include "report/what_was_played.hpp"

namespace regista::report {

// The text and the JSON begin with the inputs of the match and end with a newline.
std::string summary_text(const campaign::PlayedMatch& match, const WhatWasPlayed& played);
std::string summary_json(const campaign::PlayedMatch& match, const WhatWasPlayed& played);

// Returns all numbers of the match as a table with a header and a line for each number: first the numbers without a
// side, then the numbers of home and of away. Elements of a list count from 1.
std::string metrics_csv(const campaign::PlayedMatch& match,
                        std::span<const match::MetricRow> table = match::metric_table());
inline constexpr std::string_view metrics_csv_head = "side,metric,value\n";

}  // namespace regista::report
