// SPDX-License-Identifier: GPL-3.0-or-later
// Against brute force over all triples of sites, closed forms, and what the settings promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"
#include "test_points.hpp"
#include "test_scene.hpp"

namespace {

using voronoi::Diagram;
using voronoi::Extent;
using voronoi::Graph;
using voronoi::Point;
using voronoi::random_points;
using voronoi::Settings;

// Only the diagram: nothing fixed, merged (but for rounding), dropped for clearance, or moved.
Settings bare(Extent everything) {
  Settings settings;
  settings.sites = settings.keep = settings.clip = everything;
  settings.merge = settings.clearance = 0.0;
  settings.fixed.clear();
  return settings;
}

// Every node of the diagram is the centre of a circle through three sites with none inside, and the reverse.
std::vector<Point> brute_force_nodes(const std::vector<Point>& sites, Extent within) {
  std::vector<Point> nodes;
  for (std::size_t a = 0; a < sites.size(); ++a) {
    for (std::size_t b = a + 1; b < sites.size(); ++b) {
      for (std::size_t c = b + 1; c < sites.size(); ++c) {
        // Solve |p - a|^2 = |p - b|^2 = |p - c|^2 by Cramer's rule, in long double.
        const long double m11 = 2.0L * (sites[b].x - sites[a].x), m12 = 2.0L * (sites[b].y - sites[a].y);
        const long double m21 = 2.0L * (sites[c].x - sites[a].x), m22 = 2.0L * (sites[c].y - sites[a].y);
        const auto norm = [&](std::size_t i) {
          return static_cast<long double>(sites[i].x) * sites[i].x + static_cast<long double>(sites[i].y) * sites[i].y;
        };
        const long double r1 = norm(b) - norm(a), r2 = norm(c) - norm(a), determinant = m11 * m22 - m12 * m21;
        const Point p{static_cast<double>((r1 * m22 - r2 * m12) / determinant),
                      static_cast<double>((m11 * r2 - m21 * r1) / determinant)};
        if (!within.contains(p)) continue;
        const double radius = std::hypot(p.x - sites[a].x, p.y - sites[a].y);
        const bool empty = std::none_of(sites.begin(), sites.end(), [&](const Point& site) {
          return std::hypot(p.x - site.x, p.y - site.y) < radius - 1e-9;
        });
        if (empty) nodes.push_back(p);
      }
    }
  }
  return nodes;
}

bool near(const voronoi::Node& node, const Point& point, double tolerance) {
  return std::hypot(node.x - point.x, node.y - point.y) <= tolerance;
}

bool same_bytes(const Graph& a, const Graph& b) {
  return a.nodes.size() == b.nodes.size() && a.edges == b.edges &&
         (a.nodes.empty() || std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(a.nodes[0])) == 0);
}

TEST(Voronoi, NodesEqualBruteForce) {
  std::mt19937 random(6);
  const Extent field{4.5, 3.0};
  for (int round = 0; round < 500; ++round) {
    const std::size_t count = static_cast<std::size_t>(round) % 21;
    const std::vector<Point> sites = random_points(random, count, field);
    const std::vector<Point> expected = brute_force_nodes(sites, field);
    Diagram diagram(bare(field));
    const Graph& graph = diagram.of(sites);
    ASSERT_EQ(graph.nodes.size(), expected.size()) << "round " << round;
    for (const Point& point : expected) {
      EXPECT_TRUE(std::any_of(graph.nodes.begin(), graph.nodes.end(),
                              [&](const voronoi::Node& node) { return near(node, point, 1e-7); }));
    }
  }
}

// Along a Voronoi edge two sites are equally near and none is nearer.
TEST(Voronoi, EdgesRunBetweenTwoNearestSites) {
  std::mt19937 random(7);
  const Extent field{4.5, 3.0};
  std::size_t edges = 0;
  for (int round = 0; round < 200; ++round) {
    Settings settings = bare(field);
    settings.boundary = round % 2 == 1;
    const std::vector<Point> sites = random_points(random, 3 + static_cast<std::size_t>(round) % 15, field);
    Diagram diagram(settings);
    const Graph& graph = diagram.of(sites);
    edges += graph.edges.size();
    for (const voronoi::Edge& edge : graph.edges) {
      for (const double t : {0.1, 0.5, 0.9}) {
        const Point p{(1 - t) * graph.nodes[edge.from].x + t * graph.nodes[edge.to].x,
                      (1 - t) * graph.nodes[edge.from].y + t * graph.nodes[edge.to].y};
        std::vector<double> distances;
        for (const Point& site : sites) distances.push_back(std::hypot(p.x - site.x, p.y - site.y));
        std::sort(distances.begin(), distances.end());
        EXPECT_NEAR(distances[0], distances[1], 1e-7);
      }
    }
  }
  EXPECT_GT(edges, 1000u);
}

