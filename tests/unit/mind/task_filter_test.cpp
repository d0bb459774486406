// SPDX-License-Identifier: MIT
// N of M tasks and their offset, against a brute force that follows the words of the header.
#include "mind/coordination/task_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace regista::mind {
namespace {

regista_task task(double x, double y, int robot = 0, bool required = false) {
  regista_task out{};
  out.robot = robot;
  out.flags = required ? std::uint32_t{REGISTA_TASK_REQUIRED} : 0u;
  out.before[0] = out.after[0] = x;
  out.before[1] = out.after[1] = y;
  return out;
}

regista_waypoint point(double x, double y, int of_task = -1) { return {x, y, 1.0, of_task, 0}; }

std::vector<std::size_t> keep(const std::vector<regista_task>& tasks, const std::vector<regista_waypoint>& waypoints,
                              const std::vector<std::int32_t>& active, bool all = false) {
  TaskFilter filter(16, 16);
  std::vector<std::size_t> kept{99};
  filter.keep(tasks, waypoints, active, {}, {0.0, all}, kept);
  return kept;
}

// Repeatedly the best of what is left, by the order of the header.
std::vector<std::size_t> by_hand(const std::vector<regista_task>& tasks, const std::vector<regista_waypoint>& waypoints,
                                 const std::vector<std::int32_t>& active, bool all) {
  const std::size_t room = all ? tasks.size() : active.size();
  std::vector<std::size_t> kept;
  const auto rank = [&](std::size_t i) -> std::pair<int, double> {
    if (tasks[i].robot != 0) return {0, 0.0};
    if ((tasks[i].flags & REGISTA_TASK_REQUIRED) != 0) return {1, 0.0};
    double nearest = waypoints.empty() ? 0.0 : 1e300;
    for (const auto& p : waypoints) {
      nearest = std::min(nearest, (p.x - tasks[i].before[0]) * (p.x - tasks[i].before[0]) +
                                      (p.y - tasks[i].before[1]) * (p.y - tasks[i].before[1]));
    }
    return {2, nearest};
  };
  while (kept.size() < room) {
    std::size_t best = tasks.size();
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const bool for_absent = tasks[i].robot != 0 && std::count(active.begin(), active.end(), tasks[i].robot) == 0;
      if (for_absent || std::count(kept.begin(), kept.end(), i) != 0) continue;
      if (best == tasks.size() || rank(i) < rank(best)) best = i;
    }
    if (best == tasks.size()) break;
    kept.push_back(best);
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

TEST(TaskFilter, AgreesWithBruteForce) {
  std::mt19937_64 engine(1);
  const auto dice = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine); };
  for (int round = 0; round < 3000; ++round) {
    std::vector<regista_task> tasks;
    std::vector<regista_waypoint> waypoints;
    std::vector<std::int32_t> active;
    const int task_count = dice(0, 12), point_count = dice(0, 8);
    for (int i = 0; i < task_count; ++i) {
      const int robot = dice(0, 3) == 0 ? dice(1, 7) : 0;
      const int x = dice(-4, 4), y = dice(-3, 3);  // on a grid, so that distances tie
      tasks.push_back(task(x, y, robot, dice(0, 4) == 0));
    }
    for (int i = 0; i < point_count; ++i) {
      const int x = dice(-4, 4), y = dice(-3, 3);
      waypoints.push_back(point(x, y));
    }
    for (int number = 1; number <= 7; ++number) {
      if (dice(0, 2) != 0) active.push_back(number);
    }
    const bool all = dice(0, 4) == 0;
    const auto got = keep(tasks, waypoints, active, all);
    EXPECT_EQ(got, by_hand(tasks, waypoints, active, all)) << "round " << round;
    EXPECT_TRUE(all || got.size() <= active.size());
  }
}

