// SPDX-License-Identifier: GPL-3.0-or-later
// Voronoi cells of a team on the field: what is nearer to one robot than to every other. By that definition a cell is
// the field's rectangle cut by the half-plane of each bisector in turn, which for a team's few robots needs no
// triangulation and holds wherever they are.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "algorithm.hpp"

namespace voronoi {

inline constexpr std::size_t most_cell_sites = 32;
inline constexpr std::size_t most_cell_corners = 4 + (most_cell_sites - 1);  // each cut adds at most one

// Convex; m, field frame.
struct Cell {
  std::array<Point, most_cell_corners> corners;  // the first `count`, counter-clockwise
  std::size_t count = 0;                         // 0 or at least 3

  std::span<const Point> span() const { return {corners.data(), count}; }
};

// The part of the field that is nearest to site `own`. Sites are finite, at most most_cell_sites, and may be off the
// field; of those on the very same spot the first has the cell and the others have none. Cells of all sites cover the
// field once. Corners nearer to each other than 1e-9 m are one; what has no area left is empty.
Cell cell(std::span<const Point> sites, std::size_t own, const Extent& field);

}  // namespace voronoi
