// SPDX-License-Identifier: MIT
// Metrics of the packets that a team spent. But for the first, only games have them that are ended before their time and
// have the budget of a whole match: see metric_table.cpp.
#pragma once

#include <array>

namespace regista::match {

inline constexpr std::array<const char*, 3> packet_metrics{"packets", "packets_share", "packets_over_share"};

}  // namespace regista::match
