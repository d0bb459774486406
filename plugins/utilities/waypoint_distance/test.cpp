// SPDX-License-Identifier: MIT
// Closed forms, ways along the edges against all paths, and what the term changes in an auction.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include <regista/testkit/contract.hpp>

#include "algorithm.hpp"

namespace waypoint_distance {
namespace {

std::vector<double> table(const std::vector<Point>& robots, const std::vector<std::size_t>& node_of,
                          const std::vector<Point>& nodes, const std::vector<Edge>& edges, const Settings& settings) {
  std::vector<double> out(robots.size() * node_of.size(), 0.0);
  Scorer().score(robots, node_of, {nodes, edges}, settings, out.data(), node_of.size());
  return out;
}

TEST(WaypointDistance, StraightClosedForms) {
  const std::vector<Point> nodes{{3, 4}, {0, 0}};
  EXPECT_EQ(table({{0, 0}, {3, 4}, {30, 40}}, {0, no_node, 1}, nodes, {}, {10.0, false}),
            (std::vector<double>{0.5, 0, 1, 1, 0, 0.5, 0, 0, 0}));
}

TEST(WaypointDistance, AlongTheEdges) {
  // A square without the edge between the nodes 0 and 3.
  const std::vector<Point> nodes{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<Edge> edges{{0, 1}, {1, 2}, {3, 2}};
  const auto out = table({{0, -0.5}, {0, 1}}, {3}, nodes, edges, {10.0, true});
  EXPECT_DOUBLE_EQ(out[0], 1.0 - 3.5 / 10.0) << "half a metre to the nearest node, then three sides";
  EXPECT_DOUBLE_EQ(out[1], 1.0);
}

TEST(WaypointDistance, StraightWhereNoEdgesLead) {
  EXPECT_DOUBLE_EQ(table({{0, 0}}, {1}, {{0, 1}, {3, 4}}, {}, {10.0, true})[0], 0.5);
}

double shortest_path(std::size_t from, std::size_t to, const Graph& graph, std::vector<bool>& visited) {
  if (from == to) return 0.0;
  visited[from] = true;
  double least = infinity;
  for (const Edge& edge : graph.edges) {
    if (edge.from != from && edge.to != from) continue;
    const std::size_t next = edge.from == from ? edge.to : edge.from;
    if (visited[next]) continue;
    least = std::min(least, distance(graph.nodes[from], graph.nodes[next]) + shortest_path(next, to, graph, visited));
  }
  visited[from] = false;
  return least;
}

TEST(WaypointDistance, WaysAreTheShortestOfAllPaths) {
  std::mt19937_64 engine(3);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
  Ways ways;
  for (int run = 0; run < 200; ++run) {
    std::vector<Point> nodes(7);
    for (Point& each : nodes) each = {in(-4, 4), in(-3, 3)};
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t j = i + 1; j < nodes.size(); ++j) {
        if (in(0, 1) < 0.35) edges.push_back({i, j});
      }
    }
    const Graph graph{nodes, edges};
    ways.set(graph);
    const auto lengths = ways.to(2);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      std::vector<bool> visited(nodes.size(), false);
      const double expected = shortest_path(i, 2, graph, visited);
      if (expected < infinity) {
        EXPECT_NEAR(lengths[i], expected, 1e-12);
      } else {
        EXPECT_EQ(lengths[i], infinity);
      }
    }
  }
}

// Two robots equally far from a task: the one nearer to its node is worth more, so even a greedy auction sees it.
TEST(WaypointDistance, RowsDiffer) {
  const auto out = table({{0, 1}, {0, -1}}, {0}, {{0, 2}}, {}, {11.0, false});
  EXPECT_GT(out[0], out[1]);
}

REGISTA_UTILITY_CONTRACT(REGISTA_PLUGIN_FILE, "waypoint_distance", {.order_of_opponents_is_irrelevant = true});

}  // namespace
}  // namespace waypoint_distance
