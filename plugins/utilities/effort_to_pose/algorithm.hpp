// SPDX-License-Identifier: MIT
// How little it takes a robot to get to a pose, in [0, 1] (Weigel, Gutmann, Dietl, Kleiner and Nebel, "CS Freiburg:
// Coordinating Robots for Successful Soccer Playing", IEEE T-RA 18(5), 2002): the way, the turn towards the pose, the
// turn on arrival, and the robots that stand in the way.
//
// Our decisions: the weights of the four parts; each is linear; an obstacle is a robot of either team whose centre is
// less than `clearance` from the straight way, and two count as the worst; within `near` of the pose a robot need not
// turn towards it, so the turns change by and by into the one turn from the robot's heading to the pose's.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "../inverse_distance/angle.hpp"
#include "../places.hpp"

namespace effort_to_pose {

using places::Point, places::Pose;

struct Settings {
  double distance_weight = 0.55, turn_weight = 0.15, final_turn_weight = 0.15, obstacles_weight = 0.15;  // each >= 0
  double farthest = 11.0;       // m, > 0: from here on the way counts as the longest
  double near = 0.3;            // m, > 0
  double clearance = 0.3;       // m
  double most_obstacles = 2.0;  // > 0
};

// Heading as a unit vector.
struct Direction {
  double x, y;
  static Direction of(double angle) { return {std::cos(angle), std::sin(angle)}; }
};

// rad, in [0, pi], between a direction and a vector of `length`; 0 for a vector of no length.
inline double turn(const Direction& from, double dx, double dy, double length) {
  return inverse_distance::angle_between(dx * from.x + dy * from.y, from.x * dy - from.y * dx, length);
}

// Whether a disc of this radius about `centre` reaches the way from `start` to `start` + (dx, dy).
inline bool in_the_way(const Point& centre, const Point& start, double dx, double dy, double radius) {
  const double cx = centre.x - start.x, cy = centre.y - start.y, squared = dx * dx + dy * dy;
  const double along = squared > 0.0 ? std::clamp((cx * dx + cy * dy) / squared, 0.0, 1.0) : 0.0;
  const double ex = cx - along * dx, ey = cy - along * dy;
  return ex * ex + ey * ey < radius * radius;
}

// A pose to get to, with its heading as a direction as well.
struct Target {
  Point at;
  Direction facing;
};

// In [0, 1] for weights whose sum is 1. heading: the robot's. robots: all of both teams but this one.
inline double effort_to_pose(const Point& robot, const Direction& heading, const Target& target,
                             std::span<const Point> robots, const Settings& settings) {
  const double dx = target.at.x - robot.x, dy = target.at.y - robot.y;
  const double distance = std::sqrt(dx * dx + dy * dy);
  const double walks = std::min(1.0, distance / settings.near);
  const double first = walks * turn(heading, dx, dy, distance);
  const double last = walks * turn(target.facing, dx, dy, distance) +
                      (1.0 - walks) * turn(heading, target.facing.x, target.facing.y, 1.0);
  double obstacles = 0.0;
  for (const Point& each : robots) obstacles += in_the_way(each, robot, dx, dy, settings.clearance) ? 1.0 : 0.0;
  return settings.distance_weight * std::max(0.0, 1.0 - distance / settings.farthest) +
         settings.turn_weight * std::max(0.0, 1.0 - first * std::numbers::inv_pi) +
         settings.final_turn_weight * std::max(0.0, 1.0 - last * std::numbers::inv_pi) +
         settings.obstacles_weight * (1.0 - std::min(1.0, obstacles / settings.most_obstacles));
}

}  // namespace effort_to_pose
