// SPDX-License-Identifier: GPL-3.0-or-later
// V of the paper (Affinita et al. 2023, "Voronoi Diagram"): the nodes of the Voronoi diagram of the opponents are the
// points farthest from them, its edges the best paths between. The diagram is the dual of the Delaunay triangulation.
// The figures are those of the SPQR team's released code of 2023: sites are the opponents inside the field, both ends
// of the halfway line and the opponent's goal posts; nodes are dropped beyond 5.5 m / 4.0 m and clipped to 4.35 m
// / 2.85 m; nodes nearer than 0.75 m merge; an edge with an opponent within 0.75 m of it is dropped.
#pragma once

#include <cstddef>
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
  std::vector<Point> fixed{{0.0, -3.0}, {0.0, 3.0}, {4.5, -0.8}, {4.5, 0.8}};  // further sites
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
  // positions gives the same graph bit for bit. Valid until the next call; unchanged positions cost nothing.
  const Graph& of(std::span<const Point> opponents);

 private:
  // A merged node: the members' number, sum and mean.
  struct Cluster {
    double sum_x, sum_y, count;
    Point middle;
    std::size_t nearest;  // cluster after it in order that is nearest to it
    double distance;      // squared, to that one
    bool alive;
  };
  struct Corner {
    Point at;
    std::size_t index;
  };

  void find_corners();
  void add_boundary();
  void merge();
  void find_nearest(std::size_t cluster);
  void join();
  void score();
  bool is_clear(const Node& a, const Node& b) const;

  Settings settings_;
  Delaunay delaunay_;
  bool known_ = false;
  std::vector<Point> opponents_, asked_, sites_;
  std::vector<Point> circumcentres_;    // of every triangle
  std::vector<std::size_t> corner_of_;  // of every triangle: its node before merging, or none
  std::vector<Point> corners_;          // nodes before merging
  std::vector<Edge> links_;             // edges between corners
  std::vector<Corner> in_order_;
  std::vector<Cluster> clusters_;
  std::vector<std::size_t> merged_into_;  // cluster of every corner, then node
  Graph graph_;
};

// Equally far from the three points; not finite, or far away, when they are on one line. The order of the points is
// part of the result's last bits.
Point circumcentre(const Point& a, const Point& b, const Point& c);

// Squared distance of `point` from the segment from `a` to `b`.
double squared_distance(const Point& point, const Point& a, const Point& b);

}  // namespace voronoi
