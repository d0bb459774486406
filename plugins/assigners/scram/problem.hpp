// SPDX-License-Identifier: MIT
// A problem of SCRAM, ready to be solved: n robots, k <= n tasks that are all to be taken, and the place of every cost
// in the order of costs. MacAlpine, Price and Stone, "SCRAM: Scalable Collision-avoiding Role Assignment with
// Minimal-makespan for Formational Positioning", AAAI 2015.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "../shortest_paths.hpp"

namespace scram {

using assignment::infinity, assignment::nobody;

// What is to be least: first the largest cost of a pair. Then
//   mmdr      the second largest, and so on (Minimum Maximal Distance Recursive);
//   mmd_msd2  the sum of the costs, which are squared distances (Minimum Maximal Distance + Minimum Sum Distance^2).
enum class Criterion { mmdr, mmd_msd2 };

// Costs that differ by no more than this share of the larger one are equal: they differ by rounding only.
inline constexpr double tie_tolerance = 1e-9;

// Task-major: pair (task, robot) is element task * robots + robot. Tasks stand in order of importance.
struct Problem {
  static constexpr std::uint32_t forbidden = std::numeric_limits<std::uint32_t>::max();

  std::size_t tasks = 0, robots = 0;
  std::vector<double> cost;         // infinity: forbidden
  std::vector<std::uint32_t> rank;  // from 1; equal costs have equal ranks; `forbidden` where the pair is

  void reserve(std::size_t most_robots, std::size_t most_tasks) {
    const std::size_t pairs = most_robots * most_tasks;
    cost.reserve(pairs);
    rank.reserve(pairs);
    sorted_.reserve(pairs);
    cost_of_rank_.reserve(pairs + 1);
  }

  // Numbers the costs. A chain of equals counts as equal.
  void set_ranks() {
    sorted_.clear();
    rank.assign(cost.size(), forbidden);
    for (std::size_t pair = 0; pair < cost.size(); ++pair) {
      if (cost[pair] != infinity) sorted_.push_back({cost[pair], static_cast<std::uint32_t>(pair)});
    }
    std::sort(sorted_.begin(), sorted_.end(), [](const Sorted& a, const Sorted& b) { return a.cost < b.cost; });
    cost_of_rank_.assign(1, -infinity);
    for (const Sorted& each : sorted_) {
      double& last = cost_of_rank_.back();
      if (each.cost - last <= tie_tolerance * std::max(std::abs(each.cost), std::abs(last)) && last != -infinity) {
        last = each.cost;
      } else {
        cost_of_rank_.push_back(each.cost);
      }
      rank[each.pair] = static_cast<std::uint32_t>(cost_of_rank_.size() - 1);
    }
  }
  // The largest cost of this rank.
  double cost_of_rank(std::uint32_t each) const { return cost_of_rank_[each]; }

 private:
  struct Sorted {
    double cost;
    std::uint32_t pair;
  };
  std::vector<Sorted> sorted_;
  std::vector<double> cost_of_rank_;
};

}  // namespace scram
