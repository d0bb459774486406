// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithm.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace voronoi {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
// Triangles of sites on one circle have the same node but for rounding.
constexpr double coincident = 1e-9;  // m

double squared(const Point& a, const Point& b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

Point into(const Extent& extent, const Point& point) {
  return {std::clamp(point.x, -extent.x, extent.x), std::clamp(point.y, -extent.y, extent.y)};
}

// Cuts [from, to] to the part in which origin + t * slope is within [-limit, limit]; from > to when none is.
void cut(double origin, double slope, double limit, double& from, double& to) {
  if (slope == 0.0) {
    if (std::abs(origin) > limit) to = -infinity;
    return;
  }
  double enter = (-limit - origin) / slope, leave = (limit - origin) / slope;
  if (enter > leave) std::swap(enter, leave);
  from = std::max(from, enter);
  to = std::min(to, leave);
}

// Where the centre of the triangle's circle is on the bisector of its side ab: so many |ab| from the middle of the
// side, towards c where positive. That is half the cotangent of the angle at c. The centre itself may be infinitely
// far, or lost in rounding, where the triangle is flat; the sign is that of the cosine, which is never small there.
double centre_along_bisector(const Point& a, const Point& b, const Point& c) {
  const double ax = a.x - c.x, ay = a.y - c.y, bx = b.x - c.x, by = b.y - c.y;
  return (ax * bx + ay * by) / (2.0 * std::abs(ax * by - ay * bx));
}

void in_order(int& a, int& b) {
  const int least = std::min(a, b);
  b = std::max(a, b);
  a = least;
}

}  // namespace

Point circumcentre(const Point& a, const Point& b, const Point& c) {
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double twice_area = 2.0 * (bx * cy - by * cx);
  return {a.x + (cy * b2 - by * c2) / twice_area, a.y + (bx * c2 - cx * b2) / twice_area};
}

bool passes_near(std::span<const Point> ascending, const Point& a, const Point& b, double distance) {
  // Nothing beyond these is near; the margin is far above rounding.
  const double left = std::min(a.x, b.x) - distance - 1e-9, right = std::max(a.x, b.x) + distance + 1e-9;
  const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
  const double per_length2 = length2 > 0.0 ? 1.0 / length2 : 0.0;
  std::size_t k = 0;
  while (k < ascending.size() && ascending[k].x < left) ++k;
  bool near = false;
  for (; k < ascending.size() && ascending[k].x <= right; ++k) {  // without further branches: they are unforeseeable
    const double px = ascending[k].x - a.x, py = ascending[k].y - a.y;
    const double t = std::min(1.0, std::max(0.0, (px * dx + py * dy) * per_length2));
    const double qx = px - t * dx, qy = py - t * dy;
    near |= qx * qx + qy * qy < distance * distance;
  }
  return near;
}

Diagram::Diagram(Settings settings) : settings_(std::move(settings)) {
  std::sort(settings_.fixed.begin(), settings_.fixed.end());
  // For teams of 22: n sites have at most 2n triangles and 3n edges.
  constexpr std::size_t sites = 32, triangles = 2 * sites, edges = 3 * sites;
  for (auto* points : {&opponents_, &asked_, &sites_}) points->reserve(sites);
  for (auto* points : {&corners_, &middles_}) points->reserve(edges);
  for (auto* indices : {&corner_of_, &alive_, &merged_into_}) indices->reserve(edges);
  links_.reserve(edges + triangles);
  in_order_.reserve(edges);
  clusters_.reserve(edges);
  near_.reserve(8 * edges);
  joined_.reserve(edges);
  graph_.nodes.reserve(edges);
  graph_.edges.reserve(edges + triangles);
}

const Graph& Diagram::of(std::span<const Point> opponents) {
  opponents_.clear();
  for (const Point& opponent : opponents) {
    // -0 and 0 are one place: adding 0 makes them one number.
    if (settings_.sites.contains(opponent)) opponents_.push_back({opponent.x + 0.0, opponent.y + 0.0});
  }
  std::sort(opponents_.begin(), opponents_.end());
  opponents_.erase(std::unique(opponents_.begin(), opponents_.end()), opponents_.end());
  if (known_ && still_holds()) return graph_;
  known_ = false;

  sites_.resize(opponents_.size() + settings_.fixed.size());
  std::merge(opponents_.begin(), opponents_.end(), settings_.fixed.begin(), settings_.fixed.end(), sites_.begin());
  sites_.erase(std::unique(sites_.begin(), sites_.end()), sites_.end());
  delaunay_.build(sites_);
  find_corners();
  merge();
  join();
  score();
  asked_ = opponents_;
  known_ = true;
  return graph_;
}