TEST(Voronoi, OnlyTheFixedSites) {
  Diagram diagram{Settings{}};
  const Graph& graph = diagram.of({});
  // Ends and posts are on one circle about (x, 0) with x^2 + 3^2 = (4.5 - x)^2 + 0.8^2. Corners and ends of the own
  // half are a rectangle; post, corner and end of the other half are a triangle on either side.
  const double x = (4.5 * 4.5 + 0.64 - 9.0) / 9.0;
  const std::vector<Point> expected{{-2.25, 0.0}, {x, 0.0}, {2.25, -1.9}, {2.25, 1.9}};
  ASSERT_EQ(graph.nodes.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_TRUE(near(graph.nodes[k], expected[k], 1e-12)) << k;
    EXPECT_EQ(graph.nodes[k].score, 1.0);
  }
  EXPECT_EQ(graph.edges, (std::vector<voronoi::Edge>{{0, 1}, {1, 2}, {1, 3}}));
}

// With the released sites there nearly always is a node before the own goal, where defenders belong. Without the
// corners a third or more of the line-ups have none.
TEST(Voronoi, ANodeIsBeforeTheOwnGoal) {
  std::mt19937 random(46);
  Settings without_corners;
  std::erase_if(without_corners.fixed, [](const Point& site) { return std::abs(site.x) + std::abs(site.y) > 7.0; });
  ASSERT_EQ(without_corners.fixed.size(), 4u);
  Diagram released{Settings{}}, bald(without_corners);
  const auto is_there = [](const Graph& graph) {
    return std::ranges::any_of(graph.nodes,
                               [](const voronoi::Node& node) { return node.x < -2.0 && std::abs(node.y) < 2.0; });
  };
  constexpr int line_ups = 300;
  int with = 0, without = 0;
  for (int k = 0; k < line_ups; ++k) {
    const std::vector<Point> opponents = random_points(random, 7, {4.5, 3.0});
    with += is_there(released.of(opponents)) ? 1 : 0;
    without += is_there(bald.of(opponents)) ? 1 : 0;
  }
  EXPECT_GE(with, line_ups * 95 / 100);
  EXPECT_LE(without, line_ups * 2 / 3);
}

// The graph is that of the places from which nobody has moved by `at_least`, however slowly they move.
TEST(Voronoi, AGraphStaysUntilAnOpponentHasMoved) {
  Settings settings;
  settings.at_least = 0.05;
  Diagram kept(settings), fresh{Settings{}};
  std::mt19937 random(47);
  std::vector<Point> now = random_points(random, 7, {4.0, 2.5}), asked = now;
  int computed = 0;
  for (int step = 0; step < 500; ++step) {
    for (std::size_t k = 0; k < now.size(); ++k) now[k].x += k % 2 == 0 ? 0.003 : -0.002;
    std::shuffle(now.begin(), now.end(), random);
    const auto near_an_asked = [&](const Point& point) {
      return std::ranges::any_of(
          asked, [&](const Point& other) { return std::hypot(point.x - other.x, point.y - other.y) < 0.05; });
    };
    if (step == 0 || !std::ranges::all_of(now, near_an_asked)) {
      asked = now;
      ++computed;
    }
    EXPECT_TRUE(same_bytes(kept.of(now), fresh.of(asked))) << "step " << step;
  }
  EXPECT_GT(computed, 10);
  EXPECT_LT(computed, 40);
  now.pop_back();
  EXPECT_TRUE(same_bytes(kept.of(now), fresh.of(now))) << "one fewer";
  std::vector<Point> moved = now;
  for (Point& point : moved) point.y += 0.01;
  EXPECT_TRUE(same_bytes(kept.of(moved), fresh.of(now)));
  kept.reset();
  EXPECT_TRUE(same_bytes(kept.of(moved), fresh.of(moved)));
}

