// SPDX-License-Identifier: MIT
// Voronoi cells of points, by their definition: what is nearer to one than to every other. A point that is as near to
// two belongs to the first of them, so that every point of the plane is in exactly one cell.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace formation_cells {

struct Point {
  double x = 0.0, y = 0.0;  // m, field frame
};

inline double squared(const Point& a, const Point& b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

// The site whose cell the point is in; sites is not empty.
inline std::size_t cell_of(const Point& point, std::span<const Point> sites) {
  std::size_t best = 0;
  double least = squared(point, sites[0]);
  for (std::size_t i = 1; i < sites.size(); ++i) {
    const double d = squared(point, sites[i]);
    if (d < least) {
      least = d;
      best = i;
    }
  }
  return best;
}

inline bool in_cell(const Point& point, std::span<const Point> sites, std::size_t own) {
  const double d = squared(point, sites[own]);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (i == own) continue;
    const double other = squared(point, sites[i]);
    if (i < own ? !(d < other) : !(d <= other)) return false;
  }
  return true;
}

// m from the point to the nearest border of its cell, infinity for a cell without one. The point is in the cell `own`.
inline double from_border(const Point& point, std::span<const Point> sites, std::size_t own) {
  double least = std::numeric_limits<double>::infinity();
  const double d = squared(point, sites[own]);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const double between = squared(sites[i], sites[own]);
    if (i == own || !(between > 0.0)) continue;
    const double away = (squared(point, sites[i]) - d) / (2.0 * std::sqrt(between));
    if (away < least) least = away;
  }
  return least > 0.0 ? least : 0.0;
}

}  // namespace formation_cells
