// SPDX-License-Identifier: MIT
// Whether the map that was broadcast last is good enough (Nao Devils, released code, 2024): the numbers of robots and
// tasks, the tasks and the robots are those of today, and its longest walk is no more than `margin` longer than it
// would have to be.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "../negotiation/told_map.hpp"

namespace nao_devils {

// Both maps are of one team. best: the least longest walk of today; length(robot, task): the walk of robot number
// `robot` to the task with that id, m.
template <class Length>
bool is_worth_keeping(std::span<const std::int32_t> last, std::span<const std::int32_t> best, double margin,
                      const Length& length) {
  double walk = 0.0, best_walk = 0.0;
  std::size_t tasks = 0, best_tasks = 0;
  for (std::size_t robot = 0; robot < best.size(); ++robot) {
    if ((last[robot] == scram::away) != (best[robot] == scram::away)) return false;
    const int number = static_cast<int>(robot + 1);
    if (best[robot] >= 0) {
      if (std::find(last.begin(), last.end(), best[robot]) == last.end()) return false;
      best_walk = std::max(best_walk, length(number, best[robot]));
      ++best_tasks;
    }
    tasks += last[robot] >= 0 ? 1 : 0;
  }
  if (tasks != best_tasks) return false;  // from here on all tasks of the last map are known
  for (std::size_t robot = 0; robot < last.size(); ++robot) {
    if (last[robot] >= 0) walk = std::max(walk, length(static_cast<int>(robot + 1), last[robot]));
  }
  return walk <= best_walk + margin;
}

}  // namespace nao_devils
