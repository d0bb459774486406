// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of a team: they cover the field once, and brute force finds no nearer robot anywhere in them.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "cells.hpp"
#include "test_points.hpp"

namespace {

using voronoi::Cell;
using voronoi::cell;
using voronoi::Extent;
using voronoi::Point;

constexpr Extent field{4.5, 3.0};
constexpr double field_area = 54.0;

double area(const Cell& of) {
  double twice = 0.0;
  for (std::size_t k = 0; k < of.count; ++k) {
    const Point &a = of.corners[k], &b = of.corners[(k + 1) % of.count];
    twice += a.x * b.y - b.x * a.y;
  }
  return twice / 2.0;
}

std::vector<Cell> cells(const std::vector<Point>& sites) {
  std::vector<Cell> out;
  for (std::size_t i = 0; i < sites.size(); ++i) out.push_back(cell(sites, i, field));
  return out;
}

double total_area(const std::vector<Cell>& all) {
  double sum = 0.0;
  for (const Cell& one : all) sum += area(one);
  return sum;
}

double distance(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); }

// What holds for every set of robots.
void check(const std::vector<Point>& sites, std::mt19937& random) {
  const std::vector<Cell> all = cells(sites);
  EXPECT_NEAR(total_area(all), field_area, 1e-7);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    EXPECT_TRUE(all[i].count == 0 || all[i].count >= 3);
    EXPECT_GE(area(all[i]), 0.0);
    for (const Point& corner : all[i].span()) {
      EXPECT_TRUE(field.contains(corner));
      for (const Point& other : sites) EXPECT_LE(distance(corner, sites[i]), distance(corner, other) + 1e-8);
    }
  }
  for (const Point& p : voronoi::random_points(random, 20, field)) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < sites.size(); ++i) {
      if (distance(p, sites[i]) < distance(p, sites[nearest])) nearest = i;
    }
    EXPECT_TRUE(voronoi::holds(all[nearest], p, -1e-8));
    for (std::size_t i = 0; i < sites.size(); ++i) {
      EXPECT_TRUE(i == nearest || !voronoi::holds(all[i], p, 1e-8));
    }
  }
}

TEST(VoronoiCells, RandomRobotsOnAndOffTheField) {
  std::mt19937 random(21);
  for (int round = 0; round < 3000; ++round) {
    const double reach = round % 3 == 0 ? 1.0 : round % 3 == 1 ? 1.5 : 4.0;
    const std::size_t count = 1 + static_cast<std::size_t>(round) % 15;
    check(voronoi::random_points(random, count, {reach * field.x, reach * field.y}), random);
    if (HasFailure()) FAIL() << "round " << round;
  }
}

// A coarse grid: coincident, collinear and cocircular robots abound.
TEST(VoronoiCells, RandomRobotsOnAGrid) {
  std::mt19937 random(22);
  const std::uniform_int_distribution<int> x(-5, 5), y(-4, 4);
  for (int round = 0; round < 3000; ++round) {
    std::vector<Point> sites(1 + static_cast<std::size_t>(round) % 15);
    voronoi::scatter(sites, random, x, y);
    check(sites, random);
    if (HasFailure()) FAIL() << "round " << round;
  }
}

TEST(VoronoiCells, OneRobotHasTheField) {
  for (const Point& site : {Point{0.0, 0.0}, Point{1.0, -2.0}, Point{9.0, 9.0}}) {
    const Cell only = cell(std::vector<Point>{site}, 0, field);
    EXPECT_EQ(only.count, 4u);
    EXPECT_EQ(area(only), field_area);
  }
}

TEST(VoronoiCells, CoincidentRobotsTheFirstHasTheCell) {
  const std::vector<Cell> all = cells({{1.0, 0.0}, {-1.0, 0.0}, {1.0, -0.0}, {1.0, 0.0}, {-1.0, 0.0}});
  EXPECT_DOUBLE_EQ(area(all[0]), field_area / 2.0);
  EXPECT_DOUBLE_EQ(area(all[1]), field_area / 2.0);
  for (const std::size_t i : {2u, 3u, 4u}) EXPECT_EQ(all[i].count, 0u);
}

TEST(VoronoiCells, CollinearRobotsHaveStrips) {
  const std::vector<Cell> all = cells({{2.0, 1.0}, {-1.0, 1.0}, {0.0, 1.0}});  // borders at x = -0.5 and x = 1
  EXPECT_NEAR(area(all[0]), 3.5 * 6.0, 1e-12);
  EXPECT_NEAR(area(all[1]), 4.0 * 6.0, 1e-12);
  EXPECT_NEAR(area(all[2]), 1.5 * 6.0, 1e-12);
  for (const Cell& one : all) EXPECT_EQ(one.count, 4u);
}

TEST(VoronoiCells, BisectorsThroughCornersAddNone) {
  // Both diagonals' ends mirror each other: the bisector of the first pair is a diagonal of the field.
  const std::vector<Cell> halves = cells({{-2.0, 3.0}, {2.0, -3.0}});
  EXPECT_EQ(halves[0].count, 3u);
  EXPECT_EQ(halves[1].count, 3u);
  const std::vector<Cell> quarters = cells({{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}});
  for (const Cell& one : quarters) {
    EXPECT_EQ(one.count, 4u);
    EXPECT_DOUBLE_EQ(area(one), field_area / 4.0);
  }
}

TEST(VoronoiCells, ARobotBehindAnotherHasNone) {
  const std::vector<Cell> all = cells({{4.0, 0.0}, {9.0, 0.0}});  // border at x = 6.5
  EXPECT_EQ(area(all[0]), field_area);
  EXPECT_EQ(all[1].count, 0u);
  const std::vector<Cell> touching = cells({{4.0, 0.0}, {5.0, 0.0}});  // border on the goal line
  EXPECT_EQ(area(touching[0]), field_area);
  EXPECT_EQ(touching[1].count, 0u);
}

TEST(VoronoiCells, HardlyApartAndFarAway) {
  for (const double apart : {1e-3, 1e-9, 1e-15, 1e-200, 5e-324}) {
    const std::vector<Cell> all = cells({{0.0, 0.0}, {apart, 0.0}});
    EXPECT_NEAR(area(all[0]), field_area / 2.0, 6.0 * apart + 1e-12) << apart;
    EXPECT_NEAR(area(all[1]), field_area / 2.0, 6.0 * apart + 1e-12) << apart;
  }
  const std::vector<Cell> far = cells({{0.0, 0.0}, {1e150, -1e150}});
  EXPECT_EQ(area(far[0]), field_area);
  EXPECT_EQ(far[1].count, 0u);
}

TEST(VoronoiCells, AsManyRobotsAsThereIsRoomFor) {
  // The middle one of a circle has a side to each of the others.
  std::vector<Point> sites{{0.0, 0.0}};
  for (std::size_t k = 1; k < voronoi::most_cell_sites; ++k) {
    const double angle = 2.0 * std::acos(-1.0) * static_cast<double>(k) / (voronoi::most_cell_sites - 1.0);
    sites.push_back({std::cos(angle), std::sin(angle)});
  }
  const std::vector<Cell> all = cells(sites);
  EXPECT_EQ(all[0].count, voronoi::most_cell_sites - 1);
  const double half = std::acos(-1.0) / (voronoi::most_cell_sites - 1.0);
  EXPECT_NEAR(area(all[0]), (voronoi::most_cell_sites - 1.0) * 0.25 * std::tan(half), 1e-12);
  EXPECT_NEAR(total_area(all), field_area, 1e-9);
}

}  // namespace
