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

inline double squared_distance(const Point& a, const Point& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}
inline double distance(const Point& a, const Point& b) { return std::sqrt(squared_distance(a, b)); }

// The shortest ways along the edges of one graph (Bellman 1958; the graphs are so small that a few rounds over all
// edges are faster than an order of the nodes).
class Ways {
 public:
  void reserve(std::size_t nodes, std::size_t edges) {
    edges_.reserve(edges);
    length_.reserve(nodes);
  }

  void set(const Graph& graph) {
    length_.resize(graph.nodes.size());
    edges_.clear();
    for (const Edge& edge : graph.edges) {
      edges_.push_back({edge.from, edge.to, distance(graph.nodes[edge.from], graph.nodes[edge.to])});
    }
  }

  // Their lengths from every node to `goal`, infinity where there is none. Valid until the next call.
  std::span<const double> to(std::size_t goal) {
    std::ranges::fill(length_, infinity);
    length_[goal] = 0.0;
    for (bool shorter = true; shorter;) {
      shorter = false;
      for (const Measured& edge : edges_) {
        double &from = length_[edge.from], &to = length_[edge.to];
        const double forth = from + edge.length, back = to + edge.length;
        shorter |= forth < to || back < from;
        to = std::min(to, forth);
        from = std::min(from, back);
      }
    }
    return length_;
  }

 private:
  struct Measured {
    std::size_t from, to;
    double length;
  };
  std::vector<Measured> edges_;
  std::vector<double> length_;
};

// The first of equally near ones; there is at least one.
inline std::size_t nearest_node(const Point& place, std::span<const Point> nodes) {
  std::size_t nearest = 0;
  double least = infinity;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double squared = squared_distance(place, nodes[i]);
    if (squared < least) {
      least = squared;
      nearest = i;
    }
  }
  return nearest;
}

struct Settings {
  double reach = 11.0;       // m, > 0; distance from which on the utility is 0
  bool along_edges = false;  // over the graph instead of straight
};

inline constexpr std::size_t no_node = static_cast<std::size_t>(-1);

// Reuse one object: it keeps its memory.
class Scorer {
 public:
  void reserve(std::size_t robots, std::size_t nodes, std::size_t edges) {
    ways_.reserve(nodes, edges);
    entrances_.reserve(robots);
  }

  // out[i * stride + j] for robot i and task j, whose node is node_of[j]; a task without one (no_node) gives every
  // robot 0. Where no edges lead to the node, the way is straight.
  void score(std::span<const Point> robots, std::span<const std::size_t> node_of, const Graph& graph,
             const Settings& settings, double* out, std::size_t stride) {
    assert(settings.reach > 0.0);
    const bool along = settings.along_edges && !graph.edges.empty();
    if (along) {
      ways_.set(graph);
      entrances_.clear();
      for (const Point& robot : robots) {
        const std::size_t node = nearest_node(robot, graph.nodes);
        entrances_.push_back({node, distance(robot, graph.nodes[node])});
      }
    }
    for (std::size_t j = 0; j < node_of.size(); ++j) {
      const std::size_t node = node_of[j];
      if (node == no_node) continue;
      const std::span<const double> lengths = along ? ways_.to(node) : std::span<const double>{};
      for (std::size_t i = 0; i < robots.size(); ++i) {
        const bool leads_there = along && lengths[entrances_[i].node] < infinity;
        const double way =
            leads_there ? entrances_[i].away + lengths[entrances_[i].node] : distance(robots[i], graph.nodes[node]);
        out[i * stride + j] = std::max(0.0, 1.0 - way / settings.reach);
      }
    }
  }

 private:
  struct Entrance {
    std::size_t node;
    double away;  // m
  };
  Ways ways_;
  std::vector<Entrance> entrances_;
};

}  // namespace waypoint_distance
