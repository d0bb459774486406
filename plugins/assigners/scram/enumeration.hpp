// SPDX-License-Identifier: MIT
// SCRAM for small teams by dynamic programming over sets of robots: the best way to give the remaining, less important
// tasks to the robots that are still free. It sees every assignment, 2^(n-1) * n costs in all, as in MacAlpine, Barrera
// and Stone, "Positioning to Win: A Dynamic Role Assignment and Formation Positioning System", RoboCup 2012.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "problem.hpp"

namespace scram {

class Enumeration {
 public:
  static constexpr std::size_t most_robots = 7;

  // The problem can be solved. robot_of[task] := robot.
  void solve(const Problem& problem, Criterion criterion, std::span<std::int32_t> robot_of) {
    assert(problem.robots <= most_robots && problem.tasks <= problem.robots);
    if (criterion == Criterion::mmdr) {
      find_values(problem, sorted_, with_rank, std::uint32_t{Problem::forbidden - 1});
      choose(problem, robot_of, [&](std::size_t pair, unsigned before, unsigned after) {
        return problem.rank[pair] != Problem::forbidden && sorted_[after] != none<std::uint64_t> &&
               with_rank(problem, pair, sorted_[after]) == sorted_[before];
      });
    } else {
      find_values(
          problem, largest_,
          [](const Problem& p, std::size_t pair, std::uint32_t rest) { return std::max(p.rank[pair], rest); },
          std::uint32_t{Problem::forbidden - 1});
      const std::uint32_t bottleneck = largest_[0];
      find_values(problem, sum_, with_cost, bottleneck);
      const double most = sum_[0] + tie_tolerance * std::abs(problem.cost_of_rank(bottleneck));
      double spent = 0.0;
      choose(problem, robot_of, [&](std::size_t pair, unsigned, unsigned after) {
        if (problem.rank[pair] > bottleneck || sum_[after] == none<double>) return false;
        const double total = spent + problem.cost[pair];
        if (total + sum_[after] > most) return false;
        spent = total;
        return true;
      });
    }
  }

 private:
  template <class Value>
  static constexpr Value none = std::numeric_limits<Value>::max();
  static constexpr std::size_t sets = std::size_t{1} << most_robots;

  // Ranks of the remaining pairs, a byte each, the largest in the highest: they compare as numbers. One more is put in
  // its place; bytes that are larger keep theirs.
  static std::uint64_t with_rank(const Problem& problem, std::size_t pair, std::uint64_t rest) {
    static_assert(most_robots * most_robots < 128 && most_robots < 8);
    constexpr std::uint64_t ones = 0x0101010101010101u, tops = 0x8080808080808080u;
    const std::uint64_t rank = problem.rank[pair];
    const std::uint64_t is_larger = (((rest | tops) - ones * (rank + 1)) & tops) >> 7;  // 1 or 0 in each byte
    const auto larger = static_cast<unsigned>(is_larger * ones >> 56);                  // their sum
    const std::uint64_t below = ~std::uint64_t{0} >> (8 * larger);
    return (rest & ~below) | rank << (56 - 8 * larger) | (rest & below) >> 8;
  }
  static double with_cost(const Problem& problem, std::size_t pair, double rest) { return problem.cost[pair] + rest; }

  // values[set]: the best for the tasks that are left when the robots of the set have taken the first ones.
  template <class Value, class Combine>
  static void find_values(const Problem& problem, std::array<Value, sets>& values, const Combine& combine,
                          std::uint32_t largest_rank) {
    const unsigned all = (1u << problem.robots) - 1u;
    for (unsigned set = all + 1; set-- > 0;) {
      const auto task = static_cast<std::size_t>(std::popcount(set));
      if (task >= problem.tasks) {
        values[set] = Value{};
        continue;
      }
      Value best = none<Value>;
      for (unsigned open = all & ~set; open != 0; open &= open - 1) {
        const std::size_t pair = task * problem.robots + static_cast<std::size_t>(std::countr_zero(open));
        const Value rest = values[set | (open & -open)];
        if (problem.rank[pair] > largest_rank || rest == none<Value>) continue;
        best = std::min(best, combine(problem, pair, rest));
      }
      values[set] = best;
    }
  }

  // Task by task the lowest robot that is as good as the best.
  template <class IsBest>
  static void choose(const Problem& problem, std::span<std::int32_t> robot_of, const IsBest& is_best) {
    unsigned set = 0;
    for (std::size_t task = 0; task < problem.tasks; ++task) {
      for (std::size_t robot = 0; robot < problem.robots; ++robot) {
        const unsigned after = set | 1u << robot;
        if (after == set || !is_best(task * problem.robots + robot, set, after)) continue;
        robot_of[task] = static_cast<std::int32_t>(robot);
        set = after;
        break;
      }
    }
    assert(static_cast<std::size_t>(std::popcount(set)) == problem.tasks);
  }

  std::array<std::uint64_t, sets> sorted_{};
  std::array<std::uint32_t, sets> largest_{};
  std::array<double, sets> sum_{};
};

}  // namespace scram
