// SPDX-License-Identifier: GPL-3.0-or-later
// Points of cells against closed forms and brute force, and the plugin voronoi_cells.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "cell_points.hpp"
#include "test_points.hpp"
#include "test_scene.hpp"

namespace {

using voronoi::Attraction;
using voronoi::Candidate;
using voronoi::Cell;
using voronoi::Extent;
using voronoi::Point;

constexpr Extent field{4.5, 3.0};

TEST(CellPoints, CentroidOfARectangleAndATriangle) {
  const Point middle = voronoi::centroid(voronoi::cell(std::vector<Point>{{0, 0}}, 0, field));
  EXPECT_NEAR(middle.x, 0.0, 1e-15);
  EXPECT_NEAR(middle.y, 0.0, 1e-15);
  const std::vector<Point> halves{{-2.0, 3.0}, {2.0, -3.0}};  // their border is a diagonal of the field
  const Point third = voronoi::centroid(voronoi::cell(halves, 0, field));
  EXPECT_NEAR(third.x, -1.5, 1e-14);
  EXPECT_NEAR(third.y, 1.0, 1e-14);
}

// Against a fine grid: the mean of what is nearest to a robot.
TEST(CellPoints, CentroidIsTheMeanOfTheCell) {
  std::mt19937 random(41);
  const std::vector<Point> sites = voronoi::random_points(random, 7, field);
  std::vector<double> count(7), sum_x(7), sum_y(7);
  for (int i = 0; i < 900; ++i) {
    for (int j = 0; j < 600; ++j) {
      const Point p{-4.495 + 0.01 * i, -2.995 + 0.01 * j};
      std::size_t nearest = 0;
      for (std::size_t k = 1; k < 7; ++k) {
        if (std::hypot(p.x - sites[k].x, p.y - sites[k].y) <
            std::hypot(p.x - sites[nearest].x, p.y - sites[nearest].y)) {
          nearest = k;
        }
      }
      ++count[nearest];
      sum_x[nearest] += p.x;
      sum_y[nearest] += p.y;
    }
  }
  for (std::size_t k = 0; k < 7; ++k) {
    const Point centroid = voronoi::centroid(voronoi::cell(sites, k, field));
    EXPECT_NEAR(centroid.x, sum_x[k] / count[k], 0.01);
    EXPECT_NEAR(centroid.y, sum_y[k] / count[k], 0.01);
  }
}

// Lloyd: walking to the centroids never makes the field's mean squared distance to its nearest robot larger, and ends
// where the robots are the centroids.
TEST(CellPoints, WalkingToTheCentroidsCoversTheField) {
  std::vector<Point> sites{{-4, -2}, {-4, -1}, {-4, 0}, {-4, 1.3}, {-4.1, 2.1}};
  const auto cost = [&] {
    double sum = 0.0;
    for (int i = 0; i < 90; ++i) {
      for (int j = 0; j < 60; ++j) {
        double least = 1e9;
        for (const Point& s : sites)
          least = std::min(least, std::pow(-4.45 + 0.1 * i - s.x, 2) + std::pow(-2.95 + 0.1 * j - s.y, 2));
        sum += least;
      }
    }
    return sum / 5400.0;
  };
  double before = cost(), moved = 1.0;
  for (int step = 0; step < 600; ++step) {
    std::vector<Point> next;
    for (std::size_t i = 0; i < sites.size(); ++i) next.push_back(voronoi::centroid(voronoi::cell(sites, i, field)));
    moved = 0.0;
    for (std::size_t i = 0; i < sites.size(); ++i)
      moved = std::max(moved, std::hypot(next[i].x - sites[i].x, next[i].y - sites[i].y));
    sites = next;
    const double now = cost();
    EXPECT_LE(now, before + 1e-3) << step;  // the grid is coarse
    before = now;
  }
  EXPECT_LT(moved, 1e-4);
  // No five points do better than regular hexagons would (Fejes Toth): 5 sqrt(3) / 54 of the area of each.
  const double hexagons = 5.0 * std::sqrt(3.0) / 54.0 * 54.0 / 5.0;
  EXPECT_GT(before, hexagons - 1e-2);  // the grid is coarse
  EXPECT_LT(before, 1.2 * hexagons);
}

TEST(CellPoints, TheBestPointIsInTheCellAndBeatsTheCentroid) {
  std::mt19937 random(42);
  std::uniform_real_distribution<double> weight(0.0, 1.0);
  for (int round = 0; round < 1000; ++round) {
    const auto number = static_cast<std::size_t>(round);
    const std::vector<Point> sites = voronoi::random_points(random, 1 + number % 11, field);
    const std::vector<Point> opponents = voronoi::random_points(random, number % 8, field);
    Attraction attraction;
    attraction.openness = weight(random);
    attraction.ball = weight(random);
    attraction.goal = weight(random);
    const std::optional<Point> ball = round % 3 == 0 ? std::nullopt : std::optional<Point>(Point{1.0, -0.5});
    const Point goal{4.5, 0.0};
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const Cell cell = voronoi::cell(sites, i, field);
      const Candidate best = voronoi::best_point(cell, opponents, ball, goal, attraction);
      EXPECT_TRUE(voronoi::holds(cell, best.at, -1e-11));
      EXPECT_EQ(best.value, voronoi::value_of(best.at, opponents, ball, goal, attraction));
      EXPECT_GE(best.value, voronoi::value_of(voronoi::centroid(cell), opponents, ball, goal, attraction));
      EXPECT_LE(best.value, 1.0 + 1e-12);
    }
  }
}

