// SPDX-License-Identifier: MIT
// The assignment of roles with the largest sum of utilities. CS Freiburg tried every permutation for four robots; here
// any number of robots and tasks, by the Hungarian method, which finds the same.
//
// The publication has as many roles as robots. Our decisions: with more tasks than robots the less important ones stay
// open; where pairs are forbidden, a task is done when it can be in addition to the more important ones. Of equal sums
// the lexicographically least holds: the most important task goes to the lowest robot that can have it, and so on.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <plugins/assigners/choose_tasks.hpp>
#include <plugins/assigners/hungarian/algorithm.hpp>
#include <plugins/assigners/matrix.hpp>

namespace role_exchange {

using assignment::forbidden, assignment::Matrix, assignment::nobody;

// Reuse one object: it keeps its memory, and the last answer for as long as the question is the same, which it mostly
// is: values are those of packets and rounded.
class BestPermutation {
 public:
  void reserve(std::size_t robots, std::size_t tasks) {
    solver_.reserve(robots, tasks);
    values_.reserve(robots * tasks);
    choice_.reserve(robots, tasks);
    for (auto* each : {&kept_, &order_, &last_choice_, &last_order_}) each->reserve(tasks);
    last_values_.reserve(robots * tasks);
    last_.reserve(robots);
  }

  // utilities: finite, or `forbidden`. choice: every column once; which tasks are done when not all can be. order: the
  // same, for ties. out[robot] := column, or -1.
  void find(const Matrix& utilities, std::span<const std::uint32_t> choice, std::span<const std::uint32_t> order,
            std::span<std::int32_t> out) {
    assert(choice.size() == utilities.columns && order.size() == utilities.columns && out.size() == utilities.rows);
    if (is_the_last(utilities, choice, order)) {
      std::copy(last_.begin(), last_.end(), out.begin());
      return;
    }
    search(utilities, choice, order, out);
    last_.assign(out.begin(), out.end());
  }

 private:
  // Remembers the question if it is another one.
  bool is_the_last(const Matrix& utilities, std::span<const std::uint32_t> choice,
                   std::span<const std::uint32_t> order) {
    assert(utilities.stride == utilities.columns);
    const std::span<const double> values(utilities.values, utilities.rows * utilities.columns);
    if (last_.size() == utilities.rows && std::ranges::equal(last_values_, values) &&
        std::ranges::equal(last_choice_, choice) && std::ranges::equal(last_order_, order)) {
      return true;
    }
    last_values_.assign(values.begin(), values.end());
    last_choice_.assign(choice.begin(), choice.end());
    last_order_.assign(order.begin(), order.end());
    return false;
  }

  void search(const Matrix& utilities, std::span<const std::uint32_t> choice, std::span<const std::uint32_t> order,
              std::span<std::int32_t> out) {
    std::fill(out.begin(), out.end(), nobody);
    choice_.choose(utilities, forbidden, choice);
    kept_.clear();
    for (const std::uint32_t column : order) {
      if (choice_.has(column)) kept_.push_back(column);
    }
    if (kept_.empty()) return;
    values_.clear();
    for (std::size_t row = 0; row < utilities.rows; ++row) {
      for (const std::uint32_t column : kept_) values_.push_back(utilities(row, column));
    }
    order_.clear();
    for (std::size_t k = 0; k < kept_.size(); ++k) order_.push_back(static_cast<std::uint32_t>(k));
    solver_.assign({values_.data(), utilities.rows, kept_.size(), kept_.size()}, order_, out);
    for (std::int32_t& column : out) {
      if (column != nobody) column = static_cast<std::int32_t>(kept_[static_cast<std::size_t>(column)]);
    }
  }

  hungarian::Solver solver_;
  std::vector<double> values_, last_values_;
  assignment::TaskChoice choice_;
  std::vector<std::uint32_t> kept_, order_, last_choice_, last_order_;
  std::vector<std::int32_t> last_;
};

}  // namespace role_exchange
