// SPDX-License-Identifier: MIT
#include "mind/behaviour/edge_path.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace regista::mind {
namespace {

constexpr double node_reached = 0.3;  // m
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_nodes = plugin::Positioner::point_capacity;

Vector2d at(const plugin::Placement& graph, std::size_t index) {
  return {graph.points[index].x, graph.points[index].y};
}

// The first of equally near ones.
std::size_t nearest_node(const plugin::Placement& graph, const Vector2d& place) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < graph.points.size(); ++i) {
    if ((at(graph, i) - place).squaredNorm() < (at(graph, nearest) - place).squaredNorm()) nearest = i;
  }
  return nearest;
}

}  // namespace

Vector2d along_edges(const plugin::Placement& graph, const Vector2d& from, const Vector2d& to) {
  const std::size_t count = graph.points.size();
  if (count == 0 || count > most_nodes) return to;
  const std::size_t start = nearest_node(graph, from), goal = nearest_node(graph, to);
  if (start == goal) return to;
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
  if ((at(graph, goal) - from).norm() <= node_reached || (to - from).norm() < (to - at(graph, goal)).norm()) return to;

  // Onto the graph by the shortest way, then along it: to an end of an edge that one walks on, the one with the shorter
  // whole way. Only edges that lead to the goal.
  double off = infinity;
  Vector2d entrance = to;
  std::size_t next = count;
  double shortest = infinity;
  for (const regista_edge& edge : graph.edges) {
    if (distance[edge.from] == infinity) continue;
    const Vector2d nearest = nearest_on_segment(at(graph, edge.from), at(graph, edge.to), from);
    const double away = (nearest - from).norm();
    if (away < off) {
      off = away;
      entrance = nearest;
    }
    if (away > node_reached) continue;
    for (const std::size_t end : {std::size_t{edge.from}, std::size_t{edge.to}}) {
      const double whole = distance[end] + (at(graph, end) - from).norm();
      if (whole < shortest - 1e-9 || (whole < shortest + 1e-9 && next < count && distance[end] < distance[next])) {
        shortest = std::min(shortest, whole);
        next = end;
      }
    }
  }
  return next < count ? at(graph, next) : entrance;
}

}  // namespace regista::mind
