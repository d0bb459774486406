// SPDX-License-Identifier: GPL-3.0-or-later
// The way of ascending sites, which avoids CGAL's search and lists, gives the same triangles as CGAL's own insertion,
// which sites in any other order take; and the triangulation of a build does not depend on those before it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

#include "delaunay.hpp"

namespace {

using voronoi::Delaunay;
using voronoi::Point;

using Corners = std::array<Point, 3>;

// Triangles by their sites, each from its least one on, and sides by both ends and the sites opposite.
std::set<Corners> triangles(const Delaunay& delaunay, const std::vector<Point>& sites) {
  std::set<Corners> out;
  for (const Delaunay::Triangle& triangle : delaunay.triangles()) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = sites[static_cast<std::size_t>(triangle[k])];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    EXPECT_TRUE(out.insert(corners).second);
  }
  return out;
}

// Each side joins its sites, and the triangle on its left has it in its own direction.
void check_edges(const Delaunay& delaunay, std::size_t sites) {
  std::size_t border = 0;
  for (const Delaunay::Edge& edge : delaunay.edges()) {
    const auto has = [&](int triangle, int from, int to) {
      const Delaunay::Triangle& t = delaunay.triangles()[static_cast<std::size_t>(triangle)];
      for (std::size_t k = 0; k < 3; ++k) {
        if (t[k] == from && t[(k + 1) % 3] == to) return true;
      }
      return false;
    };
    if (edge.left != Delaunay::outside) {
      EXPECT_TRUE(has(edge.left, edge.a, edge.b));
    }
    if (edge.right != Delaunay::outside) {
      EXPECT_TRUE(has(edge.right, edge.b, edge.a));
    }
    if (edge.left == Delaunay::outside || edge.right == Delaunay::outside) ++border;
  }
  if (delaunay.triangles().empty()) return;
  EXPECT_EQ(delaunay.triangles().size(), 2 * sites - 2 - border);  // Euler
  EXPECT_EQ(delaunay.edges().size(), 3 * sites - 3 - border);
}

std::vector<Point> distinct(std::vector<Point> sites) {
  for (Point& site : sites) site = {site.x + 0.0, site.y + 0.0};
  std::sort(sites.begin(), sites.end());
  sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
  return sites;
}

TEST(Delaunay, AscendingSitesAsAnyOthers) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> place(-5.0, 5.0);
  std::uniform_int_distribution<int> coarse(-3, 3), fine(-40, 40);
  Delaunay used;
  std::size_t found = 0;
  for (int round = 0; round < 6000; ++round) {
    std::vector<Point> sites(static_cast<std::size_t>(round) % 27);
    for (Point& site : sites) {
      switch (round % 4) {
        case 0:
          site.x = place(random), site.y = place(random);
          break;
        case 1:
          site.x = coarse(random), site.y = coarse(random);
          break;
        case 2:
          site.x = fine(random) * 1e-9, site.y = coarse(random);
          break;
        default:
          site.x = 0.1 * fine(random), site.y = 0.1 * fine(random);
          break;
      }
    }
    sites = distinct(sites);
    used.build(sites);
    const std::set<Corners> ascending = triangles(used, sites);
    check_edges(used, sites.size());
    found += ascending.size();
    std::shuffle(sites.begin(), sites.end(), random);
    Delaunay other;
    other.build(sites);
    ASSERT_EQ(ascending, triangles(other, sites)) << "round " << round;
    check_edges(other, sites.size());
  }
  EXPECT_GT(found, 50000u);
}

TEST(Delaunay, LinesAndFewSites) {
  Delaunay delaunay;
  const auto counts = [&](const std::vector<Point>& sites) {
    delaunay.build(sites);
    check_edges(delaunay, sites.size());
    return std::array{delaunay.triangles().size(), delaunay.edges().size()};
  };
  using Counts = std::array<std::size_t, 2>;
  EXPECT_EQ(counts({}), (Counts{0, 0}));
  EXPECT_EQ(counts({{1, 2}}), (Counts{0, 0}));
  EXPECT_EQ(counts({{1, 2}, {3, 4}}), (Counts{0, 1}));
  EXPECT_EQ(counts({{0, 0}, {1, 1}, {2, 2}, {3, 3}}), (Counts{0, 3}));
  EXPECT_EQ(counts({{0, 0}, {1, 1}, {2, 2}, {3, 3}, {3, 4}}), (Counts{3, 7}));
  EXPECT_EQ(counts({{0, 0}, {0, 1}, {1, 0}}), (Counts{1, 3}));
  EXPECT_EQ(counts({{0, 0}, {1, 0}, {1, 1}}), (Counts{1, 3}));
  EXPECT_EQ(counts({{0, 0}, {0, 1}, {1, 0}, {1, 1}}), (Counts{2, 5}));  // on one circle
}

}  // namespace
