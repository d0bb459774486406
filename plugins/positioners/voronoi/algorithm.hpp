// SPDX-License-Identifier: GPL-3.0-or-later
// V of the paper (Affinita et al. 2023, "Voronoi Diagram"): the nodes of the Voronoi diagram of the opponents are the
// points farthest from them, its edges the best paths between. The diagram is the dual of the Delaunay triangulation.
// The figures are those of the SPQR team's released code of 2023 (VoronoiProvider): sites are the opponents inside the
// field, the field's four corners, both ends of the halfway line and the opponent's goal posts; nodes are dropped
// beyond 5.5 m / 4.0 m and clipped to 4.35 m / 2.85 m; nodes nearer than 0.75 m merge; an edge with an opponent within
// 0.75 m of it is dropped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay.hpp"

namespace voronoi {

// The rectangle |x| <= x, |y| <= y; m, field frame.
struct Extent {
  double x, y;
  bool contains(const Point& point) const { return point.x <= x && point.x >= -x && point.y <= y && point.y >= -y; }
};

struct Settings {
  Extent sites{4.5, 3.0};   // opponents beyond are ignored
  Extent keep{5.5, 4.0};    // nodes beyond are dropped; at least `clip`
  Extent clip{4.35, 2.85};  // the others are moved to the nearest point of this rectangle
  double merge = 0.75;      // m; nodes nearer than this become one, in their middle
  double clearance = 0.75;  // m; edges that pass an opponent nearer than this are dropped
  double full_score = 3.0;  // m, > 0; distance from the nearest opponent that gives score 1
  bool boundary = false;    // also nodes where an edge leaves `clip`
  double at_least = 0.0;    // m; the graph stays until an opponent has moved so far; 0: until any has moved at all
  // Further sites.
  std::vector<Point> fixed{{-4.5, -3.0}, {-4.5, 3.0}, {4.5, -3.0}, {4.5, 3.0},
                           {0.0, -3.0},  {0.0, 3.0},  {4.5, -0.8}, {4.5, 0.8}};
};

struct Node {
  double x, y;   // m, inside `clip`
  double score;  // [0, 1]: distance to the nearest opponent / full_score
};

struct Edge {
  std::size_t from, to;  // indices of nodes, from < to
  friend auto operator<=>(const Edge&, const Edge&) = default;
};

struct Graph {
  std::vector<Node> nodes;
  std::vector<Edge> edges;  // each pair once, ascending
};

class Diagram {
 public:
  explicit Diagram(Settings settings);

  // The graph for these opponents, in any order, coincident ones allowed; positions are finite. The same set of
  // positions gives the same graph bit for bit, unless `at_least` keeps an earlier one. Valid until the next call; a
  // graph that is kept costs nothing.
  const Graph& of(std::span<const Point> opponents);

  // Forgets the graph that `at_least` would keep.
  void reset() { known_ = false; }

 private:
  // Corners that have become one: their number and sum.
  struct Cluster {
    double sum_x, sum_y, count;
    std::size_t into;  // the earlier cluster that has swallowed it, or itself
    std::size_t node;  // of the graph
  };
  // Two clusters nearer than the merging distance; first < second.
  struct Pair {
    double distance;  // squared
    std::size_t first, second;
    bool shares_with(const Pair& other) const {
      return first == other.first || first == other.second || second == other.first || second == other.second;
    }
    bool before(const Pair& other) const {
      if (distance != other.distance) return distance < other.distance;
      return first != other.first ? first < other.first : second < other.second;
    }
  };
  struct Corner {
    Point at;
    std::size_t index;
  };

  bool still_holds() const;
  void find_corners();
  void add_boundary();
  void merge();
  void join();
  void score();

  Settings settings_;
  Delaunay delaunay_;
  bool known_ = false;
  std::vector<Point> opponents_, asked_, sites_;
  std::vector<std::size_t> corner_of_;  // of every triangle: its node before merging, or none
  std::vector<Point> corners_;          // nodes before merging
  std::vector<Edge> links_;             // edges between corners
  std::vector<Corner> in_order_;
  std::vector<Cluster> clusters_;
  std::vector<Point> middles_;      // of every cluster
  std::vector<std::size_t> alive_;  // clusters that none has swallowed, ascending
  std::vector<std::uint64_t> joined_;
  std::vector<Pair> near_;
  std::vector<std::size_t> merged_into_;  // cluster of every corner, before clusters merge
  Graph graph_;
};

// Equally far from the three points; not finite, or far away, when they are on one line. The order of the points is
// part of the result's last bits.
Point circumcentre(const Point& a, const Point& b, const Point& c);

// Whether one of the points is nearer than `distance` to the segment from `a` to `b`. Points ascend.
bool passes_near(std::span<const Point> ascending, const Point& a, const Point& b, double distance);

}  // namespace voronoi
