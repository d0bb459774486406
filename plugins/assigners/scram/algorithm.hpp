// SPDX-License-Identifier: MIT
// SCRAM (MacAlpine, Price and Stone, AAAI 2015) for any numbers of robots and tasks: which tasks are taken, then who
// takes them by enumeration.hpp or polynomial.hpp.
//
// The paper has as many positions as agents. Here, with more tasks than robots, the less important ones are left open,
// as in the team's formations (MacAlpine, Barrera and Stone 2012), and where pairs are forbidden a task is taken when
// it can be in addition to the more important ones (these sets form a matroid, so that as many tasks as possible are
// taken). With fewer tasks than robots, those robots stay free that leave the best assignment.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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
    for (auto* each : {&chosen_by_, &robot_of_}) each->reserve(std::max(rows, columns));
    seen_.reserve(rows);
    taken_.reserve(columns);
    kept_.reserve(columns);
  }

  // costs: finite, or infinity where a pair is forbidden. order: every column once, the most important first; ties go
  // to the lowest robot for the first column, and so on. choice: every column once; which tasks are taken when not all
  // can be. out[row] := column, or -1.
  void assign(const Matrix& costs, Criterion criterion, std::span<const std::uint32_t> order,
              std::span<const std::uint32_t> choice, std::span<std::int32_t> out, Method method = Method::automatic) {
    assert(order.size() == costs.columns && choice.size() == costs.columns && out.size() == costs.rows);
    std::fill(out.begin(), out.end(), nobody);
    choose_tasks(costs, choice);
    kept_.clear();
    for (const std::uint32_t column : order) {
      if (taken_[column] != 0) kept_.push_back(column);
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
  void choose_tasks(const Matrix& costs, std::span<const std::uint32_t> choice) {
    taken_.assign(costs.columns, 0);
    chosen_by_.assign(costs.rows, nobody);
    std::size_t count = 0;
    for (const std::uint32_t column : choice) {
      if (count == costs.rows) return;
      seen_.assign(costs.rows, 0);
      if (!find_robot(costs, column)) continue;
      taken_[column] = 1;
      ++count;
    }
  }

  // A free robot for the column, or one whose task another robot can take over, and so on.
  bool find_robot(const Matrix& costs, std::size_t column) {
    for (std::size_t row = 0; row < costs.rows; ++row) {
      if (chosen_by_[row] != nobody || costs(row, column) == infinity) continue;
      chosen_by_[row] = static_cast<std::int32_t>(column);
      return true;
    }
    for (std::size_t row = 0; row < costs.rows; ++row) {
      if (seen_[row] != 0 || costs(row, column) == infinity) continue;
      seen_[row] = 1;
      if (!find_robot(costs, static_cast<std::size_t>(chosen_by_[row]))) continue;
      chosen_by_[row] = static_cast<std::int32_t>(column);
      return true;
    }
    return false;
  }

  Problem problem_;
  Enumeration enumeration_;
  Polynomial polynomial_;
  std::vector<std::int32_t> chosen_by_, robot_of_;
  std::vector<std::uint8_t> seen_, taken_;
  std::vector<std::uint32_t> kept_;
};

}  // namespace scram
