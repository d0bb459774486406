// SPDX-License-Identifier: MIT
// What one more task brings a robot that has a path of tasks: how much the worth of the path grows when the task is put
// into it at its best place, the others keeping their order (Choi, Brunet and How, IEEE T-RO 25(4), 2009).
//
// The paper's example is a reward that is discounted by the time of arrival. Here a task is worth its utility, which
// counts the way to it already; so only the detour is discounted: what the way along the path is longer than the
// straight way (assumption). The first task of a path has no detour: a path of one task is worth its utility.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../negotiation/bids.hpp"
#include "consensus.hpp"

namespace consensus_bundle {

struct Place {
  double x = 0.0, y = 0.0;  // m, field frame
};

// A task as it is when the robot bids for it.
struct Chance {
  bool allowed = false;
  double utility = 0.0;  // >= 0
  Place place;
};

struct Worth {
  double kept_per_second = 0.95;  // share of its utility that a task keeps for each second of detour, (0, 1]
  double speed = 0.25;            // of walking, m/s, > 0
  double step = 0.0005;           // of utility, > 0: bids are whole numbers of such steps
  std::uint32_t most = 4095;      // highest bid, >= 1
};

// kept^seconds, straight between whole seconds: the same bits everywhere, which pow of the C library does not promise.
inline double share_kept(double kept, double seconds) {
  constexpr double longest = 1000.0;
  const double rest = std::min(std::max(seconds, 0.0), longest);
  const double whole = std::floor(rest);
  double out = 1.0, factor = kept;
  for (auto count = static_cast<unsigned>(whole); count != 0; count >>= 1, factor *= factor) {
    if ((count & 1u) != 0) out *= factor;
  }
  return out * (1.0 + (rest - whole) * (kept - 1.0));
}

inline double distance(const Place& a, const Place& b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

// Of a robot at `start` that does the tasks of `path`, with `more` before the one at index `at`.
inline double worth_with(const Worth& worth, const Place& start, std::span<const Chance> tasks,
                         std::span<const std::uint32_t> path, std::uint32_t more, std::size_t at) {
  double sum = 0.0, walked = 0.0;
  const Place* before = &start;
  for (std::size_t k = 0; k <= path.size(); ++k) {
    const Chance& task = tasks[k == at ? more : path[k < at ? k : k - 1]];
    walked += distance(*before, task.place);
    before = &task.place;
    const double detour = k == 0 ? 0.0 : walked - distance(start, task.place);
    sum += task.utility * share_kept(worth.kept_per_second, detour / worth.speed);
  }
  return sum;
}

inline double worth_of(const Worth& worth, const Place& start, std::span<const Chance> tasks,
                       std::span<const std::uint32_t> path) {
  if (path.empty()) return 0.0;
  return worth_with(worth, start, tasks, path.first(path.size() - 1), path.back(), path.size() - 1);
}

// tasks: by task. A first task can always be bid for, with 1 at least, unless it is forbidden.
inline Gain gain_of(const Worth& worth, const Place& start, std::span<const Chance> tasks,
                    std::span<const std::uint32_t> path, std::uint32_t task) {
  if (!tasks[task].allowed) return {};
  double most = tasks[task].utility;
  std::size_t place = 0;
  if (!path.empty()) {
    most = 0.0;
    const double without = worth_of(worth, start, tasks, path);
    for (std::size_t at = path.size() + 1; at-- > 0;) {  // of equal places the last
      const double gain = worth_with(worth, start, tasks, path, task, at) - without;
      if (gain <= most) continue;
      most = gain;
      place = at;
    }
    if (most <= 0.0) return {};
  }
  return {1 + negotiation::in_steps(most, worth.step, worth.most - 1), place};
}

}  // namespace consensus_bundle
