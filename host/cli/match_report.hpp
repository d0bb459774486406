// SPDX-License-Identifier: MIT
// What `regista match` says about a match that was played.
#pragma once

#include <string>
#include <string_view>

#include "campaign/match_json.hpp"

namespace regista::cli {

// A page that ends with a newline.
std::string summary_text(const campaign::PlayedMatch& match);

// All its numbers as a long table with a head: a line for each number, home's, away's, and without a side those of the
// match. Paths are those of study/metric.hpp; elements of a list are counted from 1.
std::string metrics_csv(const campaign::PlayedMatch& match);
inline constexpr std::string_view metrics_csv_head = "side,metric,value\n";

}  // namespace regista::cli
