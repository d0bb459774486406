// SPDX-License-Identifier: MIT
// Walking along the Voronoi edges: "the optimal path to follow between two adjacent nodes" (Affinita et al. 2023), far
// from every opponent. Onto the graph by the shortest way, then the shortest path on it (Dijkstra 1959) to the node
// that is nearest to the target, then straight on.
#pragma once

#include "mind/geometry.hpp"
#include "plugin/positioner.hpp"

namespace regista::mind {

// The point to walk to next on the way from `from` to `to`: the nearest point of the nearest edge that leads there; on
// an edge, its better end; `to` itself at the last node, when no edge leads there, or when the straight way is shorter
// than the ways to the first node and from the last.
Vector2d along_edges(const plugin::Placement& graph, const Vector2d& from, const Vector2d& to);

}  // namespace regista::mind
