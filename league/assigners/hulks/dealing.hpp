// SPDX-License-Identifier: MIT
// All tasks but the striker's, by number: the lowest keeps the goal, the others take the other tasks in the order of
// their importance. Who is missing is moved up for, so that the least important tasks stay open.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

#include <plugins/assigners/matrix.hpp>

namespace hulks {

using assignment::forbidden, assignment::Matrix;

// utilities: forbidden pairs are not dealt; nothing else of them counts. order: columns that are to be dealt, in this
// order, each once. out[row]: rows with a negative number other than -1 get nothing, rows with a column keep it, and
// rows with -1 get the first column of `order` that nobody has and that they may take.
inline void deal(const Matrix& utilities, std::span<const std::uint32_t> order, std::span<std::int32_t> out) {
  assert(out.size() == utilities.rows);
  for (std::size_t row = 0; row < utilities.rows; ++row) {
    if (out[row] != -1) continue;
    for (const std::uint32_t column : order) {
      const auto taken = static_cast<std::int32_t>(column);
      if (utilities(row, column) == forbidden || std::find(out.begin(), out.end(), taken) != out.end()) continue;
      out[row] = taken;
      break;
    }
  }
}

// Changes an order by importance into that of dealing: without the column `striker`, and with `keeper` in front. Either
// may be -1, for none. Returns what is left of `order`.
inline std::span<const std::uint32_t> order_of_dealing(std::span<std::uint32_t> order, std::int32_t keeper,
                                                       std::int32_t striker) {
  const auto end = std::remove(order.begin(), order.end(), static_cast<std::uint32_t>(striker));
  const auto front = std::find(order.begin(), end, static_cast<std::uint32_t>(keeper));
  if (front != end) std::rotate(order.begin(), front, front + 1);
  return {order.begin(), end};
}

}  // namespace hulks