TEST(TaskFilter, WithoutWaypointsTheMostImportantStay) {
  const std::vector<regista_task> tasks{task(4, 0), task(3, 0), task(2, 0, 0, true), task(1, 0, 2), task(0, 0)};
  EXPECT_EQ(keep(tasks, {}, {2, 3, 4}), (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_EQ(keep(tasks, {}, {3, 4}), (std::vector<std::size_t>{0, 2})) << "bound to an absent robot";
}

TEST(TaskFilter, FewerTasksThanRobots) {
  EXPECT_EQ(keep({task(1, 1), task(2, 2)}, {point(0, 0)}, {1, 2, 3, 4}), (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(keep({}, {point(0, 0)}, {1, 2}).empty());
  EXPECT_TRUE(keep({task(1, 1)}, {point(0, 0)}, {}).empty());
}

TEST(TaskFilter, CoincidentWaypointsCountOnce) {
  const std::vector<regista_task> tasks{task(2, 0), task(1, 0), task(0.5, 0)};
  const auto once = keep(tasks, {point(0, 0)}, {1, 2});
  EXPECT_EQ(once, keep(tasks, {point(0, 0), point(0, 0), point(0, 0)}, {1, 2}));
  EXPECT_EQ(once, (std::vector<std::size_t>{1, 2}));
}

// Distances 1.0 and 1.2 to the only waypoint: with 0.3 m of hysteresis the one that is played stays, until the other is
// more than that much nearer; ids count, not places in the list.
TEST(TaskFilter, HysteresisKeepsWhatIsPlayed) {
  const std::vector<regista_waypoint> waypoints{point(0, 0)};
  regista_task near = task(1.0, 0), far = task(1.2, 0);
  near.id = 10;
  far.id = 11;
  TaskFilter filter(16, 16);
  const auto first = [&](const std::vector<regista_task>& tasks, const std::vector<std::int32_t>& played) {
    std::vector<std::size_t> kept;
    filter.keep(tasks, waypoints, std::vector<std::int32_t>{1}, played, {0.3, false}, kept);
    return tasks[kept.at(0)].id;
  };
  EXPECT_EQ(first({near, far}, {-1}), 10);
  EXPECT_EQ(first({near, far}, {-1, 11}), 11);
  EXPECT_EQ(first({far, near}, {11}), 11);
  EXPECT_EQ(first({near, far}, {11, 10}), 10) << "both are played: the nearer one";
  far.before[0] = 1.31;
  EXPECT_EQ(first({near, far}, {11}), 10);
  EXPECT_EQ(first({near, far}, {}), 10) << "nothing is remembered of earlier calls";
}

TEST(Offset, MovesAtMostSoFarAndNeverBeyond) {
  const std::vector<regista_waypoint> waypoints{point(3, 4, 0), point(-10, 0)};
  regista_task far = task(0, 0);
  far.before[2] = far.after[2] = 0.7;
  offset(far, 0, waypoints, 0.5);
  EXPECT_NEAR(far.after[0], 0.3, 1e-12);
  EXPECT_NEAR(far.after[1], 0.4, 1e-12);
  EXPECT_EQ(far.after[2], 0.7);
  EXPECT_EQ(far.before[0], 0.0);
  regista_task near = task(2.9, 3.9);
  offset(near, 0, waypoints, 0.5);
  EXPECT_EQ(near.after[0], 3.0);
  EXPECT_EQ(near.after[1], 4.0);
  regista_task there = task(3, 4);
  offset(there, 0, waypoints, 0.5);
  EXPECT_EQ(there.after[0], 3.0);
  EXPECT_EQ(there.after[1], 4.0);
  regista_task alone = task(1, 2);
  offset(alone, 0, {}, 0.5);
  EXPECT_EQ(alone.after[0], 1.0);
  EXPECT_EQ(alone.after[1], 2.0);
}

TEST(Offset, OnlyToTheOwnWaypoint) {
  const std::vector<regista_waypoint> waypoints{point(0.1, 0), point(2, 0, 3), point(-1, 0, 4)};
  regista_task third = task(0, 0), fifth = task(0, 0);
  offset(third, 3, waypoints, 0.5);
  EXPECT_DOUBLE_EQ(third.after[0], 0.5);
  offset(fifth, 5, waypoints, 0.5);
  EXPECT_DOUBLE_EQ(fifth.after[0], 0.0) << "nobody has been given the first";
}

// A task without a waypoint of its own is not moved to another's, and the filter measures each to what it may go to.
TEST(Offset, WaypointsOfOtherTasksAreNone) {
  const std::vector<regista_waypoint> points{point(1.0, 0.0, 1), point(0.0, 0.3, 0)};
  regista_task unnamed = task(0.9, 0.0);
  offset(unnamed, 2, points, 20.0);
  EXPECT_EQ(unnamed.after[0], 0.9);
  // Task 0 is 3 m from its own point, however near it is to that of task 1; tasks 1 and 2 are nearer to theirs.
  const std::vector<regista_task> tasks{task(1.0, 0.1), task(1.0, 0.5), task(4.0, 0.0)};
  const std::vector<regista_waypoint> bound{point(1.0, 3.1, 0), point(1.0, 0.0, 1), point(4.0, 0.2, 2)};
  EXPECT_EQ(keep(tasks, bound, {1, 2}), (std::vector<std::size_t>{1, 2}));
}

// A point that belongs to a robot says nothing of tasks, but moves the task that this robot takes.
TEST(Offset, WaypointsOfRobots) {
  const std::vector<regista_waypoint> points{{1.0, 0.0, 1.0, -1, 3}, {5.0, 0.0, 1.0, -1, 4}};
  regista_task moved = task(0.0, 0.0);
  offset(moved, 0, points, 20.0);
  EXPECT_EQ(moved.after[0], 0.0);
  offset_to_own(moved, 2, points, 20.0);
  EXPECT_EQ(moved.after[0], 0.0);
  offset_to_own(moved, 4, points, 2.0);
  EXPECT_EQ(moved.after[0], 2.0);
  offset_to_own(moved, 3, points, 2.0);
  EXPECT_EQ(moved.after[0], 1.0);
}

}  // namespace
}  // namespace regista::mind
