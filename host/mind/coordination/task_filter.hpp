// SPDX-License-Identifier: MIT
// TaskFilter reduces M tasks to N (Affinita et al. 2023): "the filtering process for the N out of M tasks is done
// through the proximity of the tasks to the nodes". WaypointMatching and offset() move the N tasks towards nodes. The
// nodes are waypoints here, which a positioner plugin makes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "regista/abi.h"

namespace regista::mind {

// Computes the assignment of least total cost, by shortest augmenting paths: R. Jonker and A. Volgenant, "A Shortest
// Augmenting Path Algorithm for Dense and Sparse Linear Assignment Problems", Computing 38, 1987 (without its
// initialisation); O(rows^2 columns). Only the host uses this class; teams choose an assigner plugin.
class LeastCostAssignment {
 public:
  void reserve(std::size_t rows, std::size_t columns);

  // Gives every row its own column; returns the total cost. costs: finite, row by row. `rows` is at most `columns`.
  double solve(std::span<const double> costs, std::size_t rows, std::size_t columns);

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  // For each column, the row that the last solve() gave to the column, or `none`.
  std::span<const std::size_t> row_of() const { return result_; }

 private:
  // Except in result_, row i and column i have the index i + 1; index 0 stands for no row or no column.
  std::vector<double> row_price_, column_price_, slack_;
  std::vector<std::size_t> row_of_, before_, result_;
  std::vector<char> visited_;
};

struct FilterRule {
  double hysteresis = 0.0;  // m: a task that a robot plays counts as nearer to its waypoint by this distance
  bool all = false;         // true: keep() keeps every task, except tasks bound to an inactive robot
};

// keep() keeps at most as many tasks as there are active robots, or every task if rule.all is true; never a task bound
// to an inactive robot. It prefers tasks bound to an active robot, then required tasks, then tasks near their waypoint:
// the waypoint that belongs to the task or, if there is none, the nearest waypoint that belongs to no task and no
// robot. A task without any such waypoint counts as at distance 0. Of equally near tasks, the earlier is preferred. The
// filter has no memory, so robots with equal worlds keep equal tasks.
// active: numbers of the active robots, ascending. played: ids of the tasks that, according to the robot's world model,
// active robots play now; such a task counts as nearer by rule.hysteresis. kept: ascending indices of `tasks`.
class TaskFilter {
 public:
  TaskFilter(std::size_t most_tasks, std::size_t most_waypoints);
  void keep(std::span<const regista_task> tasks, std::span<const regista_waypoint> waypoints,
            std::span<const std::int32_t> active, std::span<const std::int32_t> played, const FilterRule& rule,
            std::vector<std::size_t>& kept);

 private:
  double distance_to_waypoint(const regista_task& task, std::size_t index,
                              std::span<const regista_waypoint> waypoints) const;

  std::vector<double> free_x_, free_y_;  // coordinates of free waypoints: without task and robot
  bool some_belong_to_tasks_ = false;
  std::vector<std::pair<double, std::size_t>> candidates_;  // distance and index of the task
  std::vector<char> chosen_;
};

// Moves `after` of the task by at most `at_most` (m) towards its waypoint, if any. `index`: of the task in the context.
void offset(regista_task& task, int index, std::span<const regista_waypoint> waypoints, double at_most);

// Moves the task like offset(), but towards the waypoint that belongs to robot `number`, which has taken the task.
void offset_to_own(regista_task& task, int number, std::span<const regista_waypoint> waypoints, double at_most);

// Matches each task with a different node. Affinita et al. 2023 move tasks by "applying offsets to the tasks in their
// nearest node directions", so as to distribute "the tasks of each role far from the tasks of the other roles". Tasks
// that move towards the same node would not spread. Therefore each node gets one task, with the least total distance.
class WaypointMatching {
 public:
  WaypointMatching(std::size_t most_tasks, std::size_t most_waypoints);

  // Gives free waypoints to tasks without waypoint, until tasks or waypoints run out. `wanting`: indices of tasks that
  // may get a waypoint. Sets waypoint.task of each given waypoint to an index of `tasks`; other free waypoints keep -1.
  void match(std::span<const regista_task> tasks, std::span<const std::size_t> wanting,
             std::span<regista_waypoint> waypoints);

 private:
  LeastCostAssignment assignment_;
  std::vector<std::size_t> tasks_, free_;
  std::vector<double> costs_;
};

}  // namespace regista::mind