TEST(CellPoints, OneWeightAlone) {
  const Cell whole = voronoi::cell(std::vector<Point>{{0, 0}}, 0, field);
  const Point goal{4.5, 0.0};
  const Candidate to_goal = voronoi::best_point(whole, {}, std::nullopt, goal, {0.0, 0.0, 1.0, 3.0, 10.0});
  EXPECT_NEAR(to_goal.at.x, 0.9 * 4.5, 1e-12);  // towards the middle of the goal line
  EXPECT_NEAR(to_goal.at.y, 0.0, 1e-12);
  const std::vector<Point> opponents{{0.0, 0.0}};
  const Candidate open = voronoi::best_point(whole, opponents, std::nullopt, goal, {1.0, 0.0, 0.0, 9.0, 10.0});
  EXPECT_NEAR(std::hypot(open.at.x, open.at.y), 0.9 * std::hypot(4.5, 3.0), 1e-12);  // into a corner
  const Candidate none = voronoi::best_point(whole, opponents, Point{1, 1}, goal, {0.0, 0.0, 0.0, 3.0, 10.0});
  EXPECT_EQ(none.value, 1.0);
  EXPECT_NEAR(none.at.x, 0.0, 1e-15);
}

// --- The plugin ----------------------------------------------------------------------------------------------------

using namespace regista::testkit;

TEST(VoronoiCellsPlugin, APointAndACellForEachActiveRobot) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "voronoi_cells");
  const Scene scene = voronoi::two_robots_with_cells();
  for (const double target : {0.0, 1.0}) {
    Instance positioner(plugin, EnvironmentBuilder{}.own(2), Values(plugin).set("target", target));
    const Placed placed = positioner.place(scene);
    ASSERT_EQ(placed.cells.size(), 2u);
    ASSERT_EQ(placed.points.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(placed.cells[i].robot, i == 0 ? 2 : 5);
      EXPECT_EQ(placed.points[i].robot, placed.cells[i].robot);
      EXPECT_EQ(placed.points[i].task, -1);
      EXPECT_EQ(placed.cells[i].count, 4u);
    }
    if (target == 0.0) {  // the border is at x = 0.5
      EXPECT_NEAR(placed.points[0].x, -2.0, 1e-12);
      EXPECT_NEAR(placed.points[1].x, 2.5, 1e-12);
      EXPECT_EQ(placed.points[0].score, 1.0);
    } else {
      EXPECT_LT(placed.points[0].score, 1.0);
    }
  }
}

REGISTA_POSITIONER_CONTRACT(REGISTA_PLUGIN_FILE, "voronoi_cells");

}  // namespace
