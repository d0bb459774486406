// SPDX-License-Identifier: MIT
#include "mind/behaviour/edge_path.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "mind/coordination/task_filter.hpp"

namespace regista::mind {
namespace {

constexpr double node_reached = 0.3;  // m
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_nodes = plugin::Positioner::point_capacity;

Vector2d at(const plugin::Placement& graph, std::size_t index) {
  return {graph.points[index].x, graph.points[index].y};
}

}  // namespace

Vector2d along_edges(const plugin::Placement& graph, const Vector2d& from, const Vector2d& to) {
  const int first = nearest_waypoint(graph.points, from.x(), from.y());
  const int last = nearest_waypoint(graph.points, to.x(), to.y());
  if (first < 0 || first == last || graph.points.size() > most_nodes) return to;
  const auto start = static_cast<std::size_t>(first), goal = static_cast<std::size_t>(last);
  const std::size_t count = graph.points.size();
  if ((to - from).norm() <= (at(graph, start) - from).norm() + (at(graph, goal) - to).norm()) return to;

  // Distances to the goal. Small graphs: no heap.
  std::array<double, most_nodes> distance;
  std::array<bool, most_nodes> done;
  for (std::size_t i = 0; i < count; ++i) {
    distance[i] = infinity;
    done[i] = false;
  }
  distance[goal] = 0.0;
  for (;;) {
    std::size_t nearest = count;
    for (std::size_t i = 0; i < count; ++i) {
      if (!done[i] && distance[i] < infinity && (nearest == count || distance[i] < distance[nearest])) nearest = i;
    }
    if (nearest == count) break;
    done[nearest] = true;
    for (const regista_edge& edge : graph.edges) {
      if (edge.from != nearest && edge.to != nearest) continue;
      const std::size_t other = edge.from == nearest ? edge.to : edge.from;
      const double through = distance[nearest] + (at(graph, nearest) - at(graph, other)).norm();
      distance[other] = std::min(distance[other], through);
    }
  }
  // The graph is entered where the whole way is shortest, so that nobody is sent back to a node that lies behind.
  std::size_t entry = count;
  double shortest = infinity;
  for (std::size_t i = 0; i < count; ++i) {
    const double whole = distance[i] + (at(graph, i) - from).norm();
    if (whole < shortest) {
      shortest = whole;
      entry = i;
    }
  }
  if (entry == count) return to;
  const bool reached = (at(graph, goal) - from).norm() <= node_reached;
  const bool past = (to - from).norm() < (to - at(graph, goal)).norm();
  return entry == goal && (reached || past) ? to : at(graph, entry);
}

}  // namespace regista::mind
