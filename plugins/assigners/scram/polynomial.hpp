// SPDX-License-Identifier: MIT
// SCRAM for teams of any size, in polynomial time.
//
// MMDR, after the O(n^4) algorithm of the paper (Sokkalingam and Aneja, "Lexicographic bottleneck combinatorial
// problems", Operations Research Letters 23, 1998): find the largest cost that cannot be avoided; by an assignment with
// costs 1 for pairs of that cost and 0 for cheaper ones, find how often it is needed at least, and drop all pairs that
// no such assignment uses (reduced cost > 0). What is left of the largest cost is settled; go on with the next. Each
// round starts from the assignment of the one before and repairs only the pairs of the largest cost.
//
// MMD+MSD2: the same search down to the largest cost that cannot be avoided; then the least sum without dearer pairs.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "../shortest_paths.hpp"
#include "../tie_rule.hpp"
#include "../tight_pairs.hpp"
#include "problem.hpp"

namespace scram {

class Polynomial {
 public:
  void reserve(std::size_t robots, std::size_t tasks) {
    const std::size_t longer = std::max(robots, tasks);
    costs_.reserve(longer * longer);
    level_.reserve(longer * longer);
    sums_.reserve(longer, longer);
    rounds_.reserve(longer, longer);
    ties_.reserve(longer, longer);
    order_.reserve(longer);
    task_of_.reserve(longer);
  }

  // The problem can be solved. robot_of[task] := robot.
  void solve(const Problem& problem, Criterion criterion, std::span<std::int32_t> robot_of) {
    assert(problem.tasks <= problem.robots && robot_of.size() == problem.tasks);
    order_.resize(problem.tasks);
    std::iota(order_.begin(), order_.end(), 0u);
    criterion == Criterion::mmdr ? mmdr(problem, robot_of) : mmd_msd2(problem, robot_of);
  }

 private:
  static constexpr std::uint32_t settled = 0, dropped = Problem::forbidden;

  // Robots without a task do one of n - k more, which cost nothing: so the pairs that are left form a square, and which
  // robots may stay free is one of the things that rounds settle.
  void mmdr(const Problem& problem, std::span<std::int32_t> robot_of) {
    const std::size_t n = problem.robots, k = problem.tasks;
    level_.assign(n * n, settled);
    std::copy(problem.rank.begin(), problem.rank.end(), level_.begin());
    start(n, n);
    while (const std::uint32_t level = largest_level(n, n)) {
      if (round(n, n, level)) settle(n, level);
    }
    ties_.begin(n, k);
    for (std::size_t robot = 0; robot < n; ++robot) {
      for (std::size_t task = 0; task < k; ++task) {
        if (level_[task * n + robot] == settled) ties_.tight(robot, task);
      }
      if (k < n && level_[k * n + robot] == settled) ties_.row_may_stay_free(robot);
    }
    finish(rounds_.object_of, rounds_.agent_of, k, robot_of);
  }

  void mmd_msd2(const Problem& problem, std::span<std::int32_t> robot_of) {
    const std::size_t n = problem.robots, k = problem.tasks;
    level_.assign(problem.rank.begin(), problem.rank.end());
    costs_.assign(problem.cost.begin(), problem.cost.end());
    [[maybe_unused]] const bool complete = sums_.solve({costs_.data(), k, n});
    assert(complete);
    rounds_ = sums_;
    const std::uint32_t at_first = largest_level(k, n);
    std::uint32_t bottleneck = at_first;
    while (!round(k, n, bottleneck)) bottleneck = largest_level(k, n);
    for (std::size_t pair = 0; pair < n * k; ++pair) {
      costs_[pair] = level_[pair] > bottleneck ? infinity : problem.cost[pair];
    }
    const assignment::Costs costs{costs_.data(), k, n};
    if (bottleneck < at_first) sums_.solve(costs);  // else the least sum needs no dearer pair anyway
    assignment::name_tight_pairs(sums_, costs, true, tie_tolerance * std::abs(problem.cost_of_rank(bottleneck)), ties_);
    finish(sums_.object_of, sums_.agent_of, k, robot_of);
  }

  // Any complete assignment; few of its pairs have a high level.
  void start(std::size_t agents, std::size_t objects) {
    costs_.resize(agents * objects);
    for (std::size_t pair = 0; pair < costs_.size(); ++pair) {
      const double level = level_[pair];
      costs_[pair] = level_[pair] == dropped ? infinity : level * level;
    }
    [[maybe_unused]] const bool complete = rounds_.solve({costs_.data(), agents, objects});
    assert(complete);
  }

  std::uint32_t largest_level(std::size_t agents, std::size_t objects) const {
    std::uint32_t largest = settled;
    for (std::size_t agent = 0; agent < agents; ++agent) {
      largest = std::max(largest, level_[agent * objects + static_cast<std::size_t>(rounds_.object_of[agent])]);
    }
    return largest;
  }

  // An assignment without pairs above `level` and with as few of that level as can be; whether it needs any.
  bool round(std::size_t agents, std::size_t objects, std::uint32_t level) {
    for (std::size_t pair = 0; pair < agents * objects; ++pair) {
      costs_[pair] = level_[pair] < level ? 0.0 : level_[pair] == level ? 1.0 : infinity;
    }
    for (std::size_t agent = 0; agent < agents; ++agent) {
      const auto object = static_cast<std::size_t>(rounds_.object_of[agent]);
      if (level_[agent * objects + object] != level) continue;
      rounds_.object_of[agent] = nobody;
      rounds_.agent_of[object] = nobody;
    }
    [[maybe_unused]] const bool complete = rounds_.solve_on({costs_.data(), agents, objects});
    assert(complete);
    return largest_level(agents, objects) == level;
  }

  void settle(std::size_t n, std::uint32_t level) {
    for (std::size_t agent = 0; agent < n; ++agent) {
      for (std::size_t object = 0; object < n; ++object) {
        const std::size_t pair = agent * n + object;
        const double reduced = costs_[pair] - rounds_.agent_dual[agent] - rounds_.object_dual[object];
        if (reduced > 0.5) {  // all are whole numbers
          level_[pair] = dropped;
        } else if (level_[pair] == level) {
          level_[pair] = settled;
        }
      }
    }
  }

  // Of all optimal assignments the lexicographically least.
  void finish(std::vector<std::int32_t>& robots, std::vector<std::int32_t>& tasks, std::size_t k,
              std::span<std::int32_t> robot_of) {
    std::copy_n(robots.begin(), k, robot_of.begin());
    task_of_.assign(tasks.begin(), tasks.end());
    for (std::int32_t& task : task_of_) {
      if (task >= static_cast<std::int32_t>(k)) task = nobody;
    }
    ties_.apply(order_, task_of_, robot_of);
  }

  std::vector<double> costs_;
  std::vector<std::uint32_t> level_, order_;
  assignment::ShortestPaths<double> sums_, rounds_;
  assignment::TieRule ties_;
  std::vector<std::int32_t> task_of_;
};

}  // namespace scram
