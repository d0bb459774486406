// SPDX-License-Identifier: MIT
// Which tasks are done when not all can be: each one that can be done in addition to those before it. Sets of tasks
// that can all be done at once form a matroid, so that no other choice does more tasks, and whom a task went to on the
// way makes no difference.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "matrix.hpp"

namespace assignment {

// Reuse one object: it keeps its memory.
class TaskChoice {
 public:
  void reserve(std::size_t robots, std::size_t tasks) {
    taken_by_.reserve(robots);
    seen_.reserve(robots);
    chosen_.reserve(tasks);
  }

  // values: `excluded` where a pair is forbidden. order: every column once, the one that matters most first.
  void choose(const Matrix& values, double excluded, std::span<const std::uint32_t> order) {
    assert(order.size() == values.columns);
    chosen_.assign(values.columns, 0);
    taken_by_.assign(values.rows, free);
    std::size_t count = 0;
    for (const std::uint32_t column : order) {
      if (count == values.rows) return;
      seen_.assign(values.rows, 0);
      if (!find_robot(values, excluded, column)) continue;
      chosen_[column] = 1;
      ++count;
    }
  }
  bool has(std::size_t column) const { return chosen_[column] != 0; }

 private:
  static constexpr std::size_t free = std::numeric_limits<std::size_t>::max();

  // A robot without a task, or one whose task another robot can take over, and so on.
  bool find_robot(const Matrix& values, double excluded, std::size_t column) {
    for (std::size_t row = 0; row < values.rows; ++row) {
      if (taken_by_[row] != free || values(row, column) == excluded) continue;
      taken_by_[row] = column;
      return true;
    }
    for (std::size_t row = 0; row < values.rows; ++row) {
      if (seen_[row] != 0 || values(row, column) == excluded) continue;
      seen_[row] = 1;
      if (!find_robot(values, excluded, taken_by_[row])) continue;
      taken_by_[row] = column;
      return true;
    }
    return false;
  }

  std::vector<std::size_t> taken_by_;  // column
  std::vector<std::uint8_t> seen_, chosen_;
};

}  // namespace assignment
