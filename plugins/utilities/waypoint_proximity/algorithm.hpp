// SPDX-License-Identifier: MIT
// The paper's "portion of the reward" that comes from V (Affinita et al. 2023, "Conclusions"): a task is worth more
// the nearer it is to a desirable point. A point that belongs to a task counts for that task alone, one that belongs to
// a robot for that robot alone. The paper gives no formula; both forms here are 1 at a point of score 1.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "../places.hpp"

namespace waypoint_utility {

using places::Point;

enum class Form { inverse, linear };  // 1 / (1 + d / scale), max(0, 1 - d / scale)

struct Waypoint {
  double x, y;
  double score;   // >= 0
  int task = -1;  // column it belongs to, -1: to none
  int robot = 0;  // shirt number it belongs to, 0: to nobody
};

struct Settings {
  Form form = Form::inverse;
  double scale = 1.0;    // m, > 0
  bool weighted = true;  // multiply by the waypoint's score
};

// Nearness in [0, score of the waypoint] of one target in column `column` for robot `number`; 0 without waypoints. Of
// equally near waypoints the best counts.
inline double nearness(const Point& target, std::span<const Waypoint> waypoints, int column, int number,
                       const Settings& settings) {
  double least = std::numeric_limits<double>::infinity(), score = 0.0;
  for (const Waypoint& point : waypoints) {
    if ((point.task >= 0 && point.task != column) || (point.robot != 0 && point.robot != number)) continue;
    const double dx = point.x - target.x, dy = point.y - target.y;
    const double squared = dx * dx + dy * dy;
    if (squared < least || (squared == least && point.score > score)) {
      least = squared;
      score = point.score;
    }
  }
  if (least == std::numeric_limits<double>::infinity()) return 0.0;
  const double scaled = std::sqrt(least) / settings.scale;
  const double near = settings.form == Form::inverse ? 1.0 / (1.0 + scaled) : std::max(0.0, 1.0 - scaled);
  return settings.weighted ? near * score : near;
}

// out[i * stride + j] for the robot with shirt number numbers[i] and target j. stride >= number of targets.
inline void score(std::span<const int> numbers, std::span<const Point> targets, std::span<const Waypoint> waypoints,
                  const Settings& settings, double* out, std::size_t stride) {
  assert(settings.scale > 0.0);
  const bool personal =
      std::any_of(waypoints.begin(), waypoints.end(), [](const Waypoint& point) { return point.robot != 0; });
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    double* row = out + i * stride;
    if (i > 0 && !personal) {
      std::copy_n(out, targets.size(), row);  // the same for every robot
      continue;
    }
    for (std::size_t j = 0; j < targets.size(); ++j) {
      row[j] = nearness(targets[j], waypoints, static_cast<int>(j), numbers[i], settings);
    }
  }
}

}  // namespace waypoint_utility