// Whether as many opponents are there as when the graph was computed, each near a place of then, and each place of then
// near an opponent. It is measured from those places, so that slow motion adds up.
bool Diagram::still_holds() const {
  if (opponents_ == asked_) return true;
  if (!(settings_.at_least > 0.0) || opponents_.size() != asked_.size()) return false;
  const double limit = settings_.at_least * settings_.at_least;
  const auto each_is_near = [limit](const std::vector<Point>& points, const std::vector<Point>& others) {
    return std::ranges::all_of(points, [&](const Point& point) {
      return std::ranges::any_of(others, [&](const Point& other) { return squared(point, other) < limit; });
    });
  };
  return each_is_near(opponents_, asked_) && each_is_near(asked_, opponents_);
}

// The diagram's nodes and edges, dropped and clipped.
void Diagram::find_corners() {
  corner_of_.clear();
  corners_.clear();
  links_.clear();
  for (Delaunay::Triangle triangle : delaunay_.triangles()) {
    in_order(triangle[0], triangle[1]);  // where CGAL starts to count must not matter
    in_order(triangle[1], triangle[2]);
    in_order(triangle[0], triangle[1]);
    const auto site = [&](std::size_t k) { return sites_[static_cast<std::size_t>(triangle[k])]; };
    const Point centre = circumcentre(site(0), site(1), site(2));
    corner_of_.push_back(settings_.keep.contains(centre) ? corners_.size() : none);
    if (settings_.keep.contains(centre)) corners_.push_back(into(settings_.clip, centre));
  }
  for (const Delaunay::Edge& edge : delaunay_.edges()) {
    if (edge.left == Delaunay::outside || edge.right == Delaunay::outside) continue;
    const std::size_t left = corner_of_[static_cast<std::size_t>(edge.left)];
    const std::size_t right = corner_of_[static_cast<std::size_t>(edge.right)];
    if (left != none && right != none) links_.push_back({left, right});
  }
  if (settings_.boundary) add_boundary();
}

// Edges with an end that is dropped or at infinity: a node where they cross the border of the clipping rectangle.
void Diagram::add_boundary() {
  for (const Delaunay::Edge& edge : delaunay_.edges()) {
    const Point a = sites_[static_cast<std::size_t>(edge.a)], b = sites_[static_cast<std::size_t>(edge.b)];
    const Point middle{(a.x + b.x) / 2.0, (a.y + b.y) / 2.0};
    const Point normal{a.y - b.y, b.x - a.x};  // to the left of a -> b
    const auto place = [&](int triangle) {
      if (triangle == Delaunay::outside) return infinity;
      const Delaunay::Triangle& corners = delaunay_.triangles()[static_cast<std::size_t>(triangle)];
      const int third = corners[0] + corners[1] + corners[2] - edge.a - edge.b;
      return centre_along_bisector(a, b, sites_[static_cast<std::size_t>(third)]);
    };
    const auto corner = [&](int triangle) {
      return triangle == Delaunay::outside ? none : corner_of_[static_cast<std::size_t>(triangle)];
    };
    std::size_t right = corner(edge.right), left = corner(edge.left);
    if (right != none && left != none) continue;
    // The Voronoi edge is middle + t * normal for t from the right triangle's centre to the left one's.
    double from = -place(edge.right), to = place(edge.left);
    cut(middle.x, normal.x, settings_.clip.x, from, to);
    cut(middle.y, normal.y, settings_.clip.y, from, to);
    if (!(from < to)) continue;  // passes by
    const auto add = [&](double t) {
      corners_.push_back(into(settings_.clip, {middle.x + t * normal.x, middle.y + t * normal.y}));
      return corners_.size() - 1;
    };
    if (right == none) right = add(from);
    if (left == none) left = add(to);
    links_.push_back({right, left});
  }
}

