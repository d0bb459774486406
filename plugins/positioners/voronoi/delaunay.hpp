// SPDX-License-Identifier: GPL-3.0-or-later
// The Delaunay triangulation of a few sites, by CGAL: exact predicates, so that no input breaks it.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace voronoi {

struct Point {
  double x, y;
  friend bool operator==(const Point&, const Point&) = default;
  friend auto operator<=>(const Point&, const Point&) = default;  // by x, then y
};

class Delaunay {
 public:
  static constexpr int outside = -1;

  // Indices of three sites, counter-clockwise.
  using Triangle = std::array<int, 3>;
  // From site `a` to site `b`; the triangles on its left and right, or `outside`.
  struct Edge {
    int a, b, left, right;
  };

  Delaunay();
  ~Delaunay();
  Delaunay(Delaunay&&) noexcept;
  Delaunay& operator=(Delaunay&&) noexcept;

  // Sites are finite and distinct. Sites on one circle are triangulated in one way whatever their order. Fewer than
  // three sites, or all on one line: no triangles. Memory is kept for the next call: sites in ascending order, of which
  // the first three are not on one line, allocate nothing once there was room for as many, and are the fastest. Throws
  // std::runtime_error should CGAL fail.
  void build(std::span<const Point> sites);

  // Of the last build; in no particular order.
  std::span<const Triangle> triangles() const { return triangles_; }
  std::span<const Edge> edges() const { return edges_; }

 private:
  struct Triangulation;
  void read_triangles(Triangulation& triangulation);

  std::unique_ptr<Triangulation> triangulation_;
  std::vector<Triangle> triangles_;
  std::vector<Edge> edges_;
};

}  // namespace voronoi
