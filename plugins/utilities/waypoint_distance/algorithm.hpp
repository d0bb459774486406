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

// The shortest ways along the edges of one graph (Dijkstra 1959; the graphs are too small for a heap).
class Ways {
 public:
  void reserve(std::size_t nodes, std::size_t edges) {
    first_.reserve(nodes + 1);
    steps_.reserve(2 * edges);
    length_.reserve(nodes);
    done_.reserve(nodes);
  }

  void set(const Graph& graph) {
    first_.assign(graph.nodes.size() + 1, 0);
    steps_.resize(2 * graph.edges.size());
    for (const Edge& edge : graph.edges) {
      ++first_[edge.from];
      ++first_[edge.to];
    }
    std::size_t end = 0;
    for (std::size_t& first : first_) first = end += first;
    for (const Edge& edge : graph.edges) {  // the steps of a node are filled from their end
      const double length = distance(graph.nodes[edge.from], graph.nodes[edge.to]);
      steps_[--first_[edge.from]] = {edge.to, length};
      steps_[--first_[edge.to]] = {edge.from, length};
    }
  }

  // Their lengths from every node to `goal`, infinity where there is none. Valid until the next call.
  std::span<const double> to(std::size_t goal) {
    const std::size_t count = first_.size() - 1;
    length_.assign(count, infinity);
    done_.assign(count, 0);
    length_[goal] = 0.0;
    for (std::size_t nearest = goal; nearest != count;) {
      done_[nearest] = 1;
      for (std::size_t i = first_[nearest]; i < first_[nearest + 1]; ++i) {
        double& length = length_[steps_[i].to];
        length = std::min(length, length_[nearest] + steps_[i].length);
      }
      nearest = count;
      double least = infinity;
      for (std::size_t i = 0; i < count; ++i) {
        if (done_[i] == 0 && length_[i] < least) {
          least = length_[i];
          nearest = i;
        }
      }
    }
    return length_;
  }

 private:
  struct Step {
    std::size_t to;
    double length;
  };
  std::vector<std::size_t> first_;  // first_[i] to first_[i + 1]: the steps from node i
  std::vector<Step> steps_;
  std::vector<double> length_;
  std::vector<char> done_;
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
