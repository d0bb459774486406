// SPDX-License-Identifier: MIT
// The Delaunay triangulation of a formation's samples. Inserted one by one (Bowyer 1981; Watson 1981) in the file's
// order, because that order decides here: samples that mirror each other lie on one circle, where the triangulation is
// not unique, and librcsc inserts them so too. Of samples on an empty circle the first three make a triangle.
// Predicates are exact: samples are points of a grid.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace formations {

// Grid points; |x|, |y| <= grid_limit.
struct GridPoint {
  std::int64_t x, y;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
  friend auto operator<=>(const GridPoint&, const GridPoint&) = default;  // by x, then y
};

inline constexpr std::int64_t grid_limit = 10'000'000;

struct Triangulation {
  static constexpr int outside = -1;
  struct Triangle {
    std::array<int, 3> corner;     // counter-clockwise
    std::array<int, 3> neighbour;  // across the side from corner k to corner k + 1, or `outside`
  };
  std::vector<Triangle> triangles;         // none when all points are on one line
  std::vector<std::array<int, 2>> border;  // sides of the convex hull; on one line: the pieces of that line; one point:
                                           // from it to itself
};

// Points are distinct, at least one. Time grows with the square of their number.
Triangulation triangulate(std::span<const GridPoint> points);

}  // namespace formations
