// SPDX-License-Identifier: MIT
// Points on a circle, evenly, kept on the field. Knows nothing of Regista, so that it can be tested and used alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

struct Point {
  double x = 0.0, y = 0.0;
};

// The first point lies straight ahead of the centre, the others follow counter-clockwise. edge: half length and half
// width of the field. Fills `out` with `count` points.
inline void ring(Point centre, double radius, int count, Point edge, std::vector<Point>& out) {
  out.clear();
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    out.push_back({std::clamp(centre.x + radius * std::cos(angle), -edge.x, edge.x),
                   std::clamp(centre.y + radius * std::sin(angle), -edge.y, edge.y)});
  }
}
