// SPDX-License-Identifier: MIT
#include "mind/coordination/task_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace regista::mind {
namespace {

double distance2(const regista_waypoint& point, double x, double y) {
  const double dx = point.x - x, dy = point.y - y;
  return dx * dx + dy * dy;
}

bool contains(std::span<const std::int32_t> numbers, std::int32_t number) {
  return std::ranges::find(numbers, number) != numbers.end();
}

void move_towards(regista_task& task, const regista_waypoint& point, double at_most) {
  const double dx = point.x - task.before[0], dy = point.y - task.before[1];
  const double distance = std::sqrt(dx * dx + dy * dy);
  const double share = distance <= at_most ? 1.0 : at_most / distance;
  task.after[0] = task.before[0] + share * dx;
  task.after[1] = task.before[1] + share * dy;
}

}  // namespace

// To its own waypoint, or to the nearest of those that belong to nothing; infinity when there is neither.
double TaskFilter::distance_to_waypoint(const regista_task& task, std::size_t index,
                                        std::span<const regista_waypoint> waypoints) const {
  const double x = task.before[0], y = task.before[1];
  if (some_belong_to_tasks_) {
    const auto own = std::ranges::find(waypoints, static_cast<std::int32_t>(index), &regista_waypoint::task);
    if (own != waypoints.end()) return std::sqrt(distance2(*own, x, y));
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < free_x_.size(); ++i) {
    const double dx = free_x_[i] - x, dy = free_y_[i] - y;
    least = std::min(least, dx * dx + dy * dy);
  }
  return std::sqrt(least);
}

TaskFilter::TaskFilter(std::size_t most_tasks, std::size_t most_waypoints) {
  free_x_.reserve(most_waypoints);
  free_y_.reserve(most_waypoints);
  candidates_.reserve(most_tasks);
  chosen_.reserve(most_tasks);
}

void TaskFilter::keep(std::span<const regista_task> tasks, std::span<const regista_waypoint> waypoints,
                      std::span<const std::int32_t> active, std::span<const std::int32_t> played,
                      const FilterRule& rule, std::vector<std::size_t>& kept) {
  kept.clear();
  chosen_.assign(tasks.size(), 0);
  candidates_.clear();
  free_x_.clear();
  free_y_.clear();
  some_belong_to_tasks_ = false;
  for (const regista_waypoint& point : waypoints) {
    some_belong_to_tasks_ = some_belong_to_tasks_ || point.task >= 0;
    if (point.task >= 0 || point.robot != 0) continue;
    free_x_.push_back(point.x);
    free_y_.push_back(point.y);
  }
  std::size_t room = rule.all ? tasks.size() : active.size();
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const regista_task& task = tasks[i];
    if (task.robot != 0) {
      if (contains(active, task.robot) && room > 0) {
        chosen_[i] = 1;
        --room;
      }
      continue;
    }
    double distance = distance_to_waypoint(task, i, waypoints);
    if (std::isinf(distance)) distance = 0.0;
    if (contains(played, task.id)) distance = std::max(0.0, distance - rule.hysteresis);
    if ((task.flags & REGISTA_TASK_REQUIRED) != 0) distance = -1.0;
    candidates_.push_back({distance, i});
  }
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
  });
  for (std::size_t i = 0; i < std::min(room, candidates_.size()); ++i) chosen_[candidates_[i].index] = 1;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (chosen_[i] != 0) kept.push_back(i);
  }
}

void offset(regista_task& task, int index, std::span<const regista_waypoint> waypoints, double at_most) {
  const auto own = std::ranges::find(waypoints, index, &regista_waypoint::task);
  if (own != waypoints.end()) move_towards(task, *own, at_most);
}

void offset_to_own(regista_task& task, int number, std::span<const regista_waypoint> waypoints, double at_most) {
  const auto own = std::ranges::find(waypoints, number, &regista_waypoint::robot);
  if (own != waypoints.end()) move_towards(task, *own, at_most);
}

}  // namespace regista::mind
