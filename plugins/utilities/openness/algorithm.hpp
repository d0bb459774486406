// SPDX-License-Identifier: MIT
// How free of opponents a task is: its target, the line of a pass from the ball to it, and the line of a shot from it
// to the goal. Of each counts the distance of the nearest opponent, up to the clearance that makes it free. Distance of
// the nearest taker and freedom of the passing lane are what keepers in Keepaway go by (Stone, Sutton and Kuhlmann
// 2005). The lines' clearance is that of the SPQR team's Voronoi edges, which an opponent within 0.75 m closes; the
// target's is the 1.5 m within which SPQR counts numbers near the ball.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace openness {

struct Point {
  double x, y;  // m, field frame
};

struct Targets {
  std::span<const double> x, y;  // m, field frame, of equal length
};

struct Settings {
  double target_share = 1.0, pass_share = 1.0, shot_share = 0.5;  // >= 0; the score is their mean, so weighted
  double target_clearance = 1.5, line_clearance = 0.75;           // m, > 0
};

struct Scene {
  std::span<const Point> opponents;  // who may stand at a target or in the way of a pass
  std::span<const Point> blockers;   // who may stand in the way of a shot
  std::optional<Point> ball;         // without it there is no pass, and its share does not count
  Point goal;
};

inline constexpr double far = std::numeric_limits<double>::infinity();

// Squared distance from each target to the nearest opponent; far without any. squared: as many as targets.
inline void nearest_to_points(const Targets& targets, std::span<const Point> opponents, std::span<double> squared) {
  std::ranges::fill(squared, far);
  for (const Point& opponent : opponents) {
    for (std::size_t j = 0; j < squared.size(); ++j) {
      const double dx = targets.x[j] - opponent.x, dy = targets.y[j] - opponent.y;
      squared[j] = std::min(squared[j], dx * dx + dy * dy);
    }
  }
}

// The same from the straight line between `end` and each target. per_length: room for one number per target.
inline void nearest_to_lines(const Point& end, const Targets& targets, std::span<const Point> opponents,
                             std::span<double> per_length, std::span<double> squared) {
  std::ranges::fill(squared, far);
  constexpr double least = 1e-300;  // m^2: a line of no length is a point
  for (std::size_t j = 0; j < squared.size(); ++j) {
    const double vx = targets.x[j] - end.x, vy = targets.y[j] - end.y;
    per_length[j] = 1.0 / (vx * vx + vy * vy + least);
  }
  for (const Point& opponent : opponents) {
    const double ox = opponent.x - end.x, oy = opponent.y - end.y;
    for (std::size_t j = 0; j < squared.size(); ++j) {
      const double vx = targets.x[j] - end.x, vy = targets.y[j] - end.y;
      const double along = (ox * vx + oy * vy) * per_length[j];
      const double share = std::min(std::max(along, 0.0), 1.0);
      const double dx = ox - share * vx, dy = oy - share * vy;
      squared[j] = std::min(squared[j], dx * dx + dy * dy);
    }
  }
}

// Reused buffers.
class Judge {
 public:
  void reserve(std::size_t targets) {
    for (auto* buffer : {&squared_, &per_length_}) buffer->reserve(targets);
  }
  // out[j] in [0, 1] for each target: 1 with no opponent near, or when nothing has a share.
  void score(const Targets& targets, const Scene& scene, const Settings& settings, std::span<double> out) {
    assert(targets.x.size() == out.size() && targets.y.size() == out.size());
    assert(settings.target_clearance > 0.0 && settings.line_clearance > 0.0);
    squared_.resize(out.size());
    per_length_.resize(out.size());
    const double pass_share = scene.ball ? settings.pass_share : 0.0;
    const double shares = settings.target_share + pass_share + settings.shot_share;
    std::ranges::fill(out, shares > 0.0 ? 0.0 : 1.0);
    if (settings.target_share > 0.0) {
      nearest_to_points(targets, scene.opponents, squared_);
      add(settings.target_share / shares, settings.target_clearance, out);
    }
    if (pass_share > 0.0) {
      nearest_to_lines(*scene.ball, targets, scene.opponents, per_length_, squared_);
      add(pass_share / shares, settings.line_clearance, out);
    }
    if (settings.shot_share > 0.0) {
      nearest_to_lines(scene.goal, targets, scene.blockers, per_length_, squared_);
      add(settings.shot_share / shares, settings.line_clearance, out);
    }
    for (double& value : out) value = std::min(value, 1.0);  // rounding of the shares
  }

 private:
  void add(double share, double clearance, std::span<double> out) const {
    const double per_metre = 1.0 / clearance;
    for (std::size_t j = 0; j < out.size(); ++j) {
      out[j] += share * std::min(std::sqrt(squared_[j]) * per_metre, 1.0);
    }
  }
  std::vector<double> squared_, per_length_;
};

}  // namespace openness
