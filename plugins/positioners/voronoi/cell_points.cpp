// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_points.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace voronoi {
namespace {

double squared(const Point& a, const Point& b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

double nearness(const Point& a, const Point& b, double reach) {
  return std::max(0.0, 1.0 - std::sqrt(squared(a, b)) / reach);
}

Point between(const Point& a, const Point& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

}  // namespace

// From the first corner, so that a small cell far from the centre loses no digits.
Point centroid(const Cell& cell) {
  assert(cell.count >= 3);
  const Point& origin = cell.corners[0];
  double twice_area = 0.0, x = 0.0, y = 0.0;
  for (std::size_t k = 1; k + 1 < cell.count; ++k) {
    const double ax = cell.corners[k].x - origin.x, ay = cell.corners[k].y - origin.y;
    const double bx = cell.corners[k + 1].x - origin.x, by = cell.corners[k + 1].y - origin.y;
    const double part = ax * by - bx * ay;
    twice_area += part;
    x += part * (ax + bx);
    y += part * (ay + by);
  }
  if (!(twice_area > 0.0)) return origin;
  return {origin.x + x / (3.0 * twice_area), origin.y + y / (3.0 * twice_area)};
}

double value_of(const Point& point, std::span<const Point> opponents, const std::optional<Point>& ball,
                const Point& goal, const Attraction& attraction) {
  const double weights = attraction.openness + (ball ? attraction.ball : 0.0) + attraction.goal;
  if (!(weights > 0.0)) return 1.0;
  double least = attraction.full_openness * attraction.full_openness;
  for (const Point& opponent : opponents) least = std::min(least, squared(point, opponent));
  double sum = attraction.openness * std::min(1.0, std::sqrt(least) / attraction.full_openness) +
               attraction.goal * nearness(point, goal, attraction.reach);
  if (ball) sum += attraction.ball * nearness(point, *ball, attraction.reach);
  return sum / weights;
}

Candidate best_point(const Cell& cell, std::span<const Point> opponents, const std::optional<Point>& ball,
                     const Point& goal, const Attraction& attraction) {
  const Point middle = centroid(cell);
  Candidate best{middle, value_of(middle, opponents, ball, goal, attraction)};
  if (!(attraction.openness + (ball ? attraction.ball : 0.0) + attraction.goal > 0.0)) return best;
  for (std::size_t k = 0; k < cell.count; ++k) {
    const Point &corner = cell.corners[k], &next = cell.corners[k + 1 == cell.count ? 0 : k + 1];
    for (const Point& end : {corner, between(corner, next, 0.5)}) {
      for (const double share : {0.5, 0.9}) {
        const Point at = between(middle, end, share);
        const double value = value_of(at, opponents, ball, goal, attraction);
        if (value > best.value) best = {at, value};
      }
    }
  }
  return best;
}

}  // namespace voronoi
