// SPDX-License-Identifier: MIT
// How near each robot is to each target: max(0, (D - d) / D), 1 at the target, 0 from the distance D on. It is the
// first term of the SPQR team's utility of 2022, with weight 0.7 and D = 11 m, about the diagonal of the 9 m x 6 m
// field.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>

#include "../places.hpp"

namespace distance_utility {

using places::Point, places::Targets;

// out[i * stride + j] in [0, 1] for robot i and target j. reach: D > 0, m. stride >= number of targets.
inline void score(std::span<const Point> robots, const Targets& targets, double reach, double* out,
                  std::size_t stride) {
  assert(reach > 0.0 && targets.x.size() == targets.y.size());
  const double per_metre = 1.0 / reach;
  const std::size_t columns = targets.x.size();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    double* row = out + i * stride;
    for (std::size_t j = 0; j < columns; ++j) {
      const double dx = targets.x[j] - robots[i].x, dy = targets.y[j] - robots[i].y;
      row[j] = std::max(0.0, 1.0 - std::sqrt(dx * dx + dy * dy) * per_metre);
    }
  }
}

}  // namespace distance_utility
