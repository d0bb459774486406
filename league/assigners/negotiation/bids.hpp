// SPDX-License-Identifier: MIT
// Utilities as the whole numbers that robots tell each other: what is compared is equal for all who have heard the
// same, and ties are ties.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <regista/frame.hpp>

namespace negotiation {

// A utility in steps of `step`, rounded, at most `most`. Utilities are finite and >= 0.
inline std::uint32_t in_steps(double utility, double step, std::uint32_t most) {
  return static_cast<std::uint32_t>(std::clamp(std::round(utility / step), 0.0, static_cast<double>(most)));
}

// Whether a bid beats another one: the higher, and of equal ones that of the lower number.
constexpr bool beats(std::uint32_t bid, int number, std::uint32_t other_bid, int other_number) {
  return bid != other_bid ? bid > other_bid : number < other_number;
}

// Row of a robot in the matrices of a decision; the number of rows when it does not play.
inline std::size_t row_of(const regista::Span<std::int32_t>& active, int number) {
  std::size_t row = 0;
  while (row < active.size() && active[row] != number) ++row;
  return row;
}

// Column of a task; the number of columns when it is not among them.
inline std::size_t column_of(const regista::Span<regista::Task>& tasks, int id) {
  std::size_t column = 0;
  while (column < tasks.size() && tasks[column].id != id) ++column;
  return column;
}

}  // namespace negotiation
