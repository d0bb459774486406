// SPDX-License-Identifier: MIT
// From M tasks to N (Affinita et al. 2023): "the filtering process for the N out of M tasks is done through the
// proximity of the tasks to the nodes", and the offset of the kept ones towards their nearest node.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "regista/abi.h"

namespace regista::mind {

struct FilterRule {
  double hysteresis = 0.0;  // m: a task that a robot is said to play counts as so much nearer
  bool all = false;         // whoever can be kept is
};

// Keeps at most as many tasks as there are active robots (their numbers, ascending), in the given order: those bound to
// an active robot, those required, then those nearest to a waypoint (their own, or one that belongs to nothing), or the
// first ones while there are no waypoints. A task bound to a robot that is not active is never kept. `played`: ids of
// tasks that active robots are said to play. All of it is of one world, and nothing else is remembered: robots that
// share a world keep the same tasks. Writes indices, ascending.
class TaskFilter {
 public:
  TaskFilter(std::size_t most_tasks, std::size_t most_waypoints);
  void keep(std::span<const regista_task> tasks, std::span<const regista_waypoint> waypoints,
            std::span<const std::int32_t> active, std::span<const std::int32_t> played, const FilterRule& rule,
            std::vector<std::size_t>& kept);

 private:
  struct Candidate {
    double distance;
    std::size_t index;
  };
  double distance_to_waypoint(const regista_task& task, std::size_t index,
                              std::span<const regista_waypoint> waypoints) const;

  std::vector<double> free_x_, free_y_;  // of waypoints that belong to nothing
  bool some_belong_to_tasks_ = false;
  std::vector<Candidate> candidates_;
  std::vector<char> chosen_;
};

// Moves `after` towards the waypoint that belongs to this very task (its `index` among the context's), by at most
// `at_most` metres; without one, nothing changes.
void offset(regista_task& task, int index, std::span<const regista_waypoint> waypoints, double at_most);

// The same towards the waypoint that belongs to robot `number`, which has taken the task; without one, nothing changes.
void offset_to_own(regista_task& task, int number, std::span<const regista_waypoint> waypoints, double at_most);

}  // namespace regista::mind
