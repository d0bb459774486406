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

#include "../places.hpp"

namespace openness {

using places::Point, places::Targets;

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

// Two targets at a time in one vector register, while all opponents pass by: a language extension of g++ and clang on
// every processor, with the results of plain doubles to the last bit.
using Pair = double __attribute__((vector_size(16)));
inline constexpr std::size_t lanes = 2;

constexpr Pair both(double value) { return Pair{value, value}; }
inline Pair smaller(const Pair& a, const Pair& b) { return a < b ? a : b; }
inline Pair larger(const Pair& a, const Pair& b) { return a > b ? a : b; }

struct TwoTargets {
  Pair x, y;
};

// Squared distance from each target to the nearest opponent; far without any.
inline Pair nearest_to_points(const TwoTargets& targets, std::span<const Point> opponents) {
  Pair squared = both(far);
  for (const Point& opponent : opponents) {
    const Pair dx = targets.x - opponent.x, dy = targets.y - opponent.y;
    squared = smaller(squared, dx * dx + dy * dy);
  }
  return squared;
}

// The same from the straight line between `end` and each target.
inline Pair nearest_to_lines(const Point& end, const TwoTargets& targets, std::span<const Point> opponents) {
  constexpr double least = 1e-300;  // m^2: a line of no length is a point
  const Pair vx = targets.x - end.x, vy = targets.y - end.y;
  const Pair per_length = 1.0 / (vx * vx + vy * vy + least);
  Pair squared = both(far);
  for (const Point& opponent : opponents) {
    const double ox = opponent.x - end.x, oy = opponent.y - end.y;
    const Pair along = (ox * vx + oy * vy) * per_length;
    const Pair share = smaller(larger(along, both(0.0)), both(1.0));
    const Pair dx = ox - share * vx, dy = oy - share * vy;
    squared = smaller(squared, dx * dx + dy * dy);
  }
  return squared;
}

// Freedom in [0, 1] that a squared distance means.
inline Pair freedom(const Pair& squared, double clearance) {
  return smaller(Pair{std::sqrt(squared[0]), std::sqrt(squared[1])} * (1.0 / clearance), both(1.0));
}

// out[j] in [0, 1] for each target: 1 with no opponent near, or when nothing has a share.
inline void score(const Targets& targets, const Scene& scene, const Settings& settings, std::span<double> out) {
  assert(targets.x.size() == out.size() && targets.y.size() == out.size());
  assert(settings.target_clearance > 0.0 && settings.line_clearance > 0.0);
  const double pass_share = scene.ball ? settings.pass_share : 0.0;
  const double shares = settings.target_share + pass_share + settings.shot_share;
  for (std::size_t first = 0; first < out.size(); first += lanes) {
    const std::size_t second = std::min(first + 1, out.size() - 1);  // the last target may be alone
    const TwoTargets two{{targets.x[first], targets.x[second]}, {targets.y[first], targets.y[second]}};
    Pair sum = both(0.0);
    if (settings.target_share > 0.0) {
      sum +=
          settings.target_share / shares * freedom(nearest_to_points(two, scene.opponents), settings.target_clearance);
    }
    if (pass_share > 0.0) {
      sum +=
          pass_share / shares * freedom(nearest_to_lines(*scene.ball, two, scene.opponents), settings.line_clearance);
    }
    if (settings.shot_share > 0.0) {
      sum += settings.shot_share / shares *
             freedom(nearest_to_lines(scene.goal, two, scene.blockers), settings.line_clearance);
    }
    const Pair value = shares > 0.0 ? smaller(sum, both(1.0)) : both(1.0);  // rounding of the shares
    out[first] = value[0];
    out[second] = second == first ? value[0] : value[1];
  }
}

}  // namespace openness
