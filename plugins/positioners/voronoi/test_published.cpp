// SPDX-License-Identifier: GPL-3.0-or-later
// Point sets that broke other triangulators (mapbox/delaunator), and small diagrams with exact cell areas
// (d3-delaunay).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "algorithm.hpp"
#include "cells.hpp"

namespace {

using voronoi::Point;

const std::filesystem::path folder = std::filesystem::path(REGISTA_SHARED_DATA) / "voronoi";

nlohmann::json read(const std::filesystem::path& file) {
  std::ifstream in(file);
  return nlohmann::json::parse(in);
}

std::vector<Point> points(const nlohmann::json& list) {
  std::vector<Point> out;
  for (const nlohmann::json& point : list) out.push_back({point[0], point[1]});
  return out;
}

double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Twice the area of the convex hull, by Andrew's monotone chain.
double hull_area(std::vector<Point> sites) {
  std::sort(sites.begin(), sites.end());
  std::vector<Point> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const Point& site : sites) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), site) <= 0.0) hull.pop_back();
      hull.push_back(site);
    }
    hull.pop_back();
    std::reverse(sites.begin(), sites.end());
  }
  double area = 0.0;
  for (std::size_t k = 1; k + 1 < hull.size(); ++k) area += turn(hull[0], hull[k], hull[k + 1]);
  return area;
}

class Published : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no data in " << folder;
  }
};

TEST_F(Published, TrianglesCoverTheHull) {
  voronoi::Delaunay delaunay;
  int files = 0;
  for (const char* name :
       {"issue13", "issue43", "issue44", "robustness1", "robustness2", "robustness3", "robustness4", "ukraine"}) {
    std::vector<Point> sites = points(read(folder / (std::string(name) + ".json")));
    std::sort(sites.begin(), sites.end());
    sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
    delaunay.build(sites);
    double area = 0.0;
    for (const voronoi::Delaunay::Triangle& t : delaunay.triangles()) {
      const double twice = turn(sites[static_cast<std::size_t>(t[0])], sites[static_cast<std::size_t>(t[1])],
                                sites[static_cast<std::size_t>(t[2])]);
      area += twice;
    }
    const double expected = hull_area(sites);
    EXPECT_NEAR(area, expected, 1e-12 * expected) << name;
    // Euler: with all sites in the triangulation, triangles and sides follow from the number on the hull.
    const auto on_hull = std::ranges::count_if(delaunay.edges(), [](const voronoi::Delaunay::Edge& edge) {
      return edge.left == voronoi::Delaunay::outside || edge.right == voronoi::Delaunay::outside;
    });
    EXPECT_EQ(delaunay.triangles().size(), 2 * sites.size() - 2 - static_cast<std::size_t>(on_hull)) << name;
    if (std::string(name) == "ukraine") {
      EXPECT_EQ(delaunay.triangles().size(), 1711u);
    }
    ++files;
  }
  EXPECT_EQ(files, 8);
}

// A site's cell in the box is convex; its corners are the nodes, and the corners of the box, to which no site is
// nearer.
double cell_area(const std::vector<Point>& sites, std::size_t i, const std::vector<Point>& candidates) {
  std::vector<Point> cell;
  for (const Point& point : candidates) {
    double least = INFINITY;
    for (const Point& site : sites) least = std::min(least, std::hypot(site.x - point.x, site.y - point.y));
    if (std::hypot(sites[i].x - point.x, sites[i].y - point.y) <= least + 1e-9 * (1.0 + least)) cell.push_back(point);
  }
  return cell.size() < 3 ? 0.0 : hull_area(cell) / 2.0;
}