TEST(Voronoi, NodesOutsideAreMovedInOrDropped) {
  Settings settings = bare({4.5, 3.0});
  settings.keep = {5.5, 4.0};
  settings.clip = {4.35, 2.85};
  Diagram diagram(settings);
  // A right triangle: the node is the middle of its longest side.
  const std::vector<Point> inside{{1.0, 1.0}, {3.0, 1.0}, {1.0, 2.0}};
  ASSERT_EQ(diagram.of(inside).nodes.size(), 1u);
  EXPECT_TRUE(near(diagram.of(inside).nodes[0], {2.0, 1.5}, 1e-12));
  const std::vector<Point> above{
      {0.0, 3.0}, {1.0, 2.5}, {2.0, 3.0}};  // centre (1, 3.75), for 1 + (3 - y)^2 = (2.5 - y)^2
  ASSERT_EQ(diagram.of(above).nodes.size(), 1u);
  EXPECT_TRUE(near(diagram.of(above).nodes[0], {1.0, 2.85}, 1e-12));
  const std::vector<Point> dropped{{0.0, 3.0}, {1.0, 2.8}, {2.0, 3.0}};  // centre (1, 5.4), beyond 4
  EXPECT_TRUE(diagram.of(dropped).nodes.empty());
}

TEST(Voronoi, DegenerateSitesGiveNoNodes) {
  Diagram diagram(bare({4.5, 3.0}));
  EXPECT_TRUE(diagram.of({}).nodes.empty());
  for (const std::vector<Point>& sites : std::vector<std::vector<Point>>{{{1, 1}},
                                                                         {{1, 1}, {2, 2}},
                                                                         {{1, 1}, {1, 1}, {1, 1}},
                                                                         {{-2, -2}, {-1, -1}, {0, 0}, {1, 1}, {2, 2}},
                                                                         {{0.1, 0.3}, {0.1, 0.2}, {0.1, 0.1}},
                                                                         {{0.0, 1.0}, {-0.0, 1.0}, {2.0, 1.0}}}) {
    EXPECT_TRUE(diagram.of(sites).nodes.empty());
    EXPECT_TRUE(diagram.of(sites).edges.empty());
  }
}

TEST(Voronoi, CoincidentAndCocircularSites) {
  Diagram diagram(bare({4.5, 3.0}));
  std::vector<Point> circle{{1, 0}, {1, 0}};
  for (int k = 0; k < 12; ++k)
    circle.push_back({std::cos(k * std::acos(-1.0) / 6.0), std::sin(k * std::acos(-1.0) / 6.0)});
  const Graph& graph = diagram.of(circle);
  ASSERT_EQ(graph.nodes.size(), 1u);
  EXPECT_TRUE(near(graph.nodes[0], {0.0, 0.0}, 1e-12));
  EXPECT_TRUE(graph.edges.empty());
}

TEST(Voronoi, BoundaryNodesOfTwoAndOfCollinearSites) {
  Settings settings = bare({4.5, 3.0});
  settings.boundary = true;
  Diagram diagram(settings);
  const std::vector<Point> two{{-1, 0}, {1, 0}};
  const Graph pair = diagram.of(two);
  ASSERT_EQ(pair.nodes.size(), 2u);
  EXPECT_TRUE(near(pair.nodes[0], {0, -3}, 1e-12));
  EXPECT_TRUE(near(pair.nodes[1], {0, 3}, 1e-12));
  EXPECT_EQ(pair.edges.size(), 1u);
  const std::vector<Point> row{{-1, 1}, {0, 1}, {2, 1}};
  const Graph lines = diagram.of(row);
  EXPECT_EQ(lines.nodes.size(), 4u);
  EXPECT_EQ(lines.edges.size(), 2u);
}

// Coordinates on a coarse grid, so that coincident, collinear and cocircular sites abound.
std::vector<Point> grid_sites(std::mt19937& random, std::size_t count) {
  std::uniform_int_distribution<int> x(-9, 9), y(-6, 6);
  std::vector<Point> sites(count);
  for (Point& site : sites) {
    site.x = 0.5 * x(random);
    site.y = 0.5 * y(random);
  }
  return sites;
}

