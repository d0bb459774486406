// SPDX-License-Identifier: MIT
// A table of numbers of every team (row) against every team (column).
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

namespace regista::statistics {

class SquareTable {
 public:
  explicit SquareTable(std::size_t teams) : teams_(teams), values_(teams * teams, 0.0) {}

  std::size_t teams() const { return teams_; }
  double& at(std::size_t row, std::size_t column) { return values_[index(row, column)]; }
  double at(std::size_t row, std::size_t column) const { return values_[index(row, column)]; }

 private:
  std::size_t index(std::size_t row, std::size_t column) const {
    assert(row < teams_ && column < teams_);
    return row * teams_ + column;
  }
  std::size_t teams_;
  std::vector<double> values_;
};

}  // namespace regista::statistics
