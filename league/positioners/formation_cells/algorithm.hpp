// SPDX-License-Identifier: MIT
// Where in the cell of its base point a robot should be, after B-Human (Roefer et al., "B-Human 2022 - More Team Play
// with Less Communication", RoboCup 2022, LNCS 13561; numbers of the code release of 2025): ten steps of 0.1 m up a
// product of ratings, each a bell curve of a distance. Near the base point and the target that was last sent is good;
// near a teammate, the ball, the border of the field or of the cell is bad.
//
// Decided by us, where the sources leave it open:
//   - a bell curve falls from 1 (what attracts) or rises from 0 to 1 (what repels); that of the last target is never
//     below 0.5;
//   - the ascent begins at the base point and takes the best of eight directions; it ends where none is better, and
//     never leaves cell or field;
//   - the place that was found before stays while the new one is not 1.2 times as good, and is forgotten when it lies
//     in another cell;
//   - a robot within 0.6 m of its place stands, and walks again when it is 0.75 m away. Where it stands in another
//     cell or off the field it walks.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "cells.hpp"

namespace formation_cells {

struct Ratings {
  double base = 2.0, mates = 1.0, ball = 0.5, border = 0.6, cell = 0.05, target = 1.0;  // standard deviations, m
  double target_floor = 0.5;  // the least that the last target's rating may be
  double step = 0.1;          // m
  int steps = 10;
  double keep = 1.2;                 // times as good must a new place be
  double start = 0.75, stop = 0.60;  // m from the place
};

// Half lengths of the field; its centre is the origin.
struct Extent {
  double x = 4.5, y = 3.0;
};

inline bool on_field(const Point& point, const Extent& field) {
  return std::abs(point.x) <= field.x && std::abs(point.y) <= field.y;
}

inline Point clamped(const Point& point, const Extent& field) {
  return {std::clamp(point.x, -field.x, field.x), std::clamp(point.y, -field.y, field.y)};
}

// What the ratings are about. sites: base points of all positions, on the field; mates: where the teammates are.
struct Surroundings {
  Extent field;
  std::span<const Point> sites, mates;
  std::optional<Point> ball;
};

// 1 at distance 0, falling.
inline double attracts(double squared_distance, double deviation) {
  return std::exp(-0.5 * squared_distance / (deviation * deviation));
}

// 0 at distance 0, rising to 1.
inline double repels(double squared_distance, double deviation) {
  constexpr double rounds_to_one = 38.0;  // exp(-38) < 2^-54
  const double exponent = 0.5 * squared_distance / (deviation * deviation);
  return exponent > rounds_to_one ? 1.0 : 1.0 - std::exp(-exponent);
}

// One position: its base point, what was sent of it, and who holds it.
struct Position {
  std::size_t site = 0;               // of the sites
  std::optional<Point> last_target;   // of its robot
  std::optional<std::size_t> holder;  // of the mates: it does not keep away from itself
};

// The product of ratings, in [0, 1]; 0 outside of cell and field. Where it is no more than `enough`, any number that is
// no more than that: no factor is larger than 1, so it need not be finished.
inline double rating(const Point& point, const Surroundings& around, const Position& position, const Ratings& ratings,
                     double enough = 0.0) {
  if (!on_field(point, around.field) || !in_cell(point, around.sites, position.site)) return 0.0;
  double product = attracts(squared(point, around.sites[position.site]), ratings.base);
  if (position.last_target) {
    product *= ratings.target_floor +
               (1.0 - ratings.target_floor) * attracts(squared(point, *position.last_target), ratings.target);
  }
  if (product <= enough) return product;
  const double near = std::min(around.field.x - std::abs(point.x), around.field.y - std::abs(point.y));
  product *= repels(near * near, ratings.border);
  if (around.ball) product *= repels(squared(point, *around.ball), ratings.ball);
  for (std::size_t i = 0; i < around.mates.size() && product > enough; ++i) {
    if (i != position.holder) product *= repels(squared(point, around.mates[i]), ratings.mates);
  }
  if (product <= enough) return product;
  const double away = from_border(point, around.sites, position.site);
  return product * repels(away * away, ratings.cell);
}

struct Found {
  Point place;
  double value = 0.0;  // its rating
};

// Upwards from a point. rate(point, enough): as rating().
template <class Rate>
Found ascend(const Point& from, const Rate& rate, const Ratings& ratings) {
  constexpr double diagonal = 0.70710678118654757;
  constexpr std::array<Point, 8> directions{{{1, 0},
                                             {diagonal, diagonal},
                                             {0, 1},
                                             {-diagonal, diagonal},
                                             {-1, 0},
                                             {-diagonal, -diagonal},
                                             {0, -1},
                                             {diagonal, -diagonal}}};
  Found best{from, rate(from, 0.0)};
  for (int k = 0; k < ratings.steps; ++k) {
    const Found before = best;
    for (const Point& direction : directions) {
      const Point next{before.place.x + ratings.step * direction.x, before.place.y + ratings.step * direction.y};
      const double value = rate(next, best.value);
      if (value > best.value) best = {next, value};
    }
    if (!(best.value > before.value)) break;
  }
  return best;
}

// The place of one position, and whether its robot walks to it. One object for each position.
class Place {
 public:
  void forget() { *this = {}; }

  // Call once per decision.
  Found update(const Surroundings& around, const Position& position, const Ratings& ratings) {
    const auto rate = [&](const Point& point, double enough) {
      return rating(point, around, position, ratings, enough);
    };
    Found found = ascend(around.sites[position.site], rate, ratings);
    if (place_) {
      const double old = rate(*place_, 0.0);
      if (old > 0.0 && found.value <= ratings.keep * old) found = {*place_, old};
    }
    place_ = found.place;
    if (!position.holder) {
      stands_at_.reset();
      return found;
    }
    const Point& robot = around.mates[*position.holder];
    const double away = std::sqrt(squared(robot, found.place));
    if (stands_at_ && (away > ratings.start || !stands_well(*stands_at_, around, position.site))) stands_at_.reset();
    if (!stands_at_ && away < ratings.stop && stands_well(robot, around, position.site)) stands_at_ = robot;
    return stands_at_ ? Found{*stands_at_, found.value} : found;
  }

 private:
  static bool stands_well(const Point& point, const Surroundings& around, std::size_t own) {
    return on_field(point, around.field) && in_cell(point, around.sites, own);
  }
  std::optional<Point> place_, stands_at_;
};

}  // namespace formation_cells
