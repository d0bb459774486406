// SPDX-License-Identifier: MIT
#include "mind/coordination/least_cost_assignment.hpp"

#include <cassert>
#include <limits>

namespace regista::mind {

void LeastCostAssignment::reserve(std::size_t rows, std::size_t columns) {
  row_price_.reserve(rows + 1);
  for (std::vector<double>* each : {&column_price_, &slack_}) each->reserve(columns + 1);
  for (std::vector<std::size_t>* each : {&row_of_, &before_, &result_}) each->reserve(columns + 1);
  visited_.reserve(columns + 1);
}

// Rows enter one by one; each pushes others along
// the path that costs least by the prices so far.
double LeastCostAssignment::solve(std::span<const double> costs, std::size_t rows, std::size_t columns) {
  assert(rows <= columns && costs.size() == rows * columns);
  row_price_.assign(rows + 1, 0.0);
  column_price_.assign(columns + 1, 0.0);
  row_of_.assign(columns + 1, 0);
  before_.assign(columns + 1, 0);
  for (std::size_t entering = 1; entering <= rows; ++entering) {
    slack_.assign(columns + 1, std::numeric_limits<double>::infinity());
    visited_.assign(columns + 1, 0);
    row_of_[0] = entering;
    std::size_t column = 0;
    do {
      visited_[column] = 1;
      const std::size_t row = row_of_[column];
      double least = std::numeric_limits<double>::infinity();
      std::size_t next = 0;
      for (std::size_t other = 1; other <= columns; ++other) {
        if (visited_[other] != 0) continue;
        const double reduced = costs[(row - 1) * columns + other - 1] - row_price_[row] - column_price_[other];
        if (reduced < slack_[other]) {
          slack_[other] = reduced;
          before_[other] = column;
        }
        if (slack_[other] < least) {
          least = slack_[other];
          next = other;
        }
      }
      for (std::size_t other = 0; other <= columns; ++other) {
        if (visited_[other] != 0) {
          row_price_[row_of_[other]] += least;
          column_price_[other] -= least;
        } else {
          slack_[other] -= least;
        }
      }
      column = next;
    } while (row_of_[column] != 0);
    while (column != 0) {
      row_of_[column] = row_of_[before_[column]];
      column = before_[column];
    }
  }
  double sum = 0.0;
  result_.assign(columns, none);
  for (std::size_t column = 1; column <= columns; ++column) {
    if (row_of_[column] == 0) continue;
    result_[column - 1] = row_of_[column] - 1;
    sum += costs[(row_of_[column] - 1) * columns + column - 1];
  }
  return sum;
}

}  // namespace regista::mind
