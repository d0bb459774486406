// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of diagrams and cells share: points drawn by chance, and whether a cell holds a point.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "cells.hpp"

namespace voronoi {

// Every point anew, x first. x, y: distributions.
template <class X, class Y>
void scatter(std::vector<Point>& points, std::mt19937& random, X x, Y y) {
  for (Point& point : points) {
    point.x = x(random);
    point.y = y(random);
  }
}

// On the rectangle, all places alike.
inline std::vector<Point> random_points(std::mt19937& random, std::size_t count, Extent within) {
  std::vector<Point> points(count);
  scatter(points, random, std::uniform_real_distribution<double>(-within.x, within.x),
          std::uniform_real_distribution<double>(-within.y, within.y));
  return points;
}

// Whether the point is to the left of every side by `margin` (m) or more, which may be negative.
inline bool holds(const Cell& of, const Point& p, double margin) {
  for (std::size_t k = 0; k < of.count; ++k) {
    const Point &a = of.corners[k], &b = of.corners[(k + 1) % of.count];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < margin * length) return false;
  }
  return of.count > 0;
}

}  // namespace voronoi
