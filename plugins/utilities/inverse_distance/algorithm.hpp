// SPDX-License-Identifier: MIT
// The SPQR team's utility of 2023 but for its persistence p, which is a term of its own: 1 / (d + eps) + w / (|a| +
// eps), with d the distance to the target in metres, a the bearing error in radians, eps = 1e-10, and w = 0 in 2023 and
// 0.01 in 2024. It is nearly blind to robots far away and lets the one on the spot win against every other term.
#pragma once

#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>

#include "../places.hpp"
#include "angle.hpp"

namespace inverse_distance {

using places::Pose, places::Targets;

struct Settings {
  double eps = 1e-10;           // added to metres and to radians, > 0
  double bearing_weight = 0.0;  // w >= 0
};

// out[i * stride + j] in (0, (1 + w) / eps] for robot i and target j. A robot on the spot has no bearing error. stride
// >= number of targets.
inline void score(std::span<const Pose> robots, const Targets& targets, const Settings& settings, double* out,
                  std::size_t stride) {
  assert(settings.eps > 0.0 && targets.x.size() == targets.y.size());
  const double eps = settings.eps, weight = settings.bearing_weight;
  const std::size_t columns = targets.x.size();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const Pose& robot = robots[i];
    double* row = out + i * stride;
    if (weight == 0.0) {
      for (std::size_t j = 0; j < columns; ++j) {
        const double dx = targets.x[j] - robot.x, dy = targets.y[j] - robot.y;
        row[j] = 1.0 / (std::sqrt(dx * dx + dy * dy) + eps);
      }
      continue;
    }
    const double ahead_x = std::cos(robot.heading), ahead_y = std::sin(robot.heading);
    for (std::size_t j = 0; j < columns; ++j) {
      const double dx = targets.x[j] - robot.x, dy = targets.y[j] - robot.y;
      const double distance = std::sqrt(dx * dx + dy * dy);
      const double error = angle_between(dx * ahead_x + dy * ahead_y, ahead_x * dy - ahead_y * dx, distance);
      row[j] = 1.0 / (distance + eps) + weight / (error + eps);
    }
  }
}

}  // namespace inverse_distance
