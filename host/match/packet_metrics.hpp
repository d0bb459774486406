// SPDX-License-Identifier: MIT
// Metrics of the packets that a team spent. But for the first, only games have them that are ended before their time
// and have the budget of a whole match.
#pragma once

#include <array>

#include "match/metric_numbers.hpp"

namespace regista::match {

inline constexpr std::array<const char*, 3> packet_metrics{"packets", "packets_share", "packets_over_share"};

inline MetricPaths packet_paths() {
  return {.of_teams = {packet_metrics.begin(), packet_metrics.end()}, .of_match = {}};
}

}  // namespace regista::match