TEST(Voronoi, OrderOfOpponentsAndHistoryDoNotMatter) {
  std::mt19937 random(8);
  Diagram used{Settings{}};
  for (int round = 0; round < 2000; ++round) {
    Settings settings;
    settings.boundary = round % 2 == 0;
    std::vector<Point> sites = grid_sites(random, static_cast<std::size_t>(round) % 14);
    if (round % 4 < 2) sites = random_points(random, sites.size(), {5.0, 3.5});
    Diagram fresh(settings);
    const Graph expected = fresh.of(sites);
    std::shuffle(sites.begin(), sites.end(), random);
    Diagram other(settings);
    other.of(grid_sites(random, 13));
    EXPECT_TRUE(same_bytes(expected, other.of(sites))) << "round " << round;
    EXPECT_TRUE(same_bytes(expected, other.of(sites))) << "second call, round " << round;
    if (!settings.boundary) {
      EXPECT_TRUE(same_bytes(expected, used.of(sites))) << "round " << round;
    }
  }
}

TEST(Voronoi, SettingsHoldOnTheField) {
  std::mt19937 random(9);
  const Settings settings;
  Diagram diagram(settings);
  std::size_t nodes = 0, edges = 0;
  for (int round = 0; round < 2000; ++round) {
    const std::vector<Point> opponents = round % 2 == 0
                                             ? random_points(random, static_cast<std::size_t>(round) % 12, {5.0, 3.5})
                                             : grid_sites(random, static_cast<std::size_t>(round) % 12);
    const Graph& graph = diagram.of(opponents);
    nodes += graph.nodes.size();
    edges += graph.edges.size();
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
      const voronoi::Node& node = graph.nodes[i];
      EXPECT_LE(std::abs(node.x), settings.clip.x);
      EXPECT_LE(std::abs(node.y), settings.clip.y);
      for (std::size_t k = i + 1; k < graph.nodes.size(); ++k) {
        EXPECT_GE(std::hypot(node.x - graph.nodes[k].x, node.y - graph.nodes[k].y), settings.merge - 1e-12);
      }
      double least = settings.full_score;
      for (const Point& opponent : opponents) {
        if (settings.sites.contains(opponent))
          least = std::min(least, std::hypot(opponent.x - node.x, opponent.y - node.y));
      }
      EXPECT_NEAR(node.score, least / settings.full_score, 1e-12);
    }
    for (const voronoi::Edge& edge : graph.edges) {
      EXPECT_LT(edge.from, edge.to);
      ASSERT_LT(edge.to, graph.nodes.size());
      const voronoi::Node &a = graph.nodes[edge.from], &b = graph.nodes[edge.to];
      for (const Point& opponent : opponents) {
        if (!settings.sites.contains(opponent)) continue;
        for (int step = 0; step <= 50; ++step) {
          const double t = step / 50.0;
          EXPECT_GE(std::hypot((1 - t) * a.x + t * b.x - opponent.x, (1 - t) * a.y + t * b.y - opponent.y),
                    settings.clearance - 1e-9);
        }
      }
    }
    EXPECT_TRUE(std::is_sorted(graph.edges.begin(), graph.edges.end()));
    EXPECT_EQ(std::adjacent_find(graph.edges.begin(), graph.edges.end()), graph.edges.end());
  }
  EXPECT_GT(nodes, 5000u);
  EXPECT_GT(edges, 1000u);
}

TEST(Voronoi, MergingTakesTheMiddle) {
  // Three nodes: with a large merging distance they become their mean.
  const std::vector<Point> sites{{0, 0}, {2, 0}, {0, 2}, {3, 3}, {-2, -1}};
  Diagram separate(bare({4.5, 3.0}));
  const Graph apart = separate.of(sites);
  ASSERT_GE(apart.nodes.size(), 2u);
  double x = 0.0, y = 0.0;
  for (const voronoi::Node& node : apart.nodes) {
    x += node.x / static_cast<double>(apart.nodes.size());
    y += node.y / static_cast<double>(apart.nodes.size());
  }
  Settings settings = bare({4.5, 3.0});
  settings.merge = 100.0;
  Diagram merging(settings);
  const Graph& together = merging.of(sites);
  ASSERT_EQ(together.nodes.size(), 1u);
  EXPECT_TRUE(near(together.nodes[0], {x, y}, 1e-12));
  EXPECT_TRUE(together.edges.empty());
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

// The plugin's points and edges are those of the diagram with these fixed sites.
void expect_sites(const std::map<std::string, double>& values, std::vector<Point> fixed,
                  const std::vector<Point>& opponents) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "voronoi");
  Values chosen(plugin);
  for (const auto& [name, value] : values) chosen.set(name, value);
  Instance positioner(plugin, EnvironmentBuilder{}.own(2), chosen);
  FrameBuilder frame;
  frame.own(2).robot(2).at(0, 0);
  for (const Point& opponent : {Point{1.0, 0.5}, Point{-2.0, 1.0}, Point{-1.5, -2.0}, Point{7.0, 0.0}}) {
    frame.opponent(opponent.x, opponent.y);
  }
  const Scene scene = frame.build().before_tasks();
  Settings settings;  // of the same field, by default
  settings.fixed = std::move(fixed);
  Diagram diagram(settings);
  const Graph& expected = diagram.of(opponents);
  const Placed placed = positioner.place(scene);
  ASSERT_EQ(placed.points.size(), expected.nodes.size());
  for (std::size_t i = 0; i < placed.points.size(); ++i) {
    EXPECT_EQ(placed.points[i].x, expected.nodes[i].x);
    EXPECT_EQ(placed.points[i].y, expected.nodes[i].y);
    EXPECT_EQ(placed.points[i].score, expected.nodes[i].score);
    EXPECT_EQ(placed.points[i].task, -1);
    EXPECT_EQ(placed.points[i].robot, 0);
  }
  ASSERT_EQ(placed.edges.size(), expected.edges.size());
  for (std::size_t i = 0; i < placed.edges.size(); ++i) {
    EXPECT_EQ(placed.edges[i].from, expected.edges[i].from);
    EXPECT_EQ(placed.edges[i].to, expected.edges[i].to);
  }
}