TEST_F(Published, CellAreas) {
  const nlohmann::json file = read(folder / "vectors.json");
  int checked = 0;
  for (const nlohmann::json& vector : file["vectors"]) {
    if (!vector.contains("exact_cell_areas")) continue;
    const std::string id = vector["id"];
    const double left = vector["bounds"][0], bottom = vector["bounds"][1], right = vector["bounds"][2],
                 top = vector["bounds"][3];
    const Point centre{(left + right) / 2.0, (bottom + top) / 2.0};
    std::vector<Point> sites = points(vector["points"]);
    for (Point& site : sites) site = {site.x - centre.x, site.y - centre.y};
    voronoi::Settings settings;
    settings.sites = {1e6, 1e6};
    settings.keep = settings.clip = {(right - left) / 2.0, (top - bottom) / 2.0};
    settings.merge = settings.clearance = 0.0;
    settings.boundary = true;
    settings.fixed.clear();
    voronoi::Diagram diagram(settings);
    std::vector<Point> candidates;
    for (const voronoi::Node& node : diagram.of(sites).nodes) candidates.push_back({node.x, node.y});
    for (const double x : {-settings.clip.x, settings.clip.x}) {
      for (const double y : {-settings.clip.y, settings.clip.y}) candidates.push_back({x, y});
    }
    const double box = (right - left) * (top - bottom);
    for (std::size_t i = 0; i < sites.size(); ++i) {
      // Sites nearer to each other than the rounding of a node share a cell here.
      double expected = 0.0;
      for (std::size_t k = 0; k < sites.size(); ++k) {
        if (std::hypot(sites[k].x - sites[i].x, sites[k].y - sites[i].y) < 1e-9) {
          expected += vector["exact_cell_areas"][k].get<double>();
        }
      }
      EXPECT_NEAR(cell_area(sites, i, candidates), expected, 1e-9 * box) << id << ", site " << i;
      ++checked;
    }
    if (vector.contains("voronoi_nodes")) {
      for (const Point& node : points(vector["voronoi_nodes"])) {
        EXPECT_TRUE(std::any_of(candidates.begin(), candidates.end(), [&](const Point& point) {
          return std::hypot(point.x + centre.x - node.x, point.y + centre.y - node.y) < 1e-12;
        })) << id;
      }
    }
  }
  EXPECT_GE(checked, 90);
}

// The same vectors by half-planes: areas, published corners, numbers of corners, and who borders on whom.
TEST_F(Published, CellsOfATeam) {
  const nlohmann::json file = read(folder / "vectors.json");
  int areas = 0, polygons = 0, counts = 0, neighbours = 0;
  for (const nlohmann::json& vector : file["vectors"]) {
    if (vector["bounds"].is_null()) continue;
    const std::string id = vector["id"];
    const double left = vector["bounds"][0], bottom = vector["bounds"][1], right = vector["bounds"][2],
                 top = vector["bounds"][3];
    const Point centre{(left + right) / 2.0, (bottom + top) / 2.0};
    const voronoi::Extent box{(right - left) / 2.0, (top - bottom) / 2.0};
    std::vector<Point> sites = points(vector["points"]);
    for (Point& site : sites) site = {site.x - centre.x, site.y - centre.y};
    const auto member = [&](const char* name) { return vector.value(name, nlohmann::json::object()); };
    const nlohmann::json published = member("cells"), closed_counts = member("cell_vertex_counts_closed"),
                         bordering = member("voronoi_neighbors_in_box");
    std::vector<voronoi::Cell> cells;
    for (std::size_t i = 0; i < sites.size(); ++i) cells.push_back(voronoi::cell(sites, i, box));
    const auto has = [&](std::size_t i, const Point& corner) {
      return std::ranges::any_of(cells[i].span(), [&](const Point& other) {
        return std::hypot(other.x - corner.x, other.y - corner.y) < 2e-9;
      });
    };
    for (std::size_t i = 0; vector.contains("exact_cell_areas") && i < sites.size(); ++i, ++areas) {
      double area = 0.0;
      for (std::size_t k = 0; k < cells[i].count; ++k) {
        const Point &a = cells[i].corners[k], &b = cells[i].corners[(k + 1) % cells[i].count];
        area += (a.x * b.y - b.x * a.y) / 2.0;
      }
      EXPECT_NEAR(area, vector["exact_cell_areas"][i].get<double>(), 1e-12 * 4.0 * box.x * box.y)
          << id << ", site " << i;
    }
    for (const auto& [key, corners] : published.items()) {
      const auto i = static_cast<std::size_t>(std::stoi(key));
      EXPECT_EQ(cells[i].count, corners.size()) << id << ", site " << i;
      for (const Point& corner : points(corners)) {
        EXPECT_TRUE(has(i, {corner.x - centre.x, corner.y - centre.y})) << id << ", site " << i;
      }
      ++polygons;
    }
    for (const auto& [key, count] : closed_counts.items()) {
      EXPECT_EQ(cells[static_cast<std::size_t>(std::stoi(key))].count + 1, count.get<std::size_t>())
          << id << ", " << key;
      ++counts;
    }
    for (const auto& [key, expected] : bordering.items()) {
      const auto i = static_cast<std::size_t>(std::stoi(key));
      nlohmann::json found = nlohmann::json::array();
      for (std::size_t k = 0; k < cells.size(); ++k) {
        const auto shared = std::ranges::count_if(cells[k].span(), [&](const Point& corner) { return has(i, corner); });
        if (k != i && shared >= 2) found.push_back(k);
      }
      EXPECT_EQ(found, expected) << id << ", site " << i;
      ++neighbours;
    }
  }
  EXPECT_GE(areas, 90);
  EXPECT_EQ(polygons, 14);
  EXPECT_EQ(counts, 26);
  EXPECT_EQ(neighbours, 22);
}

}  // namespace
