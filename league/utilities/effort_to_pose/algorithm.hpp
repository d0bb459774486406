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

#include <plugins/utilities/inverse_distance/angle.hpp>
#include <plugins/utilities/places.hpp>

namespace effort_to_pose {

using places::Point;

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

// Poses to get to, each with its heading as a direction: one array for each number, so that several are computed at
// once.
struct Goals {
  std::span<const double> x, y, facing_x, facing_y;
};

// Where robots are, seen from another one: m, along the axes of the field.
struct Offsets {
  std::span<const double> x, y;
};

// Whether a disc of this radius about `centre` reaches the way by (dx, dy) from the origin.
inline bool in_the_way(const Point& centre, double dx, double dy, double radius) {
  const double squared = dx * dx + dy * dy;
  const double along = squared > 0.0 ? std::clamp((centre.x * dx + centre.y * dy) / squared, 0.0, 1.0) : 0.0;
  const double ex = centre.x - along * dx, ey = centre.y - along * dy;
  return ex * ex + ey * ey < radius * radius;
}

// Returns how many of the others block the straight way from the origin to (dx, dy), but at most `enough`. The cross
// product first leaves out robots that are farther than `radius` from the infinite line through the way: most of them.
// Its margin is so large that rounding leaves out no robot that blocks.
inline double count_in_the_way(const Offsets& others, double dx, double dy, double radius, double enough) {
  const double beyond = radius * (1.0 + 1e-9) + 1e-9, far = beyond * beyond * (dx * dx + dy * dy);
  double count = 0.0;
  for (std::size_t k = 0; k < others.x.size(); ++k) {
    const Point at{others.x[k], others.y[k]};
    const double cross = at.x * dy - at.y * dx;
    if (cross * cross > far || !in_the_way(at, dx, dy, radius)) continue;
    count += 1.0;
    if (count >= enough) break;
  }
  return count;
}

// out[j] in [0, 1] for goal j, for weights whose sum is 1. heading: the robot's. others: the robots of both teams but
// this one. out: as many as goals.
inline void score_row(const Point& robot, const Direction& heading, const Goals& goals, const Offsets& others,
                      const Settings& settings, double* out) {
  assert(others.x.size() == others.y.size());
  const std::size_t columns = goals.x.size();
  for (std::size_t j = 0; j < columns; ++j) {
    out[j] = count_in_the_way(others, goals.x[j] - robot.x, goals.y[j] - robot.y, settings.clearance,
                              settings.most_obstacles);
  }
  const Settings s = settings;
  for (std::size_t j = 0; j < columns; ++j) {
    const double dx = goals.x[j] - robot.x, dy = goals.y[j] - robot.y;
    const Direction facing{goals.facing_x[j], goals.facing_y[j]};
    const double distance = std::sqrt(dx * dx + dy * dy);
    const double walks = std::min(1.0, distance / s.near);
    const double first = walks * turn(heading, dx, dy, distance);
    const double last = walks * turn(facing, dx, dy, distance) + (1.0 - walks) * turn(heading, facing.x, facing.y, 1.0);
    out[j] = s.distance_weight * std::max(0.0, 1.0 - distance / s.farthest) +
             s.turn_weight * std::max(0.0, 1.0 - first * std::numbers::inv_pi) +
             s.final_turn_weight * std::max(0.0, 1.0 - last * std::numbers::inv_pi) +
             s.obstacles_weight * (1.0 - std::min(1.0, out[j] / s.most_obstacles));
  }
}

}  // namespace effort_to_pose
