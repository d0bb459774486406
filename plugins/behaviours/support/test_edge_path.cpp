// SPDX-License-Identifier: MIT
// Walking along edges: the next point against the shortest path found by trying every path.
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include <regista/testkit/dice.hpp>

#include "../edge_path.hpp"

namespace {

using namespace behaviours;
using regista::testkit::Dice;

struct Drawn {
  std::vector<Vector2d> nodes;
  std::vector<Edge> edges;
};

Vector2d along_edges(const Drawn& graph, const Vector2d& from, const Vector2d& to) {
  return EdgePath{}.next({graph.nodes, graph.edges}, {}, from, to);
}

std::size_t nearest(const Drawn& graph, const Vector2d& place) {
  std::size_t out = 0;
  for (std::size_t i = 1; i < graph.nodes.size(); ++i) {
    if ((graph.nodes[i] - place).norm() < (graph.nodes[out] - place).norm()) out = i;
  }
  return out;
}

// The length of the shortest simple path, by depth-first search over all of them.
double shortest(const Drawn& graph, std::size_t from, std::size_t to, std::vector<char>& used) {
  if (from == to) return 0.0;
  double best = std::numeric_limits<double>::infinity();
  used[from] = 1;
  for (const Edge& edge : graph.edges) {
    for (const auto& [a, b] : {std::pair{edge.from, edge.to}, std::pair{edge.to, edge.from}}) {
      if (a != from || used[b] != 0) continue;
      best = std::min(best, (graph.nodes[a] - graph.nodes[b]).norm() + shortest(graph, b, to, used));
    }
  }
  used[from] = 0;
  return best;
}

double shortest(const Drawn& graph, std::size_t from, std::size_t to) {
  std::vector<char> used(graph.nodes.size(), 0);
  return shortest(graph, from, to, used);
}

TEST(EdgePath, OntoTheNearestEdgeThenToItsBetterEnd) {
  Dice dice(1);
  const auto index = [&](std::size_t n) { return static_cast<std::uint32_t>(dice.bits() % n); };
  int entered = 0, followed = 0, straight = 0;
  for (int round = 0; round < 4000; ++round) {
    Drawn graph;
    const std::size_t n = 2 + dice.bits() % 6;
    for (std::size_t i = 0; i < n; ++i) {
      const double x = dice.real(-4, 4), y = dice.real(-3, 3);
      graph.nodes.emplace_back(x, y);
    }
    const std::size_t edges = dice.bits() % 10;
    for (std::size_t i = 0; i < edges; ++i) {
      const std::uint32_t a = index(n), b = index(n);
      graph.edges.push_back({a, b});
    }
    const double fx = dice.real(-4, 4), fy = dice.real(-3, 3), tx = dice.real(-4, 4), ty = dice.real(-3, 3);
    Vector2d from(fx, fy);
    const Vector2d to(tx, ty);
    // Half of the walkers are on an edge already, or very near.
    if (round % 2 == 0 && !graph.edges.empty()) {
      const Edge& edge = graph.edges[index(graph.edges.size())];
      const double share = dice.real(0, 1);
      from = (1 - share) * graph.nodes[edge.from] + share * graph.nodes[edge.to] + Vector2d(0.1, 0.0);
    }
    const std::size_t start = nearest(graph, from), goal = nearest(graph, to);
    const Vector2d next = along_edges(graph, from, to);

    const double there = (graph.nodes[start] - from).norm(), back = (graph.nodes[goal] - to).norm();
    double off = std::numeric_limits<double>::infinity(), whole = off;  // to the nearest edge, over the best end
    for (const Edge& edge : graph.edges) {
      if (shortest(graph, edge.from, goal) == std::numeric_limits<double>::infinity()) continue;
      const double away = (nearest_on_segment(graph.nodes[edge.from], graph.nodes[edge.to], from) - from).norm();
      off = std::min(off, away);
      if (away > 0.3) continue;
      for (const std::size_t end : {edge.from, edge.to})
        whole = std::min(whole, (graph.nodes[end] - from).norm() + shortest(graph, end, goal));
    }
    if (start == goal || (to - from).norm() <= there + back || (graph.nodes[goal] - from).norm() <= 0.3 ||
        (to - from).norm() < back || off == std::numeric_limits<double>::infinity()) {
      EXPECT_EQ(next, to);
      ++straight;
    } else if (off > 0.3) {
      EXPECT_NEAR((next - from).norm(), off, 1e-12);
      double least = std::numeric_limits<double>::infinity();
      for (const Edge& edge : graph.edges)
        least = std::min(least, (nearest_on_segment(graph.nodes[edge.from], graph.nodes[edge.to], next) - next).norm());
      EXPECT_NEAR(least, 0.0, 1e-12) << "the entrance lies on no edge";
      ++entered;
    } else {
      std::size_t end = 0;
      while (end < n && graph.nodes[end] != next) ++end;
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
  Drawn graph;
  for (const auto& [x, y] : {std::pair{-3.0, -2.0}, {-3.0, 2.0}, {3.0, 2.0}}) graph.nodes.emplace_back(x, y);
  graph.edges = {{0, 1}, {1, 2}};
  const Vector2d to(3.2, 2.2);
  EXPECT_EQ(along_edges(graph, {-3.0, -1.9}, to), Vector2d(-3.0, 2.0));
  Vector2d at(-3.0, -2.0);
  for (int step = 0; step < 1000 && (graph.nodes[2] - at).norm() > 0.35; ++step) {
    const Vector2d way = along_edges(graph, at, to) - at;
    at += way * std::min(1.0, 0.025 / std::max(way.norm(), 1e-12));
    const double off = std::min((nearest_on_segment(graph.nodes[0], graph.nodes[1], at) - at).norm(),
                                (nearest_on_segment(graph.nodes[1], graph.nodes[2], at) - at).norm());
    ASSERT_LT(off, 0.35) << "at " << at.transpose();
  }
  EXPECT_LT((graph.nodes[2] - at).norm(), 0.36);
}

// The memory of one search is no part of the next.
TEST(EdgePath, ForgetsTheLastGraph) {
  const Drawn corner{{{-3, -2}, {-3, 2}, {3, 2}}, {{0, 1}, {1, 2}}}, other{{{-3, -2}, {3, 2}}, {}};
  EdgePath path;
  const Vector2d from(-3, -1.9), to(3.2, 2.2);
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(path.next({corner.nodes, corner.edges}, {}, from, to), Vector2d(-3, 2));
    EXPECT_EQ(path.next({other.nodes, other.edges}, {}, from, to), to) << "no edge leads there";
  }
}

TEST(EdgePath, WithoutAGraphStraightOn) { EXPECT_EQ(along_edges({}, {0, 0}, {3, 1}), Vector2d(3, 1)); }

// A walker that goes from node to node reaches the target, however the nodes lie.
TEST(EdgePath, WalkersArrive) {
  Dice dice(2);
  for (int round = 0; round < 300; ++round) {
    Drawn graph;
    for (int i = 0; i < 8; ++i) {
      const double x = dice.real(-4, 4), y = dice.real(-3, 3);
      graph.nodes.emplace_back(x, y);
    }
    for (std::uint32_t i = 0; i < 8; ++i) graph.edges.push_back({i, (i + 1) % 8});
    const double fx = dice.real(-4, 4), fy = dice.real(-3, 3), tx = dice.real(-4, 4), ty = dice.real(-3, 3);
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
