// SPDX-License-Identifier: MIT
// Walking along the Voronoi edges: "the optimal path to follow between two adjacent nodes" (Affinita et al. 2023), far
// from every opponent. Onto the graph by the shortest way, then the shortest path on it (Dijkstra 1959) to the node
// that is nearest to the target, then straight on.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "situation.hpp"

namespace behaviours {

struct EdgePathSettings {
  double node_reached = 0.3;  // m: as near to a node or an edge as this, the robot is on it
};

// Keeps the memory that the search needs, and nothing else from call to call.
class EdgePath {
 public:
  void reserve(std::size_t nodes) {
    distance_.reserve(nodes);
    done_.reserve(nodes);
  }

  // The point to walk to next on the way from `from` to `to`: the nearest point of the nearest edge that leads there;
  // on an edge, its better end; `to` itself at the last node, when no edge leads there, or when the straight way is
  // shorter than the ways to the first node and from the last.
  Vector2d next(const Graph& graph, const EdgePathSettings& settings, const Vector2d& from, const Vector2d& to) {
    if (graph.nodes.empty()) return to;
    const std::size_t start = nearest_node(graph, from), goal = nearest_node(graph, to);
    if (start == goal) return to;
    const Vector2d& last = graph.nodes[goal];
    if ((to - from).norm() <= (graph.nodes[start] - from).norm() + (last - to).norm()) return to;
    measure(graph, goal);
    if ((last - from).norm() <= settings.node_reached || (to - from).norm() < (to - last).norm()) return to;
    return enter(graph, settings, from, to);
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // The first of equally near ones.
  static std::size_t nearest_node(const Graph& graph, const Vector2d& place) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < graph.nodes.size(); ++i) {
      if ((graph.nodes[i] - place).squaredNorm() < (graph.nodes[nearest] - place).squaredNorm()) nearest = i;
    }
    return nearest;
  }

  // Distances to the goal along the edges. Small graphs: no heap.
  void measure(const Graph& graph, std::size_t goal) {
    const std::size_t count = graph.nodes.size();
    distance_.assign(count, infinity);
    done_.assign(count, 0);
    distance_[goal] = 0.0;
    for (;;) {
      std::size_t nearest = count;
      for (std::size_t i = 0; i < count; ++i) {
        const bool open = done_[i] == 0 && distance_[i] < infinity;
        if (open && (nearest == count || distance_[i] < distance_[nearest])) nearest = i;
      }
      if (nearest == count) return;
      done_[nearest] = 1;
      for (const Edge& edge : graph.edges) {
        if (edge.from != nearest && edge.to != nearest) continue;
        const std::size_t other = edge.from == nearest ? edge.to : edge.from;
        const double through = distance_[nearest] + (graph.nodes[nearest] - graph.nodes[other]).norm();
        distance_[other] = std::min(distance_[other], through);
      }
    }
  }

  // Onto the graph by the shortest way, then along it: to an end of an edge that one walks on, the one with the shorter
  // whole way. Only edges that lead to the goal.
  Vector2d enter(const Graph& graph, const EdgePathSettings& settings, const Vector2d& from, const Vector2d& to) const {
    constexpr double equal = 1e-9;  // m between two ways that are equally long
    const std::size_t count = graph.nodes.size();
    double off = infinity;
    Vector2d entrance = to;
    std::size_t next = count;
    double shortest = infinity;
    for (const Edge& edge : graph.edges) {
      if (distance_[edge.from] == infinity) continue;
      const Vector2d nearest = nearest_on_segment(graph.nodes[edge.from], graph.nodes[edge.to], from);
      const double away = (nearest - from).norm();
      if (away < off) {
        off = away;
        entrance = nearest;
      }
      if (away > settings.node_reached) continue;
      for (const std::size_t end : {std::size_t{edge.from}, std::size_t{edge.to}}) {
        const double whole = distance_[end] + (graph.nodes[end] - from).norm();
        const bool as_long = whole < shortest + equal && next < count && distance_[end] < distance_[next];
        if (whole < shortest - equal || as_long) {
          shortest = std::min(shortest, whole);
          next = end;
        }
      }
    }
    return next < count ? graph.nodes[next] : entrance;
  }

  std::vector<double> distance_;  // m along the edges to the goal, per node
  std::vector<char> done_;
};

}  // namespace behaviours
