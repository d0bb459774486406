// SPDX-License-Identifier: MIT
// One node for one task. Affinita et al. 2023 move tasks by "applying offsets to the tasks in their nearest node
// directions", and explain what it gains "by distributing the tasks of each role far from the tasks of the other roles"
// ("Experimental Results"). Tasks
// that all move towards one nearest node do not spread, so tasks and nodes are paired, each once, with the least total
// distance.
#pragma once

#include <span>
#include <vector>

#include "mind/coordination/least_cost_assignment.hpp"
#include "regista/abi.h"

namespace regista::mind {

class WaypointMatching {
 public:
  WaypointMatching(std::size_t most_tasks, std::size_t most_waypoints);

  // Gives waypoints that belong to nothing to tasks that have none, as many as there are of the fewer. `wanting`:
  // indices of the tasks; a waypoint's `task` becomes one of them. Those that stay free keep -1.
  void match(std::span<const regista_task> tasks, std::span<const std::size_t> wanting,
             std::span<regista_waypoint> waypoints);

 private:
  LeastCostAssignment assignment_;
  std::vector<std::size_t> tasks_, free_;
  std::vector<double> costs_;
};

}  // namespace regista::mind
