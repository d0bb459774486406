// SPDX-License-Identifier: MIT
// Closed forms, and who a waypoint belongs to.
#include <gtest/gtest.h>

#include <vector>

#include <regista/testkit/contract.hpp>

#include "algorithm.hpp"

namespace {

using waypoint_utility::Form;
using waypoint_utility::Point;
using waypoint_utility::Settings;
using waypoint_utility::Waypoint;

std::vector<double> table(const std::vector<int>& numbers, const std::vector<Point>& targets,
                          const std::vector<Waypoint>& waypoints, const Settings& settings) {
  std::vector<double> out(numbers.size() * targets.size(), 0.0);
  waypoint_utility::score(numbers, targets, waypoints, settings, out.data(), targets.size());
  return out;
}

TEST(WaypointProximity, NothingWithoutWaypoints) {
  EXPECT_EQ(table({1, 2}, {{0, 0}, {1, 1}}, {}, {}), (std::vector<double>{0, 0, 0, 0}));
}

TEST(WaypointProximity, ClosedForms) {
  const std::vector<Point> targets{{0, 0}, {3, 4}, {3, 1}};
  const std::vector<Waypoint> waypoints{{0, 0, 1.0}, {30, 40, 1.0}};
  const auto inverse = table({4}, targets, waypoints, {Form::inverse, 5.0, true});
  EXPECT_DOUBLE_EQ(inverse[0], 1.0);
  EXPECT_DOUBLE_EQ(inverse[1], 0.5);
  EXPECT_DOUBLE_EQ(inverse[2], 1.0 / (1.0 + std::sqrt(10.0) / 5.0));
  const auto linear = table({4}, targets, waypoints, {Form::linear, 4.0, true});
  EXPECT_DOUBLE_EQ(linear[0], 1.0);
  EXPECT_DOUBLE_EQ(linear[1], 0.0);
  EXPECT_DOUBLE_EQ(linear[2], 1.0 - std::sqrt(10.0) / 4.0);
}

TEST(WaypointProximity, TheScoreOfTheNearestWeighs) {
  const std::vector<Waypoint> waypoints{{1, 0, 0.25}, {5, 0, 1.0}};
  EXPECT_DOUBLE_EQ(table({1}, {{0, 0}}, waypoints, {Form::inverse, 1.0, true})[0], 0.125);
  EXPECT_DOUBLE_EQ(table({1}, {{0, 0}}, waypoints, {Form::inverse, 1.0, false})[0], 0.5);
  // Of two equally near ones the better counts, whatever their order.
  EXPECT_DOUBLE_EQ(table({1}, {{0, 0}}, {{1, 0, 0.2}, {-1, 0, 0.8}}, {Form::inverse, 1.0, true})[0], 0.4);
  EXPECT_DOUBLE_EQ(table({1}, {{0, 0}}, {{-1, 0, 0.8}, {1, 0, 0.2}}, {Form::inverse, 1.0, true})[0], 0.4);
}

TEST(WaypointProximity, WaypointsCountForThoseTheyBelongTo) {
  const std::vector<Waypoint> waypoints{{0, 0, 1.0, 1, 0}, {0, 0, 1.0, -1, 5}};
  EXPECT_EQ(table({2, 5}, {{0, 0}, {0, 0}}, waypoints, {}), (std::vector<double>{0, 1, 1, 1}));
}

REGISTA_UTILITY_CONTRACT(REGISTA_PLUGIN_FILE, "waypoint_proximity", {.order_of_opponents_is_irrelevant = true});

}  // namespace
