// SPDX-License-Identifier: MIT
#include "recording/clipped.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace regista::recording::picture {
namespace {

constexpr double farthest = 1e9;  // so that no difference of two numbers overflows

Point bounded(const Point& p) { return {std::clamp(p[0], -farthest, farthest), std::clamp(p[1], -farthest, farthest)}; }

Point between(const Point& a, const Point& b, double share) {
  return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
}

// One edge of the rectangle: `axis` is 0 for x, 1 for y; inside is where sign * coordinate is at most sign * limit.
struct Edge {
  std::size_t axis;
  double sign, limit;

  double beyond(const Point& p) const { return sign * (p[axis] - limit); }
  // Where the way from one side to the other meets it.
  Point crossing(const Point& a, const Point& b) const {
    Point out = between(a, b, beyond(a) / (beyond(a) - beyond(b)));
    out[axis] = limit;
    return out;
  }
};

std::array<Edge, 4> edges(const Rectangle& r) {
  return {{{0, -1.0, r.left}, {0, 1.0, r.right}, {1, -1.0, r.low}, {1, 1.0, r.high}}};
}

}  // namespace

std::vector<std::vector<Point>> clipped_line(std::span<const Point> line, const Rectangle& to) {
  std::vector<std::vector<Point>> out;
  bool goes_on = false;  // the last piece ends where the next part begins
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    Point a = bounded(line[i]), b = bounded(line[i + 1]);
    bool inside = true, cut_at_end = false;
    for (const Edge& edge : edges(to)) {
      const double from_a = edge.beyond(a), from_b = edge.beyond(b);
      inside = inside && (from_a <= 0.0 || from_b <= 0.0);
      if (!inside) break;
      if (from_a > 0.0) {
        a = edge.crossing(a, b);
        goes_on = false;
      } else if (from_b > 0.0) {
        b = edge.crossing(a, b);
        cut_at_end = true;
      }
    }
    if (!inside) {
      goes_on = false;
      continue;
    }
    if (!goes_on) out.push_back({a});
    out.back().push_back(b);
    goes_on = !cut_at_end;
  }
  return out;
}

std::vector<Point> clipped_polygon(std::span<const Point> corners, const Rectangle& to) {
  std::vector<Point> out;
  for (const Point& corner : corners) out.push_back(bounded(corner));
  for (const Edge& edge : edges(to)) {
    std::vector<Point> before;
    before.swap(out);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Point &a = before[i == 0 ? before.size() - 1 : i - 1], &b = before[i];
      const double from_a = edge.beyond(a), from_b = edge.beyond(b);
      if ((from_a > 0.0) != (from_b > 0.0)) out.push_back(edge.crossing(a, b));
      if (from_b <= 0.0) out.push_back(b);
    }
  }
  return out;
}

}  // namespace regista::recording::picture
