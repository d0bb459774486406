// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes where edges leave the field, also of sites in a line and on a circle: against cells that are cut out of the
// field's rectangle by the half-planes of all bisectors, which needs no triangulation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "algorithm.hpp"
#include "test_points.hpp"

namespace {

using voronoi::Diagram;
using voronoi::Extent;
using voronoi::Graph;
using voronoi::Point;
using voronoi::Settings;

constexpr Extent field{4.5, 3.0};
constexpr double inside = 0.2;    // m; so far are sites from the border: near it a bisector may graze it
constexpr double apart = 0.2;     // m; between two sites
constexpr double small = 1e-7;    // m; what a camera cannot see
constexpr double exact = 1e-6;    // m; the far end of an edge between sites 0.2 m apart, in double precision, and more
constexpr double visible = 1e-3;  // m; sides that are shorter may be one node

Settings bare() {
  Settings settings;
  settings.sites = settings.keep = settings.clip = field;
  settings.merge = settings.clearance = 0.0;
  settings.boundary = true;
  settings.fixed.clear();
  return settings;
}

struct Segment {
  Point a, b;
};

// The diagram by its definition. Sides are those between two cells.
struct Cells {
  std::vector<Point> nodes;
  std::vector<Segment> sides;
};

struct Exact {
  long double x, y;
};

// The part of the polygon that is no nearer to `other` than to `own`.
std::vector<Exact> nearer(const std::vector<Exact>& polygon, const Point& own, const Point& other) {
  const auto beyond = [&](const Exact& p) {
    const long double nx = static_cast<long double>(other.x) - own.x, ny = static_cast<long double>(other.y) - own.y;
    return (p.x - (static_cast<long double>(own.x) + other.x) / 2) * nx +
           (p.y - (static_cast<long double>(own.y) + other.y) / 2) * ny;
  };
  std::vector<Exact> rest;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Exact &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const long double at_p = beyond(p), at_q = beyond(q);
    if (at_p <= 0) rest.push_back(p);
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
      const long double t = at_p / (at_p - at_q);
      rest.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return rest;
}

Cells cells_of(const std::vector<Point>& sites) {
  Cells out;
  const auto equally_near = [&](const Point& p, std::size_t own, double tolerance) {
    const double distance = std::hypot(p.x - sites[own].x, p.y - sites[own].y);
    return std::ranges::count_if(
        sites, [&](const Point& site) { return std::hypot(p.x - site.x, p.y - site.y) <= distance + tolerance; });
  };
  for (std::size_t own = 0; own < sites.size(); ++own) {
    std::vector<Exact> polygon{{-field.x, -field.y}, {field.x, -field.y}, {field.x, field.y}, {-field.x, field.y}};
    for (std::size_t other = 0; other < sites.size(); ++other) {
      if (other != own) polygon = nearer(polygon, sites[own], sites[other]);
    }
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Exact &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
      const Segment side{{static_cast<double>(p.x), static_cast<double>(p.y)},
                         {static_cast<double>(q.x), static_cast<double>(q.y)}};
      if (equally_near(side.a, own, 1e-12) >= 2) out.nodes.push_back(side.a);  // not a corner of the field
      const Point middle{(side.a.x + side.b.x) / 2, (side.a.y + side.b.y) / 2};
      if (equally_near(middle, own, 1e-12) >= 2) out.sides.push_back(side);
    }
  }
  return out;
}

double distance(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); }
double length(const Segment& side) { return distance(side.a, side.b); }

std::vector<Point> nodes_of(const Graph& graph) {
  std::vector<Point> out;
  for (const voronoi::Node& node : graph.nodes) out.push_back({node.x, node.y});
  return out;
}

std::vector<Segment> sides_of(const Graph& graph) {
  std::vector<Segment> out;
  for (const voronoi::Edge& edge : graph.edges) {
    out.push_back(
        {{graph.nodes[edge.from].x, graph.nodes[edge.from].y}, {graph.nodes[edge.to].x, graph.nodes[edge.to].y}});
  }
  return out;
}

// How far the farthest of the points is from the nearest of the others (Hausdorff, one way).
double farthest(const std::vector<Point>& points, const std::vector<Point>& others) {
  double most = 0.0;
  for (const Point& point : points) {
    double least = INFINITY;
    for (const Point& other : others) least = std::min(least, distance(point, other));
    most = std::max(most, least);
  }
  return most;
}

bool are_among(const std::vector<Segment>& sides, const std::vector<Segment>& others) {
  return std::ranges::all_of(sides, [&](const Segment& side) {
    return length(side) < visible || std::ranges::any_of(others, [&](const Segment& other) {
             return (distance(side.a, other.a) <= exact && distance(side.b, other.b) <= exact) ||
                    (distance(side.a, other.b) <= exact && distance(side.b, other.a) <= exact);
           });
  });
}

// The same nodes both ways, and the same sides.
bool is_the_diagram(const Graph& graph, const Cells& cells) {
  const std::vector<Point> nodes = nodes_of(graph);
  return farthest(nodes, cells.nodes) <= exact && farthest(cells.nodes, nodes) <= exact &&
         are_among(sides_of(graph), cells.sides) && are_among(cells.sides, sides_of(graph));
}

bool lies_inside(const Point& point) {
  return std::abs(point.x) <= field.x - inside && std::abs(point.y) <= field.y - inside;
}

