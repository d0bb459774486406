// SPDX-License-Identifier: MIT
// Walking along the Voronoi edges: "the optimal path to follow between two adjacent nodes" (Affinita et al. 2023), far
// from every opponent. Shortest path on the graph (Dijkstra 1959), entered and left at the nearest nodes.
#pragma once

#include "mind/geometry.hpp"
#include "plugin/positioner.hpp"

namespace regista::mind {

// The point to walk to next on the way from `from` to `to`: the next node of the path, or `to` itself when there is no
// path, or when the straight way is shorter than the way to the graph.
Vector2d along_edges(const plugin::Placement& graph, const Vector2d& from, const Vector2d& to);

}  // namespace regista::mind
