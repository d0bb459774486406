// SPDX-License-Identifier: MIT
// What of a line or a polygon lies within a rectangle. A plugin may draw to the end of the world, but programs that
// show pictures count in numbers that end somewhere: what is written into a picture lies near it.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace regista::recording::picture {

using Point = std::array<double, 2>;

struct Rectangle {
  double left = 0.0, low = 0.0, right = 0.0, high = 0.0;

  bool holds(const Point& p) const { return p[0] >= left && p[0] <= right && p[1] >= low && p[1] <= high; }
};

// The pieces of an open line. Precondition of both: finite numbers.
std::vector<std::vector<Point>> clipped_line(std::span<const Point> line, const Rectangle& to);

// The corners of a closed polygon, by Sutherland and Hodgman (Reentrant polygon clipping, Communications of the ACM
// 17(1), 1974): pieces of one that leaves the rectangle and comes back hang together along its edge.
std::vector<Point> clipped_polygon(std::span<const Point> corners, const Rectangle& to);

}  // namespace regista::recording::picture
