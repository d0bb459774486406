// SPDX-License-Identifier: MIT
// Where robots and targets are, as the algorithms of utilities read it. Field frame.
#pragma once

#include <span>

namespace places {

struct Point {
  double x, y;  // m
};

struct Pose {
  double x, y, heading;  // m, m, rad
};

// Coordinates of the targets, one array each, so that a row is computed in vector registers.
struct Targets {
  std::span<const double> x, y;  // m, of equal length
};

}  // namespace places
