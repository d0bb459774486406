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

// Its own waypoint, or the nearest of those that belong to nothing; -1 when there is neither.
int waypoint_for(const regista_task& task, std::size_t index, std::span<const regista_waypoint> waypoints) {
  const auto own = std::ranges::find(waypoints, static_cast<std::int32_t>(index), &regista_waypoint::task);
  if (own != waypoints.end()) return static_cast<int>(own - waypoints.begin());
  return nearest_waypoint(waypoints, task.before[0], task.before[1]);
}

void move_towards(regista_task& task, const regista_waypoint& point, double at_most) {
  const double dx = point.x - task.before[0], dy = point.y - task.before[1];
  const double distance = std::sqrt(dx * dx + dy * dy);
  const double share = distance <= at_most ? 1.0 : at_most / distance;
  task.after[0] = task.before[0] + share * dx;
  task.after[1] = task.before[1] + share * dy;
}

}  // namespace

int nearest_waypoint(std::span<const regista_waypoint> waypoints, double x, double y) {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    if (waypoints[i].robot != 0 || waypoints[i].task >= 0) continue;
    const double d2 = distance2(waypoints[i], x, y);
    // Selected, not branched on: which one is nearest is anybody's guess.
    nearest = d2 < least ? static_cast<int>(i) : nearest;
    least = std::min(least, d2);
  }
  return nearest;
}

void TaskFilter::keep(std::span<const regista_task> tasks, std::span<const regista_waypoint> waypoints,
                      std::span<const std::int32_t> active, std::span<const std::int32_t> played,
                      const FilterRule& rule, std::vector<std::size_t>& kept) {
  kept.clear();
  chosen_.assign(tasks.size(), 0);
  candidates_.clear();
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
    const int nearest = waypoint_for(task, i, waypoints);
    double distance = 0.0;
    if (nearest >= 0) {
      distance = std::sqrt(distance2(waypoints[static_cast<std::size_t>(nearest)], task.before[0], task.before[1]));
      if (contains(played, task.id)) distance = std::max(0.0, distance - rule.hysteresis);
    }
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
