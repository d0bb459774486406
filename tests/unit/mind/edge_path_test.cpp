// SPDX-License-Identifier: MIT
// Walking along edges: the next point against the shortest path found by trying every path.
#include "mind/behaviour/edge_path.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "mind/coordination/task_filter.hpp"

namespace regista::mind {
namespace {

Vector2d node(const plugin::Placement& graph, std::size_t i) { return {graph.points[i].x, graph.points[i].y}; }

std::size_t nearest(const plugin::Placement& graph, const Vector2d& place) {
  std::size_t out = 0;
  for (std::size_t i = 1; i < graph.points.size(); ++i) {
    if ((node(graph, i) - place).norm() < (node(graph, out) - place).norm()) out = i;
  }
  return out;
}

// The length of the shortest simple path, by depth-first search over all of them.
double shortest(const plugin::Placement& graph, std::size_t from, std::size_t to, std::vector<char>& used) {
  if (from == to) return 0.0;
  double best = std::numeric_limits<double>::infinity();
  used[from] = 1;
  for (const regista_edge& edge : graph.edges) {
    for (const auto& [a, b] : {std::pair{edge.from, edge.to}, std::pair{edge.to, edge.from}}) {
      if (a != from || used[b] != 0) continue;
      best = std::min(best, (node(graph, a) - node(graph, b)).norm() + shortest(graph, b, to, used));
    }
  }
  used[from] = 0;
  return best;
}

double shortest(const plugin::Placement& graph, std::size_t from, std::size_t to) {
  std::vector<char> used(graph.points.size(), 0);
  return shortest(graph, from, to, used);
}

TEST(EdgePath, OntoTheNearestEdgeThenToItsBetterEnd) {
  std::mt19937_64 engine(1);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
  const auto index = [&](std::size_t n) { return static_cast<std::uint32_t>(engine() % n); };
  int entered = 0, followed = 0, straight = 0;
  for (int round = 0; round < 4000; ++round) {
    plugin::Placement graph;
    const std::size_t n = 2 + engine() % 6;
    for (std::size_t i = 0; i < n; ++i) {
      const double x = in(-4, 4), y = in(-3, 3);
      graph.points.push_back(
          {x, y, 1.0, static_cast<std::int32_t>(i % 3) - 1, 0});  // to whom a node belongs does not matter
    }
    const std::size_t edges = engine() % 10;
    for (std::size_t i = 0; i < edges; ++i) {
      const std::uint32_t a = index(n), b = index(n);
      graph.edges.push_back({a, b});
    }
    const double fx = in(-4, 4), fy = in(-3, 3), tx = in(-4, 4), ty = in(-3, 3);
    Vector2d from(fx, fy);
    const Vector2d to(tx, ty);
    // Half of the walkers are on an edge already, or very near.
    if (round % 2 == 0 && !graph.edges.empty()) {
      const regista_edge& edge = graph.edges[index(graph.edges.size())];
      const double share = in(0, 1);
      from = (1 - share) * node(graph, edge.from) + share * node(graph, edge.to) + Vector2d(0.1, 0.0);
    }
    const std::size_t start = nearest(graph, from), goal = nearest(graph, to);
    const Vector2d next = along_edges(graph, from, to);

    const double there = (node(graph, start) - from).norm(), back = (node(graph, goal) - to).norm();
    double off = std::numeric_limits<double>::infinity(), whole = off;  // to the nearest edge, over the best end
    for (const regista_edge& edge : graph.edges) {
      if (shortest(graph, edge.from, goal) == std::numeric_limits<double>::infinity()) continue;
      const double away = (nearest_on_segment(node(graph, edge.from), node(graph, edge.to), from) - from).norm();
      off = std::min(off, away);
      if (away > 0.3) continue;
      for (const std::size_t end : {edge.from, edge.to})
        whole = std::min(whole, (node(graph, end) - from).norm() + shortest(graph, end, goal));
    }
    if (start == goal || (to - from).norm() <= there + back || (node(graph, goal) - from).norm() <= 0.3 ||
        (to - from).norm() < back || off == std::numeric_limits<double>::infinity()) {
      EXPECT_EQ(next, to);
      ++straight;
    } else if (off > 0.3) {
      EXPECT_NEAR((next - from).norm(), off, 1e-12);
      double least = std::numeric_limits<double>::infinity();
      for (const regista_edge& edge : graph.edges)
        least = std::min(least, (nearest_on_segment(node(graph, edge.from), node(graph, edge.to), next) - next).norm());
      EXPECT_NEAR(least, 0.0, 1e-12) << "the entrance lies on no edge";
      ++entered;
    } else {
      std::size_t end = 0;
      while (end < n && node(graph, end) != next) ++end;
      ASSERT_LT(end, n) << "not a node";
      EXPECT_NEAR((next - from).norm() + shortest(graph, end, goal), whole, 1e-8);
      ++followed;
    }
  }
  EXPECT_GT(entered, 200);
  EXPECT_GT(followed, 200);
  EXPECT_GT(straight, 200);
}

// Round a corner: from A to C there is only the way through B. As edges are straight, no way along them is shorter than
// the straight one to the last node: a search for the shortest whole way over all nodes would never follow an edge.
TEST(EdgePath, FollowsTheEdges) {
  plugin::Placement graph;
  for (const auto& [x, y] : {std::pair{-3.0, -2.0}, {-3.0, 2.0}, {3.0, 2.0}})
    graph.points.push_back({x, y, 1.0, -1, 0});
  graph.edges = {{0, 1}, {1, 2}};
  const Vector2d to(3.2, 2.2);
  EXPECT_EQ(along_edges(graph, {-3.0, -1.9}, to), Vector2d(-3.0, 2.0));
  Vector2d at(-3.0, -2.0);
  for (int step = 0; step < 1000 && (node(graph, 2) - at).norm() > 0.35; ++step) {
    const Vector2d way = along_edges(graph, at, to) - at;
    at += way * std::min(1.0, 0.025 / std::max(way.norm(), 1e-12));
    const double off = std::min((nearest_on_segment(node(graph, 0), node(graph, 1), at) - at).norm(),
                                (nearest_on_segment(node(graph, 1), node(graph, 2), at) - at).norm());
    ASSERT_LT(off, 0.35) << "at " << at.transpose();
  }
  EXPECT_LT((node(graph, 2) - at).norm(), 0.36);
}

TEST(EdgePath, WithoutAGraphStraightOn) { EXPECT_EQ(along_edges({}, {0, 0}, {3, 1}), Vector2d(3, 1)); }

// A walker that goes from node to node reaches the target, however the nodes lie.
TEST(EdgePath, WalkersArrive) {
  std::mt19937_64 engine(2);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
  for (int round = 0; round < 300; ++round) {
    plugin::Placement graph;
    for (int i = 0; i < 8; ++i) {
      const double x = in(-4, 4), y = in(-3, 3);
      graph.points.push_back({x, y, 1.0, -1, 0});
    }
    for (std::uint32_t i = 0; i < 8; ++i) graph.edges.push_back({i, (i + 1) % 8});
    const double fx = in(-4, 4), fy = in(-3, 3), tx = in(-4, 4), ty = in(-3, 3);
    Vector2d at(fx, fy);
    const Vector2d to(tx, ty);
    int steps = 0;
    while ((to - at).norm() > 0.05 && steps < 4000) {
      const Vector2d way = along_edges(graph, at, to) - at;
      at += way * std::min(1.0, 0.025 / std::max(way.norm(), 1e-12));
      ++steps;
    }
    EXPECT_LT(steps, 4000) << "round " << round << ": still " << (to - at).norm() << " m away";
  }
}

}  // namespace
}  // namespace regista::mind
