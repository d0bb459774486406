// SPDX-License-Identifier: MIT
// Of all pairs of a free row and a free column, takes the one of the highest value, again and again, until none is
// left. Knows nothing of Regista, so that it can be tested and used alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

class BestPairFirst {
 public:
  static constexpr double forbidden = -std::numeric_limits<double>::infinity();

  // value(row, column): finite, or `forbidden`. Writes to choice[row] its column; a row without one keeps what it had.
  // Pairs below `at_least` are not taken. Ties go to the lowest row, then the lowest column.
  template <class Value, class Choice>
  void solve(std::size_t rows, std::size_t columns, const Value& value, double at_least, Choice&& choice) {
    row_taken_.assign(rows, 0);
    column_taken_.assign(columns, 0);
    for (;;) {
      double best = forbidden;
      std::size_t best_row = 0, best_column = 0;
      for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
          if (row_taken_[row] || column_taken_[column]) continue;
          const double v = value(row, column);
          if (v >= at_least && v > best) {
            best = v;
            best_row = row;
            best_column = column;
          }
        }
      }
      if (best == forbidden) return;
      row_taken_[best_row] = column_taken_[best_column] = 1;
      choice[best_row] = static_cast<std::int32_t>(best_column);
    }
  }

 private:
  std::vector<char> row_taken_, column_taken_;  // kept, so that only the first call allocates
};
