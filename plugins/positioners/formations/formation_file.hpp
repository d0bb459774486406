// SPDX-License-Identifier: MIT
// Formation files of librcsc (JSON), as HELIOS base and other teams of the 2D simulation league publish them:
//   "method": "DelaunayTriangulation", or "Static" with one sample;
//   "role": [{"number": 1, "name": "Goalie", ...}, ...];
//   "data": [{"ball": {"x": 0, "y": 0}, "1": {"x": -50, "y": 0}, ..., "11": {...}}, ...]
// in metres, origin at the centre, x towards the opponent's goal and y to the RIGHT. Other members are ignored.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "formation.hpp"

namespace formations {

inline constexpr std::size_t most_bytes = 4'000'000, most_samples = 1000, most_positions = 64;
inline constexpr double farthest = 1000.0;  // m

// Samples in the file's order, turned to y left. Balls are rounded to the grid. Throws std::invalid_argument: one line
// that begins with "formation: " and says where it is wrong and what is missing.
std::vector<Sample> read_formation(std::string_view bytes);

}  // namespace formations
