// SPDX-License-Identifier: MIT
// Roles by shirt number, whatever happens on the field: the floor that every system has to beat when little can be
// said. No robot has to know anything of another one.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

#include <plugins/assigners/matrix.hpp>

namespace static_partition {

using assignment::forbidden, assignment::Matrix;

// Robot n to the task whose place in the list of roles is n - 1, or to none when that task is not among the columns,
// or forbidden: nothing else counts of the utilities. numbers: shirt number of each row; places: place of each column,
// the most important is 0. out[row] := column, or -1. Places should differ; of equal ones the first column counts.
inline void by_number(const Matrix& utilities, std::span<const std::int32_t> numbers,
                      std::span<const std::int32_t> places, std::span<std::int32_t> out) {
  assert(numbers.size() == utilities.rows && places.size() == utilities.columns && out.size() == utilities.rows);
  for (std::size_t row = 0; row < utilities.rows; ++row) {
    out[row] = -1;
    for (std::size_t column = 0; column < utilities.columns; ++column) {
      if (places[column] != numbers[row] - 1) continue;
      if (utilities(row, column) != forbidden) out[row] = static_cast<std::int32_t>(column);
      break;
    }
  }
}

// Tasks in order of importance, each to the first row without a task that may take it: who comes behind a robot that is
// missing moves up.
inline void moving_up(const Matrix& utilities, std::span<const std::uint32_t> order, std::span<std::int32_t> out) {
  assert(order.size() == utilities.columns && out.size() == utilities.rows);
  for (std::int32_t& each : out) each = -1;
  for (const std::uint32_t column : order) {
    for (std::size_t row = 0; row < utilities.rows; ++row) {
      if (out[row] >= 0 || utilities(row, column) == forbidden) continue;
      out[row] = static_cast<std::int32_t>(column);
      break;
    }
  }
}

}  // namespace static_partition
