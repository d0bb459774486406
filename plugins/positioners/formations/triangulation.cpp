// SPDX-License-Identifier: MIT
#include "triangulation.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace formations {
namespace {

__extension__ using Wide = __int128;

constexpr int infinity = -1;  // the corner that closes the plane: every side of the hull has a triangle to it

using Corners = std::array<int, 3>;
using Side = std::array<int, 2>;

class Insertion {
 public:
  explicit Insertion(std::span<const GridPoint> points) : points_(points) {}

  // > 0 when c is to the left of a -> b. Differences have 25 bits.
  std::int64_t turn(int a, int b, int c) const {
    const GridPoint &p = at(a), &q = at(b), &r = at(c);
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }

  void first_triangle(int a, int b, int c) {
    if (turn(a, b, c) < 0) std::swap(b, c);
    triangles_ = {{a, b, c}, {b, a, infinity}, {c, b, infinity}, {a, c, infinity}};
  }

  // What p is in conflict with is one region around it: it is emptied and filled with triangles from its sides to p.
  void insert(int p) {
    sides_.clear();
    std::erase_if(triangles_, [&](const Corners& t) {
      if (!in_conflict(t, p)) return false;
      for (std::size_t k = 0; k < 3; ++k) sides_.push_back({t[k], t[(k + 1) % 3]});
      return true;
    });
    assert(!sides_.empty());
    for (const Side& side : sides_) {
      const Side back{side[1], side[0]};
      if (std::ranges::find(sides_, back) == sides_.end()) add(side[0], side[1], p);
    }
  }

  const std::vector<Corners>& triangles() const { return triangles_; }

 private:
  const GridPoint& at(int index) const { return points_[static_cast<std::size_t>(index)]; }

  void add(int a, int b, int c) {  // the corner at infinity comes last
    if (a == infinity) {
      triangles_.push_back({b, c, a});
    } else if (b == infinity) {
      triangles_.push_back({c, a, b});
    } else {
      triangles_.push_back({a, b, c});
    }
  }

  bool in_conflict(const Corners& t, int p) const {
    if (t[2] != infinity) return in_circle(t, p);
    const std::int64_t side = turn(t[0], t[1], p);  // the outside is to the left
    if (side != 0) return side > 0;
    const auto [low, high] = std::minmax(at(t[0]), at(t[1]));
    return low < at(p) && at(p) < high;
  }

  // Strictly. 104 bits.
  bool in_circle(const Corners& t, int p) const {
    const GridPoint& o = at(p);
    const auto x = [&](std::size_t k) { return at(t[k]).x - o.x; };
    const auto y = [&](std::size_t k) { return at(t[k]).y - o.y; };
    const auto minor = [&](std::size_t i, std::size_t j) { return x(i) * y(j) - x(j) * y(i); };
    const auto square = [&](std::size_t k) { return x(k) * x(k) + y(k) * y(k); };
    return Wide{square(0)} * minor(1, 2) + Wide{square(1)} * minor(2, 0) + Wide{square(2)} * minor(0, 1) > 0;
  }

  std::span<const GridPoint> points_;
  std::vector<Corners> triangles_;
  std::vector<Side> sides_;
};

// A side of a triangle, without direction.
struct Half {
  int low, high, triangle;
  std::size_t side;
  bool same_side(const Half& other) const { return low == other.low && high == other.high; }
};

void join(Triangulation& out) {
  std::vector<Half> halves;
  for (std::size_t t = 0; t < out.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = out.triangles[t].corner[k], b = out.triangles[t].corner[(k + 1) % 3];
      halves.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t), k});
    }
  }
  std::ranges::sort(halves, {}, [](const Half& h) { return std::array{h.low, h.high, h.triangle}; });
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const Half& half = halves[i];
    Triangulation::Triangle& triangle = out.triangles[static_cast<std::size_t>(half.triangle)];
    const bool next = i + 1 < halves.size() && half.same_side(halves[i + 1]);
    const bool before = i > 0 && half.same_side(halves[i - 1]);
    triangle.neighbour[half.side] = next     ? halves[i + 1].triangle
                                    : before ? halves[i - 1].triangle
                                             : Triangulation::outside;
    if (!next && !before) out.border.push_back({triangle.corner[half.side], triangle.corner[(half.side + 1) % 3]});
  }
}

// All on one line: from point to point along it.
std::vector<Side> pieces(std::span<const GridPoint> points) {
  std::vector<int> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::ranges::sort(order, {}, [&](int i) { return points[static_cast<std::size_t>(i)]; });
  std::vector<Side> out;
  for (std::size_t i = 0; i + 1 < order.size(); ++i) out.push_back({order[i], order[i + 1]});
  if (out.empty()) out.push_back({0, 0});
  return out;
}

}  // namespace

Triangulation triangulate(std::span<const GridPoint> points) {
  assert(!points.empty());
  Triangulation out;
  Insertion insertion(points);
  const int count = static_cast<int>(points.size());
  int third = 2;
  while (third < count && insertion.turn(0, 1, third) == 0) ++third;
  if (third >= count) {
    out.border = pieces(points);
    return out;
  }
  // Taking the third one early changes nothing: of those before it a circle has two at most.
  insertion.first_triangle(0, 1, third);
  for (int p = 2; p < count; ++p) {
    if (p != third) insertion.insert(p);
  }
  for (const Corners& corners : insertion.triangles()) {
    if (corners[2] != infinity) out.triangles.push_back({corners, {}});
  }
  join(out);
  return out;
}

}  // namespace formations
