// SPDX-License-Identifier: MIT
// How little each robot would have to turn to face the opponent's goal: (pi - |a|) / pi of the bearing error a, the
// fourth term of the SPQR team's utility of 2022, weight 0.05. It says something of a robot and nothing of a task, so
// that a row has one value: it decides who takes the more important task, not which task a robot prefers. One angle a
// robot is cheap, so the published form is the default here, unlike in `bearing`; (1 + cos a) / 2 is there too.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include <plugins/utilities/places.hpp>

namespace goal_bearing {

using places::Point, places::Pose;

enum class Form { angle, cosine };

// A goal nearer than this has no bearing worth the name: the utility is 1.
inline constexpr double here = 1e-6;  // m

// In [0, 1]. goal: middle of the goal line.
inline double value(const Pose& robot, const Point& goal, Form form) {
  constexpr double pi = std::numbers::pi;
  const double dx = goal.x - robot.x, dy = goal.y - robot.y;
  const double squared = dx * dx + dy * dy;
  if (squared < here * here) return 1.0;
  if (form == Form::cosine) {
    const double cosine = (dx * std::cos(robot.heading) + dy * std::sin(robot.heading)) / std::sqrt(squared);
    return 0.5 + 0.5 * std::clamp(cosine, -1.0, 1.0);  // rounding
  }
  // Both angles are in [-pi, pi], so that their difference is at most one turn.
  const double turn = std::abs(std::atan2(dy, dx) - robot.heading);
  const double error = turn <= pi ? turn : std::abs(std::remainder(turn, 2.0 * pi));
  return std::max(0.0, 1.0 - error / pi);
}

// out[i * stride + j] for robot i, the same for each of `columns` tasks. stride >= columns.
inline void score(std::span<const Pose> robots, const Point& goal, Form form, double* out, std::size_t columns,
                  std::size_t stride) {
  for (std::size_t i = 0; i < robots.size(); ++i) std::fill_n(out + i * stride, columns, value(robots[i], goal, form));
}

}  // namespace goal_bearing
