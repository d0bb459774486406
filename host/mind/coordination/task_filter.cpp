// SPDX-License-Identifier: MIT
#include "mind/coordination/task_filter.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace regista::mind {

void LeastCostAssignment::reserve(std::size_t rows, std::size_t columns) {
  row_price_.reserve(rows + 1);
  for (std::vector<double>* each : {&column_price_, &slack_}) each->reserve(columns + 1);
  for (std::vector<std::size_t>* each : {&row_of_, &before_, &result_}) each->reserve(columns + 1);
  visited_.reserve(columns + 1);
}

// Adds the rows one by one. Each new row moves earlier rows to other columns along the path of least cost.
double LeastCostAssignment::solve(std::span<const double> costs, std::size_t rows, std::size_t columns) {
  assert(rows <= columns && costs.size() == rows * columns);
  row_price_.assign(rows + 1, 0.0);
  column_price_.assign(columns + 1, 0.0);
  row_of_.assign(columns + 1, 0);
  before_.assign(columns + 1, 0);
  for (std::size_t entering = 1; entering <= rows; ++entering) {
    slack_.assign(columns + 1, std::numeric_limits<double>::infinity());
    visited_.assign(columns + 1, 0);
    row_of_[0] = entering;
    std::size_t column = 0;
    do {
      visited_[column] = 1;
      const std::size_t row = row_of_[column];
      double least = std::numeric_limits<double>::infinity();
      std::size_t next = 0;
      for (std::size_t other = 1; other <= columns; ++other) {
        if (visited_[other] != 0) continue;
        const double reduced = costs[(row - 1) * columns + other - 1] - row_price_[row] - column_price_[other];
        if (reduced < slack_[other]) {
          slack_[other] = reduced;
          before_[other] = column;
        }
        if (slack_[other] < least) {
          least = slack_[other];
          next = other;
        }
      }
      for (std::size_t other = 0; other <= columns; ++other) {
        if (visited_[other] != 0) {
          row_price_[row_of_[other]] += least;
          column_price_[other] -= least;
        } else {
          slack_[other] -= least;
        }
      }
      column = next;
    } while (row_of_[column] != 0);
    while (column != 0) {
      row_of_[column] = row_of_[before_[column]];
      column = before_[column];
    }
  }
  double sum = 0.0;
  result_.assign(columns, none);
  for (std::size_t column = 1; column <= columns; ++column) {
    if (row_of_[column] == 0) continue;
    result_[column - 1] = row_of_[column] - 1;
    sum += costs[(row_of_[column] - 1) * columns + column - 1];
  }
  return sum;
}

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

// Returns the distance to the task's own waypoint; else to the nearest free waypoint; infinity without such waypoints.
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
  std::ranges::sort(candidates_);
  for (std::size_t i = 0; i < std::min(room, candidates_.size()); ++i) chosen_[candidates_[i].second] = 1;
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

WaypointMatching::WaypointMatching(std::size_t most_tasks, std::size_t most_waypoints) {
  constexpr std::size_t usual_waypoints = 32;  // a larger number is rare, and costs one allocation
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
  // The smaller of the two sets gives the rows, because solve() needs rows <= columns.
  const bool by_task = tasks_.size() <= free_.size();
  const std::vector<std::size_t>&rows = by_task ? tasks_ : free_, &columns = by_task ? free_ : tasks_;
  costs_.clear();
  for (const std::size_t row : rows) {
    for (const std::size_t column : columns) {
      const regista_task& task = tasks[by_task ? row : column];
      const regista_waypoint& point = waypoints[by_task ? column : row];
      costs_.push_back(std::sqrt(distance2(point, task.before[0], task.before[1])));
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
