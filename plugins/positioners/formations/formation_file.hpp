// SPDX-License-Identifier: MIT
// Formation files of librcsc, as HELIOS base and other teams of the 2D simulation league publish them, in JSON:
//   "method": "DelaunayTriangulation", or "Static" with one sample;
//   "role": [{"number": 1, "name": "Goalie", ...}, ...];
//   "data": [{"ball": {"x": 0, "y": 0}, "1": {"x": -50, "y": 0}, ..., "11": {...}}, ...]
// in metres, origin at the centre, x towards the opponent's goal and y to the RIGHT; other members are ignored. Or in
// the older text forms (formation_text.hpp), which hold the same.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formation.hpp"

namespace formations {

inline constexpr std::size_t most_bytes = 4'000'000, most_samples = 1000, most_positions = 64;
inline constexpr double farthest = 1000.0;  // m

// Samples in the file's order, turned to y left. Balls are rounded to the grid. Throws std::invalid_argument: one line
// that begins with "formation: " and says where it is wrong and what is missing.
std::vector<Sample> read_formation(std::string_view bytes);

// --- What both forms have in common.

[[noreturn]] void refuse(const std::string& message);
std::string place(std::size_t line, std::size_t column);  // "line 2, column 12"

// What is read, and of a method that is not: "its method is ...".
enum class Method { delaunay_triangulation, fixed };
Method method_of(std::string_view name, const std::string& where);

// Both throw for what is farther than `farthest`.
Position position_at(double x, double right, const std::string& where);
Sample sample_at(double x, double right, const std::string& where);  // its ball; no positions yet

// names: of each sample, for the message.
void refuse_repeated_balls(const std::vector<Sample>& samples, std::span<const std::string> names);

}  // namespace formations
