// SPDX-License-Identifier: MIT
#include "mind/coordination/waypoint_matching.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace regista::mind {

WaypointMatching::WaypointMatching(std::size_t most_tasks, std::size_t most_waypoints) {
  constexpr std::size_t usual_waypoints = 32;  // more are rare, and allocate once
  const std::size_t waypoints = std::min(most_waypoints, usual_waypoints);
  const auto [least, most] = std::minmax(most_tasks, waypoints);
  assignment_.reserve(least, most);
  tasks_.reserve(most_tasks);
  free_.reserve(waypoints);
  costs_.reserve(most_tasks * waypoints);
}

void WaypointMatching::match(std::span<const regista_task> tasks, std::span<const std::size_t> wanting,
                             std::span<regista_waypoint> waypoints) {
  tasks_.clear();
  free_.clear();
  for (const std::size_t task : wanting) {
    const bool has_one =
        std::ranges::find(waypoints, static_cast<std::int32_t>(task), &regista_waypoint::task) != waypoints.end();
    if (!has_one) tasks_.push_back(task);
  }
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    if (waypoints[i].task < 0 && waypoints[i].robot == 0) free_.push_back(i);
  }
  // The fewer are the rows.
  const bool by_task = tasks_.size() <= free_.size();
  const std::vector<std::size_t>&rows = by_task ? tasks_ : free_, &columns = by_task ? free_ : tasks_;
  costs_.clear();
  for (const std::size_t row : rows) {
    for (const std::size_t column : columns) {
      const regista_task& task = tasks[by_task ? row : column];
      const regista_waypoint& point = waypoints[by_task ? column : row];
      const double dx = point.x - task.before[0], dy = point.y - task.before[1];
      costs_.push_back(std::sqrt(dx * dx + dy * dy));
    }
  }
  assignment_.solve(costs_, rows.size(), columns.size());
  const auto row_of = assignment_.row_of();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (row_of[i] == LeastCostAssignment::none) continue;
    const std::size_t row = rows[row_of[i]], column = columns[i];
    waypoints[by_task ? column : row].task = static_cast<std::int32_t>(by_task ? row : column);
  }
}

}  // namespace regista::mind
