// SPDX-License-Identifier: MIT
// What teammates make of a packet while nothing new comes, and whether they would notice the difference (B-Human; see
// spending.hpp).
#pragma once

#include <cmath>
#include <numbers>
#include <span>

namespace extrapolated_change {

struct Point {
  double x = 0.0, y = 0.0;  // m, field frame
};

inline double distance(const Point& a, const Point& b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

// As a packet says it.
struct Walk {
  Point from, target;
  double speed = 0.0;  // m/s
};

// Where the teammates believe a robot `age` s after it was said: on the straight way to the target, at half the speed,
// and not beyond.
inline Point extrapolate(const Walk& walk, double age) {
  constexpr double share = 0.5;
  const double way = distance(walk.from, walk.target), done = share * walk.speed * age;
  if (!(way > 0.0) || !(done > 0.0)) return walk.from;
  if (done >= way) return walk.target;
  const double part = done / way;
  return {walk.from.x + part * (walk.target.x - walk.from.x), walk.from.y + part * (walk.target.y - walk.from.y)};
}

struct Sense {
  double distance = 0.3;                            // m
  double angle = 5.0 * (std::numbers::pi / 180.0);  // rad
  double size = 0.45;                               // m: of what is seen under an angle
};

// The way along which something stands, or the angle under which it is seen, is another one from here.
inline bool looks_different(const Point& from, const Point& a, const Point& b, const Sense& sense) {
  const double ax = a.x - from.x, ay = a.y - from.y, bx = b.x - from.x, by = b.y - from.y;
  const double turn = std::abs(std::atan2(ax * by - ay * bx, ax * bx + ay * by));
  if (turn > sense.angle) return true;
  return std::abs(std::atan2(sense.size, distance(from, a)) - std::atan2(sense.size, distance(from, b))) > sense.angle;
}

// Some teammate would notice that something is at `is` where it believes it at `said`. Without a known teammate whoever
// hears is believed to.
inline bool matters(const Point& said, const Point& is, std::span<const Point> mates, const Sense& sense) {
  if (!(distance(said, is) > sense.distance)) return false;
  if (mates.empty()) return true;
  for (const Point& mate : mates) {
    if (looks_different(mate, said, is, sense)) return true;
  }
  return false;
}

}  // namespace extrapolated_change
