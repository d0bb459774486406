// SPDX-License-Identifier: MIT
#include "match/ospa.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace regista::match {

Ospa::Ospa(double cutoff, std::size_t most) : cutoff_(cutoff) {
  cost_.reserve(most * most);
  for (std::vector<double>* each : {&row_price_, &column_price_, &slack_}) each->reserve(most + 1);
  row_of_.reserve(most + 1);
  before_.reserve(most + 1);
  visited_.reserve(most + 1);
}

OspaParts Ospa::operator()(std::span<const Vector> a, std::span<const Vector> b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.empty()) return {};
  cost_.clear();
  for (const Vector& one : a) {
    for (const Vector& other : b) cost_.push_back(std::min(cutoff_, length(one - other)));
  }
  const auto count = static_cast<double>(b.size());
  return {assign(a.size(), b.size()) / count, cutoff_ * static_cast<double>(b.size() - a.size()) / count};
}

// The least sum of costs with which every row gets a column of its own. Rows enter one by one; each pushes others along
// the path that costs least by the prices so far.
double Ospa::assign(std::size_t rows, std::size_t columns) {
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
        const double reduced = cost_[(row - 1) * columns + other - 1] - row_price_[row] - column_price_[other];
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
  for (std::size_t column = 1; column <= columns; ++column) {
    if (row_of_[column] != 0) sum += cost_[(row_of_[column] - 1) * columns + column - 1];
  }
  return sum;
}

}  // namespace regista::match