// The nearest two clusters become one, until all are at least the merging distance apart. So the order of the corners
// does not matter; of equally near pairs the first in order of the coordinates comes first.
void Diagram::merge() {
  in_order_.clear();
  for (std::size_t i = 0; i < corners_.size(); ++i) in_order_.push_back({corners_[i], i});
  std::sort(in_order_.begin(), in_order_.end(),
            [](const Corner& a, const Corner& b) { return a.at != b.at ? a.at < b.at : a.index < b.index; });
  const double reach = std::max(settings_.merge, coincident);
  middles_.clear();
  clusters_.clear();
  alive_.clear();
  near_.clear();
  merged_into_.resize(corners_.size());
  Pair nearest{infinity, 0, 0};
  const auto add_if_near = [&](double distance, std::size_t first, std::size_t second) {
    if (!(distance < reach * reach)) return;
    near_.push_back({distance, first, second});
    if (near_.back().before(nearest)) nearest = near_.back();
  };
  for (std::size_t k = 0; k < in_order_.size(); ++k) {
    const Point at = in_order_[k].at;
    middles_.push_back(at);
    clusters_.push_back({at.x, at.y, 1.0, k, 0});
    alive_.push_back(k);
    merged_into_[in_order_[k].index] = k;
    for (std::size_t before = k; before-- > 0 && at.x - middles_[before].x < reach;) {
      add_if_near(squared(middles_[before], at), before, k);
    }
  }
  while (!near_.empty()) {
    const Pair pair = nearest;
    Cluster &winner = clusters_[pair.first], &loser = clusters_[pair.second];
    winner.sum_x += loser.sum_x;
    winner.sum_y += loser.sum_y;
    winner.count += loser.count;
    loser.into = pair.first;
    const Point middle{winner.sum_x / winner.count, winner.sum_y / winner.count};
    middles_[pair.first] = middle;
    nearest.distance = infinity;
    std::size_t kept = 0;
    for (const Pair& other : near_) {
      if (pair.shares_with(other)) continue;
      if (other.before(nearest)) nearest = other;
      near_[kept++] = other;
    }
    near_.resize(kept);
    alive_.erase(std::lower_bound(alive_.begin(), alive_.end(), pair.second));
    for (const std::size_t k : alive_) {
      if (k != pair.first) add_if_near(squared(middles_[k], middle), std::min(k, pair.first), std::max(k, pair.first));
    }
  }
}

// Clusters become nodes, links edges.
void Diagram::join() {
  graph_.nodes.clear();
  graph_.edges.clear();
  for (std::size_t k = 0; k < clusters_.size(); ++k) {
    Cluster& cluster = clusters_[k];
    if (cluster.into == k) {
      cluster.node = graph_.nodes.size();
      graph_.nodes.push_back({middles_[k].x, middles_[k].y, 1.0});
    } else {
      cluster.node = clusters_[cluster.into].node;  // went into an earlier one, whose node is known
    }
  }
  // A row of bits for each node, of the later ones it is joined with: so edges come out ascending and once.
  const std::size_t words = (graph_.nodes.size() + 63) / 64;
  joined_.assign(graph_.nodes.size() * words, 0);
  for (const Edge& link : links_) {
    const std::size_t a = clusters_[merged_into_[link.from]].node, b = clusters_[merged_into_[link.to]].node;
    const std::size_t later = std::max(a, b);
    if (a != b) joined_[std::min(a, b) * words + later / 64] |= std::uint64_t{1} << (later % 64);
  }
  for (std::size_t i = 0; i < joined_.size(); ++i) {
    for (std::uint64_t rest = joined_[i]; rest != 0; rest &= rest - 1) {
      const std::size_t from = i / words, to = i % words * 64 + static_cast<std::size_t>(std::countr_zero(rest));
      const Node &a = graph_.nodes[from], &b = graph_.nodes[to];
      if (!passes_near(opponents_, {a.x, a.y}, {b.x, b.y}, settings_.clearance)) graph_.edges.push_back({from, to});
    }
  }
}

void Diagram::score() {
  for (Node& node : graph_.nodes) {
    double least = settings_.full_score * settings_.full_score;
    for (const Point& opponent : opponents_) least = std::min(least, squared(opponent, {node.x, node.y}));
    node.score = std::min(1.0, std::sqrt(least) / settings_.full_score);
  }
}

}  // namespace voronoi
