// SPDX-License-Identifier: MIT
// The paper's "portion of the reward" that comes from V (Affinita et al. 2023, "Conclusions"), for each robot and task:
// how near the robot is to the node that belongs to the task. Straight, or over the graph, whose edges are "the optimal
// path to follow between two adjacent nodes": to the nearest node, then along the edges. The paper gives no formula;
// this one is the first term of the SPQR team's utility, max(0, 1 - d / reach), with the node in the place of the task.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "../places.hpp"

namespace waypoint_distance {

using places::Point;

inline constexpr double infinity = std::numeric_limits<double>::infinity();

struct Edge {
  std::size_t from, to;  // undirected
};

struct Graph {
  std::span<const Point> nodes;
  std::span<const Edge> edges;
};

inline double distance(const Point& a, const Point& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

// Lengths of the shortest ways along the edges from every node to `goal` (Dijkstra 1959; the graphs are too small for a
// heap), infinity where there is none.
class Ways {
 public:
  std::span<const double> to(std::size_t goal, const Graph& graph) {
    const std::size_t count = graph.nodes.size();
    length_.assign(count, infinity);
    done_.assign(count, 0);
    length_[goal] = 0.0;
    for (;;) {
      std::size_t nearest = count;
      for (std::size_t i = 0; i < count; ++i) {
        if (done_[i] == 0 && length_[i] < (nearest == count ? infinity : length_[nearest])) nearest = i;
      }
      if (nearest == count) return length_;
      done_[nearest] = 1;
      for (const Edge& edge : graph.edges) {
        if (edge.from != nearest && edge.to != nearest) continue;
        const std::size_t other = edge.from == nearest ? edge.to : edge.from;
        const double through = length_[nearest] + distance(graph.nodes[nearest], graph.nodes[other]);
        length_[other] = std::min(length_[other], through);
      }
    }
  }

 private:
  std::vector<double> length_;
  std::vector<char> done_;
};

// The first of equally near ones; there is at least one.
inline std::size_t nearest_node(const Point& place, std::span<const Point> nodes) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (distance(place, nodes[i]) < distance(place, nodes[nearest])) nearest = i;
  }
  return nearest;
}

struct Settings {
  double reach = 11.0;       // m, > 0; distance from which on the utility is 0
  bool along_edges = false;  // over the graph instead of straight
};

inline constexpr std::size_t no_node = static_cast<std::size_t>(-1);

// out[i * stride + j] for robot i and task j, whose node is node_of[j]; a task without one (no_node) gives every robot
// 0. Where no edges lead to the node, the way is straight.
inline void score(std::span<const Point> robots, std::span<const std::size_t> node_of, const Graph& graph,
                  const Settings& settings, Ways& ways, double* out, std::size_t stride) {
  assert(settings.reach > 0.0);
  for (std::size_t j = 0; j < node_of.size(); ++j) {
    const std::size_t node = node_of[j];
    if (node == no_node) continue;
    const std::span<const double> lengths = settings.along_edges ? ways.to(node, graph) : std::span<const double>{};
    for (std::size_t i = 0; i < robots.size(); ++i) {
      double way = distance(robots[i], graph.nodes[node]);
      if (settings.along_edges) {
        const std::size_t entrance = nearest_node(robots[i], graph.nodes);
        if (lengths[entrance] < infinity) way = distance(robots[i], graph.nodes[entrance]) + lengths[entrance];
      }
      out[i * stride + j] = std::max(0.0, 1.0 - way / settings.reach);
    }
  }
}

}  // namespace waypoint_distance
