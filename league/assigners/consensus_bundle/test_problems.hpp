// SPDX-License-Identifier: MIT
// What the tests of the consensus share: random problems whose gains strictly diminish, the central greedy choice that
// robots have to come to, and what a robot would put into a packet.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include "consensus.hpp"

namespace consensus_bundle::test {

using Random = std::mt19937;

inline std::size_t below(Random& random, std::size_t end) { return random() % end; }
inline double share(Random& random) { return static_cast<double>(random() >> 5) * 0x1p-27; }  // [0, 1)

// additive: each task is worth so much, less for each task that the robot has. covering: less by what the task has in
// common with each of the others, so that it matters which they are. growing: more by that, as gains must not be.
enum class Gains { additive, covering, growing };

struct Problem {
  Gains gains = Gains::additive;
  std::size_t robots = 0, tasks = 0, limit = 1;
  std::vector<std::vector<std::uint32_t>> alone;   // robot x task, 0: forbidden
  std::vector<std::vector<std::uint32_t>> common;  // task x task, >= 1; not used where gains are additive

  // robot: from 0.
  Gain gain(std::size_t robot, std::span<const std::uint32_t> path, std::uint32_t task) const {
    std::int64_t value = alone[robot][task];
    if (value == 0) return {};
    for (const std::uint32_t each : path) {
      switch (gains) {
        case Gains::additive:
          value -= 30;
          break;
        case Gains::covering:
          value -= common[each][task];
          break;
        case Gains::growing:
          value += common[each][task];
          break;
      }
    }
    return {static_cast<std::uint32_t>(std::max<std::int64_t>(value, 0)), path.size()};
  }
};

inline Problem random_problem(Random& random, Gains gains, std::size_t limit, std::size_t most_robots = 7,
                              std::size_t most_tasks = 10) {
  Problem out{gains, 2 + below(random, most_robots - 1), 1 + below(random, most_tasks), limit, {}, {}};
  out.alone.assign(out.robots, std::vector<std::uint32_t>(out.tasks));
  const std::size_t spread = below(random, 2) == 0 ? 1000 : 20;  // the latter: many ties
  for (auto& row : out.alone) {
    for (std::uint32_t& each : row) {
      each = below(random, 7) == 0 ? 0 : static_cast<std::uint32_t>(500 + below(random, spread));
    }
  }
  out.common.assign(out.tasks, std::vector<std::uint32_t>(out.tasks, 1));
  for (std::size_t a = 0; a < out.tasks; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      out.common[a][b] = out.common[b][a] = static_cast<std::uint32_t>(1 + below(random, 300));
    }
  }
  return out;
}

// Of all robots and tasks always the pair that brings most; of equal ones that of the lower robot, then of the lower
// task. Gains that grow are cut below what the robot's last task brought. Bundles by robot.
inline std::vector<std::vector<std::uint32_t>> greedy(const Problem& problem) {
  std::vector<std::vector<std::uint32_t>> out(problem.robots);
  std::vector<char> taken(problem.tasks, 0);
  std::vector<std::uint32_t> below_last(problem.robots, std::numeric_limits<std::uint32_t>::max());
  for (;;) {
    std::uint32_t most = 0, best_task = 0;
    std::size_t best_robot = 0;
    for (std::size_t robot = 0; robot < problem.robots; ++robot) {
      if (out[robot].size() == problem.limit) continue;
      for (std::uint32_t task = 0; task < problem.tasks; ++task) {
        std::uint32_t value = taken[task] != 0 ? 0 : problem.gain(robot, out[robot], task).value;
        if (problem.gains == Gains::growing) value = std::min(value, below_last[robot]);
        if (value <= most) continue;
        most = value;
        best_robot = robot;
        best_task = task;
      }
    }
    if (most == 0) return out;
    out[best_robot].push_back(best_task);
    taken[best_task] = 1;
    below_last[best_robot] = most - 1;
  }
}

inline std::uint64_t worth(const Problem& problem, const std::vector<std::vector<std::uint32_t>>& bundles) {
  std::uint64_t sum = 0;
  for (std::size_t robot = 0; robot < problem.robots; ++robot) {
    for (std::size_t k = 0; k < bundles[robot].size(); ++k) {
      sum += problem.gain(robot, std::span(bundles[robot]).first(k), bundles[robot][k]).value;
    }
  }
  return sum;
}

inline std::vector<Consensus> team_for(const Problem& problem) {
  std::vector<Consensus> out(problem.robots);
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k].setup(static_cast<int>(k) + 1, problem.robots, problem.tasks);
  }
  return out;
}

inline Told packet_of(const Consensus& consensus, int number, std::int64_t tick) {
  Told out{number,
           tick,
           {consensus.claims().begin(), consensus.claims().end()},
           {consensus.stamps().begin(), consensus.stamps().end()}};
  out.stamps[static_cast<std::size_t>(number - 1)] = tick;
  return out;
}

// All bundles are these, and all robots say so of each task.
inline bool all_say(const std::vector<Consensus>& team, const std::vector<std::vector<std::uint32_t>>& bundles) {
  for (std::size_t k = 0; k < team.size(); ++k) {
    if (!std::ranges::equal(team[k].bundle(), bundles[k])) return false;
    for (std::uint32_t task = 0; task < team[k].claims().size(); ++task) {
      int winner = nobody;
      for (std::size_t robot = 0; robot < bundles.size(); ++robot) {
        if (std::ranges::count(bundles[robot], task) > 0) winner = static_cast<int>(robot) + 1;
      }
      if (team[k].claims()[task].winner != winner) return false;
    }
  }
  return true;
}

}  // namespace consensus_bundle::test
