// SPDX-License-Identifier: MIT
// One node for one task with the least total distance, against brute force; what belongs to somebody is left alone.
#include "mind/coordination/task_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

namespace regista::mind {
namespace {

regista_task task(double x, double y) {
  regista_task out{};
  out.before[0] = x;
  out.before[1] = y;
  return out;
}

regista_waypoint waypoint(double x, double y, int task = -1, int robot = 0) { return {x, y, 1.0, task, robot}; }

double distance(const regista_task& task, const regista_waypoint& point) {
  return std::hypot(point.x - task.before[0], point.y - task.before[1]);
}

double total(const std::vector<regista_task>& tasks, const std::vector<regista_waypoint>& points) {
  double sum = 0.0;
  for (const regista_waypoint& each : points) {
    if (each.task >= 0) sum += distance(tasks[static_cast<std::size_t>(each.task)], each);
  }
  return sum;
}

// The least sum over all ways of pairing the fewer with different ones of the others.
double least_total(const std::vector<regista_task>& tasks, const std::vector<regista_waypoint>& points) {
  const bool fewer_tasks = tasks.size() <= points.size();
  const std::size_t few = std::min(tasks.size(), points.size());
  std::vector<std::size_t> order(std::max(tasks.size(), points.size()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  double least = 1e9;
  do {
    double sum = 0.0;
    for (std::size_t i = 0; i < few; ++i) {
      sum += fewer_tasks ? distance(tasks[i], points[order[i]]) : distance(tasks[order[i]], points[i]);
    }
    least = std::min(least, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

TEST(WaypointMatching, LeastTotalDistanceAgainstAllPairings) {
  std::mt19937_64 engine(1);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
  WaypointMatching matching(6, 6);
  for (int run = 0; run < 300; ++run) {
    std::vector<regista_task> tasks(1 + engine() % 6);
    std::vector<regista_waypoint> points(engine() % 7);
    for (regista_task& each : tasks) each = task(in(-4, 4), in(-3, 3));
    for (regista_waypoint& each : points) each = waypoint(in(-4, 4), in(-3, 3));
    std::vector<std::size_t> all(tasks.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    matching.match(tasks, all, points);
    std::multiset<int> given;
    for (const regista_waypoint& each : points) {
      if (each.task >= 0) given.insert(each.task);
    }
    EXPECT_EQ(given.size(), std::min(tasks.size(), points.size()));
    EXPECT_EQ(std::set<int>(given.begin(), given.end()).size(), given.size()) << "each once";
    EXPECT_NEAR(total(tasks, points), points.empty() ? 0.0 : least_total(tasks, points), 1e-9);
  }
}

TEST(WaypointMatching, TwoTasksWithOneNearestNodeGoApart) {
  std::vector<regista_task> tasks{task(0, 0.1), task(0, -0.1)};
  std::vector<regista_waypoint> points{waypoint(0, 0), waypoint(0, 3)};
  WaypointMatching matching(2, 2);
  matching.match(tasks, std::vector<std::size_t>{0, 1}, points);
  EXPECT_EQ(points[0].task, 1);
  EXPECT_EQ(points[1].task, 0);
}

TEST(WaypointMatching, WhatBelongsToSomebodyIsLeftAlone) {
  std::vector<regista_task> tasks{task(0, 0), task(1, 0), task(2, 0)};
  std::vector<regista_waypoint> points{waypoint(0, 0, 2), waypoint(1, 0, -1, 4), waypoint(5, 0)};
  WaypointMatching matching(3, 3);
  matching.match(tasks, std::vector<std::size_t>{0, 2}, points);
  EXPECT_EQ(points[0].task, 2);
  EXPECT_EQ(points[1].task, -1);
  EXPECT_EQ(points[2].task, 0) << "the task that wants one and has none; task 1 does not want any";
}

}  // namespace
}  // namespace regista::mind
