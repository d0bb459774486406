// SPDX-License-Identifier: MIT
// Phi of the paper (Affinita et al. 2023, "Distributed Task Assignment"): the roles in order of importance, each to the
// free robot with the largest utility for it; of equal robots the one with the lowest number.
//
// Every column finds a robot as long as a free one may take it, so a row that stays empty has no allowed column left:
// no second round is needed. The pairing is maximal, not always of maximum cardinality.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

#include "../matrix.hpp"

namespace greedy {

using assignment::forbidden, assignment::Matrix;

// utilities: finite or `forbidden`. order: every column once, the most important first. Writes a column to out[row], or
// leaves it as it is: out comes in with a negative number for every row.
inline void assign(const Matrix& utilities, std::span<const std::uint32_t> order, std::span<std::int32_t> out) {
  assert(order.size() == utilities.columns && out.size() == utilities.rows);
  for (const std::uint32_t column : order) {
    double best = forbidden;
    std::size_t winner = utilities.rows;
    for (std::size_t row = 0; row < utilities.rows; ++row) {
      if (out[row] < 0 && utilities(row, column) > best) {
        best = utilities(row, column);
        winner = row;
      }
    }
    if (winner < utilities.rows) out[winner] = static_cast<std::int32_t>(column);
  }
}

}  // namespace greedy
