// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace voronoi {
namespace {

constexpr double coincident = 1e-9;  // m

// Signed: positive where `other` is the nearer one. Exchanging the sites changes nothing but the sign, so that
// neighbours are cut by the same line to the last bit.
class Bisector {
 public:
  Bisector(const Point& own, const Point& other)
      : middle_{own.x / 2.0 + other.x / 2.0, own.y / 2.0 + other.y / 2.0}, normal_{other.x - own.x, other.y - own.y} {
    const double larger = std::max(std::abs(normal_.x), std::abs(normal_.y));
    normal_.x /= larger;  // else the products of sites hardly apart underflow
    normal_.y /= larger;
  }
  double beyond(const Point& p) const { return (p.x - middle_.x) * normal_.x + (p.y - middle_.y) * normal_.y; }

 private:
  Point middle_, normal_;
};

Point crossing(const Point& inside, double depth, const Point& outside, double height, const Extent& field) {
  const double t = depth / (depth - height);  // depth <= 0 < height
  return {std::clamp(inside.x + t * (outside.x - inside.x), -field.x, field.x),
          std::clamp(inside.y + t * (outside.y - inside.y), -field.y, field.y)};
}

// What is beyond the bisector is one run of corners, also where rounding sees more than one: it is taken around the
// farthest corner. So one cut takes at least one corner and adds at most two.
void cut(Cell& cell, const Bisector& bisector, const Extent& field) {
  const std::size_t n = cell.count;
  std::array<double, most_cell_corners> beyond;
  std::size_t farthest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    beyond[k] = bisector.beyond(cell.corners[k]);
    if (beyond[k] > beyond[farthest]) farthest = k;
  }
  if (!(beyond[farthest] > 0.0)) return;

  const auto after = [n](std::size_t k) { return k + 1 == n ? 0 : k + 1; };
  const auto before = [n](std::size_t k) { return k == 0 ? n - 1 : k - 1; };
  std::size_t first = after(farthest);
  while (first != farthest && beyond[first] > 0.0) first = after(first);
  if (first == farthest) {
    cell.count = 0;
    return;
  }
  std::size_t last = before(farthest);
  while (beyond[last] > 0.0) last = before(last);

  Cell rest;
  const auto add = [&rest](const Point& p) { rest.corners[rest.count++] = p; };
  if (beyond[first] < 0.0) {
    const std::size_t out = before(first);
    add(crossing(cell.corners[first], beyond[first], cell.corners[out], beyond[out], field));
  }
  for (std::size_t k = first; k != last; k = after(k)) add(cell.corners[k]);
  add(cell.corners[last]);
  if (beyond[last] < 0.0) {
    const std::size_t out = after(last);
    add(crossing(cell.corners[last], beyond[last], cell.corners[out], beyond[out], field));
  }
  cell = rest;
}

bool same_spot(const Point& a, const Point& b) {
  return std::abs(a.x - b.x) < coincident && std::abs(a.y - b.y) < coincident;
}

void drop_repeated(Cell& cell) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < cell.count; ++k) {
    if (kept == 0 || !same_spot(cell.corners[kept - 1], cell.corners[k])) cell.corners[kept++] = cell.corners[k];
  }
  while (kept > 1 && same_spot(cell.corners[kept - 1], cell.corners[0])) --kept;
  cell.count = kept < 3 ? 0 : kept;
}

}  // namespace

Cell cell(std::span<const Point> sites, std::size_t own, const Extent& field) {
  assert(own < sites.size() && sites.size() <= most_cell_sites);
  Cell out;
  for (std::size_t k = 0; k < own; ++k) {
    if (sites[k] == sites[own]) return out;
  }
  for (const Point& corner :
       {Point{-field.x, -field.y}, Point{field.x, -field.y}, Point{field.x, field.y}, Point{-field.x, field.y}}) {
    out.corners[out.count++] = corner;
  }
  for (std::size_t k = 0; k < sites.size() && out.count > 0; ++k) {
    if (sites[k] != sites[own]) cut(out, Bisector(sites[own], sites[k]), field);
  }
  drop_repeated(out);
  return out;
}

}  // namespace voronoi
