// SPDX-License-Identifier: MIT
// Assignment by largest regret: the robot that would lose most by getting its second best task goes first (Vogel's idea
// for transport problems: Reinfeld and Vogel, "Mathematical Programming", 1958). Again and again, among the robots and
// tasks that are still free, the robot with the largest difference between its best and its second best utility takes
// its best task. A robot that may take only one more task regrets without bound.
//
// Equal regret: the larger utility goes first, then the more important task, then the lower robot. Of a robot's equal
// tasks the more important one is its best. O(rows^2 * columns) at worst; a robot looks again only when one of its two
// best was taken.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "../matrix.hpp"

namespace regret {

using assignment::forbidden, assignment::Matrix;

// Reuse one object: it keeps its memory, and allocates only for more rows or columns than any before.
class Solver {
 public:
  void reserve(std::size_t rows, std::size_t columns) {
    wishes_.reserve(rows);
    free_.reserve(columns);
  }

  // utilities: finite or `forbidden`. order: every column once, the most important first. out[row] := column, or -1.
  void assign(const Matrix& utilities, std::span<const std::uint32_t> order, std::span<std::int32_t> out) {
    assert(order.size() == utilities.columns && out.size() == utilities.rows);
    free_.assign(order.begin(), order.end());
    wishes_.resize(utilities.rows);
    for (std::size_t row = 0; row < utilities.rows; ++row) {
      out[row] = -1;
      look(utilities, row);
    }
    while (true) {
      std::size_t first = utilities.rows;
      for (std::size_t row = 0; row < utilities.rows; ++row) {
        if (out[row] < 0 && wishes_[row].best_place != nothing &&
            (first == utilities.rows || goes_before(wishes_[row], wishes_[first]))) {
          first = row;
        }
      }
      if (first == utilities.rows) return;
      const std::size_t place = wishes_[first].best_place;
      out[first] = static_cast<std::int32_t>(free_[place]);
      free_[place] = taken;
      for (std::size_t row = 0; row < utilities.rows; ++row) {
        const Wish& wish = wishes_[row];
        if (out[row] < 0 && (wish.best_place == place || wish.second_place == place)) look(utilities, row);
      }
    }
  }

 private:
  static constexpr std::size_t nothing = std::numeric_limits<std::size_t>::max();
  static constexpr std::uint32_t taken = std::numeric_limits<std::uint32_t>::max();

  // Places in the order of importance.
  struct Wish {
    std::size_t best_place = nothing, second_place = nothing;
    double best = forbidden, regret = 0.0;
  };

  static bool goes_before(const Wish& a, const Wish& b) {
    if (a.regret != b.regret) return a.regret > b.regret;
    return a.best != b.best ? a.best > b.best : a.best_place < b.best_place;
  }

  void look(const Matrix& utilities, std::size_t row) {
    Wish wish;
    double second = forbidden;
    for (std::size_t place = 0; place < free_.size(); ++place) {
      if (free_[place] == taken) continue;
      const double value = utilities(row, free_[place]);
      if (value > wish.best) {
        second = wish.best;
        wish.second_place = wish.best_place;
        wish.best = value;
        wish.best_place = place;
      } else if (value > second) {
        second = value;
        wish.second_place = place;
      }
    }
    if (wish.best_place != nothing) wish.regret = wish.best - second;  // infinite without a second
    wishes_[row] = wish;
  }

  std::vector<Wish> wishes_;
  std::vector<std::uint32_t> free_;  // the order, taken columns crossed out
};

}  // namespace regret
