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
    for (auto* values : {&cost, &levels_}) values->reserve(most_robots * most_tasks);
    rank.reserve(most_robots * most_tasks);
  }

  // Numbers the costs. A chain of equals counts as equal.
  void set_ranks() {
    levels_.clear();
    for (const double each : cost) {
      if (each != infinity) levels_.push_back(each);
    }
    std::sort(levels_.begin(), levels_.end());
    // Keep the largest of each group.
    std::size_t groups = 0;
    for (const double each : levels_) {
      const bool same = groups > 0 && each - levels_[groups - 1] <=
                                          tie_tolerance * std::max(std::abs(each), std::abs(levels_[groups - 1]));
      if (!same) ++groups;
      levels_[groups - 1] = each;
    }
    rank.resize(cost.size());
    const auto last = levels_.begin() + static_cast<std::ptrdiff_t>(groups);
    for (std::size_t k = 0; k < cost.size(); ++k) {
      rank[k] =
          cost[k] == infinity
              ? forbidden
              : static_cast<std::uint32_t>(std::lower_bound(levels_.begin(), last, cost[k]) - levels_.begin()) + 1;
    }
  }
  // The largest cost of this rank.
  double cost_of_rank(std::uint32_t each) const { return levels_[each - 1]; }

 private:
  std::vector<double> levels_;
};

}  // namespace scram