// Those that lie inside, and far enough from the ones before.
std::vector<Point> spread(const std::vector<Point>& drawn) {
  std::vector<Point> sites;
  for (const Point& point : drawn) {
    if (lies_inside(point) &&
        std::ranges::all_of(sites, [&](const Point& site) { return distance(site, point) >= apart; })) {
      sites.push_back(point);
    }
  }
  return sites;
}

enum class Shape { scattered, aligned, nearly_aligned, collinear, cocircular, lattice };

// aligned: on a line along an axis, as a line of defenders. nearly: each of them a little aside. collinear: on any
// line, but for rounding. cocircular: on a circle, but for rounding.
std::vector<Point> draw(std::mt19937& random, Shape shape) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::uniform_int_distribution<int> steps(-40, 40);
  const std::size_t count = 2 + random() % 7;
  const auto around = [&] { return (2.0 * unit(random) - 1.0) * std::numbers::pi; };
  std::vector<Point> drawn;
  const Point middle{4.0 * unit(random) - 2.0, 2.0 * unit(random) - 1.0};
  const double angle = around(), radius = 0.3 + 1.5 * unit(random);
  const bool upright = random() % 2 == 0;
  while (drawn.size() < count) {
    switch (shape) {
      case Shape::scattered:
        drawn = voronoi::random_points(random, count, field);
        break;
      case Shape::aligned:
        drawn.push_back(middle);
        (upright ? drawn.back().y : drawn.back().x) = 0.1 * steps(random);
        break;
      case Shape::nearly_aligned:
        drawn.push_back({middle.x + small * unit(random), middle.y + small * unit(random)});
        (upright ? drawn.back().y : drawn.back().x) = 0.1 * steps(random);
        break;
      case Shape::collinear: {
        const double along = 0.1 * steps(random);
        drawn.push_back({middle.x + along * std::cos(angle), middle.y + along * std::sin(angle)});
        break;
      }
      case Shape::cocircular: {
        const double direction = around();
        drawn.push_back({middle.x + radius * std::cos(direction), middle.y + radius * std::sin(direction)});
        break;
      }
      case Shape::lattice: {
        const double x = 0.1 * steps(random);
        drawn.push_back({x, 0.05 * steps(random)});
        break;
      }
    }
  }
  return spread(drawn);
}

constexpr Shape shapes[] = {Shape::scattered, Shape::aligned,    Shape::nearly_aligned,
                            Shape::collinear, Shape::cocircular, Shape::lattice};
constexpr const char* names[] = {"scattered", "aligned", "nearly aligned", "collinear", "cocircular", "lattice"};

// One of them a little aside.
std::vector<Point> moved(std::vector<Point> sites, std::mt19937& random) {
  const double angle = std::uniform_real_distribution<double>(-std::numbers::pi, std::numbers::pi)(random);
  Point& site = sites[random() % sites.size()];
  site.x += small * std::cos(angle);
  site.y += small * std::sin(angle);
  return sites;
}

const std::vector<Point> released = Settings{}.fixed;  // corners, ends of the halfway line, posts

TEST(VoronoiBoundary, NodesAndEdgesAreThoseOfHalfPlaneCells) {
  std::mt19937 random(18);
  for (std::size_t shape = 0; shape < std::size(shapes); ++shape) {
    for (const bool fixed : {false, true}) {
      int sets = 0, wrong = 0;
      Settings settings = bare();
      if (fixed) settings.fixed = released;
      for (int round = 0; round < 1000; ++round) {
        const std::vector<Point> drawn = draw(random, shapes[shape]);
        if (drawn.size() < 2) continue;
        for (const std::vector<Point>& opponents : {drawn, moved(drawn, random)}) {
          std::vector<Point> sites = opponents;
          sites.insert(sites.end(), settings.fixed.begin(), settings.fixed.end());
          Diagram diagram(settings);
          wrong += is_the_diagram(diagram.of(opponents), cells_of(sites)) ? 0 : 1;
          ++sets;
        }
      }
      EXPECT_GT(sets, 1000);
      EXPECT_EQ(wrong, 0) << names[shape] << (fixed ? ", with" : ", without") << " fixed sites, of " << sets;
    }
  }
}

// What no robot can see must not throw it about: its target is a node.
TEST(VoronoiBoundary, NodesDoNotJump) {
  std::mt19937 random(19);
  Settings field_only = bare(), with_fixed = bare(), dropped_beyond = bare();
  with_fixed.fixed = dropped_beyond.fixed = released;
  dropped_beyond.keep = Settings{}.keep;
  dropped_beyond.clip = Settings{}.clip;
  for (std::size_t shape = 0; shape < std::size(shapes); ++shape) {
    for (const Settings& settings : {field_only, with_fixed, dropped_beyond}) {
      int moves = 0, jumps = 0;
      for (int round = 0; round < 1500; ++round) {
        const std::vector<Point> opponents = draw(random, shapes[shape]);
        if (opponents.size() < 2) continue;
        Diagram diagram(settings);
        const std::vector<Point> before = nodes_of(diagram.of(opponents));
        const std::vector<Point> after = nodes_of(diagram.of(moved(opponents, random)));
        jumps += farthest(before, after) > visible || farthest(after, before) > visible ? 1 : 0;
        ++moves;
      }
      EXPECT_GT(moves, 1000);
      EXPECT_EQ(jumps, 0) << names[shape] << ", " << settings.fixed.size()
                          << " fixed sites, nodes up to x = " << settings.keep.x << " m, of " << moves;
    }
  }
}

}  // namespace
