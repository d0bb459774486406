// SPDX-License-Identifier: MIT
// SCRAM (MacAlpine, Price and Stone, AAAI 2015) for any numbers of robots and tasks: which tasks are taken, then who
// takes them by enumeration.hpp or polynomial.hpp.
//
// The paper has as many positions as agents. Here, with more tasks than robots, the less important ones are left open,
// as in the team's formations (MacAlpine, Barrera and Stone 2012), and where pairs are forbidden a task is taken when
// it can be in addition to the more important ones (../choose_tasks.hpp). With fewer tasks than robots, those robots
// stay free that leave the best assignment.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../choose_tasks.hpp"
#include "../matrix.hpp"
#include "enumeration.hpp"
#include "polynomial.hpp"
#include "problem.hpp"

namespace scram {

using assignment::Matrix;

// automatic: enumeration for at most seven robots.
enum class Method { automatic, enumeration, polynomial };

// Reuse one object: it keeps its memory, and allocates only for a matrix larger than any before.
class Solver {
 public:
  void reserve(std::size_t rows, std::size_t columns) {
    problem_.reserve(rows, columns);
    polynomial_.reserve(rows, columns);
    choice_.reserve(rows, columns);
    robot_of_.reserve(std::max(rows, columns));
    kept_.reserve(columns);
  }

  // costs: finite, or infinity where a pair is forbidden. order: every column once, the most important first; ties go
  // to the lowest robot for the first column, and so on. choice: every column once; which tasks are taken when not all
  // can be. out[row] := column, or -1.
  void assign(const Matrix& costs, Criterion criterion, std::span<const std::uint32_t> order,
              std::span<const std::uint32_t> choice, std::span<std::int32_t> out, Method method = Method::automatic) {
    assert(order.size() == costs.columns && choice.size() == costs.columns && out.size() == costs.rows);
    std::fill(out.begin(), out.end(), nobody);
    choice_.choose(costs, infinity, choice);
    kept_.clear();
    for (const std::uint32_t column : order) {
      if (choice_.has(column)) kept_.push_back(column);
    }
    if (kept_.empty()) return;
    problem_.tasks = kept_.size();
    problem_.robots = costs.rows;
    problem_.cost.clear();
    for (const std::uint32_t column : kept_) {
      for (std::size_t row = 0; row < costs.rows; ++row) problem_.cost.push_back(costs(row, column));
    }
    problem_.set_ranks();
    robot_of_.resize(kept_.size());
    const bool few = costs.rows <= Enumeration::most_robots;
    if (method == Method::enumeration || (method == Method::automatic && few)) {
      enumeration_.solve(problem_, criterion, robot_of_);
    } else {
      polynomial_.solve(problem_, criterion, robot_of_);
    }
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      out[static_cast<std::size_t>(robot_of_[k])] = static_cast<std::int32_t>(kept_[k]);
    }
  }

 private:
  Problem problem_;
  Enumeration enumeration_;
  Polynomial polynomial_;
  assignment::TaskChoice choice_;
  std::vector<std::int32_t> robot_of_;
  std::vector<std::uint32_t> kept_;
};

}  // namespace scram