TEST(VoronoiPlugin, EachGroupOfSitesIsASwitch) {
  const std::vector<Point> all{{1.0, 0.5}, {-2.0, 1.0}, {-1.5, -2.0}};  // the fourth is beyond the lines
  const std::vector<Point> corners{{-4.5, -3.0}, {-4.5, 3.0}, {4.5, -3.0}, {4.5, 3.0}}, ends{{0.0, -3.0}, {0.0, 3.0}},
      posts{{4.5, -0.8}, {4.5, 0.8}}, goal{{-4.5, 0.0}};
  const auto of = [](std::initializer_list<std::vector<Point>> groups) {
    std::vector<Point> out;
    for (const std::vector<Point>& group : groups) out.insert(out.end(), group.begin(), group.end());
    return out;
  };
  expect_sites({}, of({corners, ends, posts}), all);
  expect_sites({{"field_corners", 0.0}}, of({ends, posts}), all);
  expect_sites({{"halfway_ends", 0.0}}, of({corners, posts}), all);
  expect_sites({{"opponent_posts", 0.0}}, of({corners, ends}), all);
  expect_sites({{"own_goal", 1.0}}, of({corners, ends, posts, goal}), all);
  expect_sites({{"opponents", 0.0}}, of({corners, ends, posts}), {});
}

TEST(VoronoiPlugin, CellsOfTheActiveRobotsWhenAskedFor) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "voronoi");
  const Scene scene = voronoi::two_robots_with_cells();
  Instance silent(plugin, EnvironmentBuilder{}.own(2));
  EXPECT_TRUE(silent.place(scene).cells.empty());
  EXPECT_TRUE(silent.place(scene).vertices.empty());

  Instance positioner(plugin, EnvironmentBuilder{}.own(2), Values(plugin).set("cells", 1.0));
  const Placed placed = positioner.place(scene);
  EXPECT_EQ(placed.points.size(), silent.place(scene).points.size());
  ASSERT_EQ(placed.cells.size(), 2u);
  EXPECT_EQ(placed.cells[0].robot, 2);
  EXPECT_EQ(placed.cells[1].robot, 5);
  const double border = 0.5, areas[] = {(4.5 + border) * 6.0, (4.5 - border) * 6.0};
  for (std::size_t i = 0; i < 2; ++i) {
    const regista_cell& cell = placed.cells[i];
    ASSERT_EQ(cell.count, 4u);
    ASSERT_LE(cell.first + cell.count, placed.vertices.size());
    double twice_area = 0.0;
    for (std::uint32_t k = 0; k < cell.count; ++k) {
      const regista_vertex& a = placed.vertices[cell.first + k];
      const regista_vertex& b = placed.vertices[cell.first + (k + 1) % cell.count];
      twice_area += a.x * b.y - b.x * a.y;
    }
    EXPECT_NEAR(twice_area / 2.0, areas[i], 1e-12);  // positive: counter-clockwise
  }
}

REGISTA_POSITIONER_CONTRACT(REGISTA_PLUGIN_FILE, "voronoi");

}  // namespace
