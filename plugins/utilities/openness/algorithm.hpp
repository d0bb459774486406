// SPDX-License-Identifier: MIT
// How free of opponents a task is: its target, the line of a pass from the ball to it, and the line of a shot from it
// to the goal. Of each counts the distance of the nearest opponent, up to the clearance that makes it free. Distance of
// the nearest taker and freedom of the passing lane are what keepers in Keepaway go by (Stone, Sutton and Kuhlmann
// 2005). The lines' clearance is that of the SPQR team's Voronoi edges, which an opponent within 0.75 m closes; the
// target's is the 1.5 m within which SPQR counts numbers near the ball.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

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

// Targets are taken a few at a time, so that a handful stays in registers while all opponents pass by.
inline constexpr std::size_t handful = 4;
using Handful = std::array<double, handful>;

// Squared distance from each target to the nearest opponent; far without any.
inline Handful nearest_to_points(const double* x, const double* y, std::span<const Point> opponents) {
  Handful squared;
  squared.fill(far);
  for (const Point& opponent : opponents) {
    for (std::size_t j = 0; j < handful; ++j) {
      const double dx = x[j] - opponent.x, dy = y[j] - opponent.y;
      squared[j] = std::min(squared[j], dx * dx + dy * dy);
    }
  }
  return squared;
}

// The same from the straight line between `end` and each target.
inline Handful nearest_to_lines(const Point& end, const double* x, const double* y, std::span<const Point> opponents) {
  constexpr double least = 1e-300;  // m^2: a line of no length is a point
  Handful squared, vx, vy, per_length;
  for (std::size_t j = 0; j < handful; ++j) {
    squared[j] = far;
    vx[j] = x[j] - end.x;
    vy[j] = y[j] - end.y;
    per_length[j] = 1.0 / (vx[j] * vx[j] + vy[j] * vy[j] + least);
  }
  for (const Point& opponent : opponents) {
    const double ox = opponent.x - end.x, oy = opponent.y - end.y;
    for (std::size_t j = 0; j < handful; ++j) {
      const double along = (ox * vx[j] + oy * vy[j]) * per_length[j];
      const double share = std::min(std::max(along, 0.0), 1.0);
      const double dx = ox - share * vx[j], dy = oy - share * vy[j];
      squared[j] = std::min(squared[j], dx * dx + dy * dy);
    }
  }
  return squared;
}

// Adds `share` times the freedom in [0, 1] that a squared distance means.
inline void add(double share, double clearance, const Handful& squared, Handful& to) {
  const double per_metre = 1.0 / clearance;
  for (std::size_t j = 0; j < handful; ++j) to[j] += share * std::min(std::sqrt(squared[j]) * per_metre, 1.0);
}

// out[j] in [0, 1] for each target: 1 with no opponent near, or when nothing has a share.
inline void score(const Targets& targets, const Scene& scene, const Settings& settings, std::span<double> out) {
  assert(targets.x.size() == out.size() && targets.y.size() == out.size());
  assert(settings.target_clearance > 0.0 && settings.line_clearance > 0.0);
  const double pass_share = scene.ball ? settings.pass_share : 0.0;
  const double shares = settings.target_share + pass_share + settings.shot_share;
  for (std::size_t first = 0; first < out.size(); first += handful) {
    const std::size_t count = std::min(handful, out.size() - first);
    Handful x{}, y{}, sum{};
    std::copy_n(targets.x.begin() + static_cast<std::ptrdiff_t>(first), count, x.begin());
    std::copy_n(targets.y.begin() + static_cast<std::ptrdiff_t>(first), count, y.begin());
    if (settings.target_share > 0.0) {
      add(settings.target_share / shares, settings.target_clearance,
          nearest_to_points(x.data(), y.data(), scene.opponents), sum);
    }
    if (pass_share > 0.0) {
      add(pass_share / shares, settings.line_clearance,
          nearest_to_lines(*scene.ball, x.data(), y.data(), scene.opponents), sum);
    }
    if (settings.shot_share > 0.0) {
      add(settings.shot_share / shares, settings.line_clearance,
          nearest_to_lines(scene.goal, x.data(), y.data(), scene.blockers), sum);
    }
    for (std::size_t j = 0; j < count; ++j) {
      out[first + j] = shares > 0.0 ? std::min(sum[j], 1.0) : 1.0;  // rounding of the shares
    }
  }
}

}  // namespace openness
