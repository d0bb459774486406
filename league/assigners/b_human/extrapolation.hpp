// SPDX-License-Identifier: MIT
// Where a teammate is by now: on its straight way from where it was to where it said to walk, at half the speed it had,
// and not beyond (B-Human; see active_player.hpp).
#pragma once

#include <cmath>

#include "active_player.hpp"

namespace b_human {

// age: s since that was said. speed: m/s.
inline Point walked_on(const Point& from, const Point& target, double speed, double age) {
  constexpr double share = 0.5;
  const double way = distance(from, target), done = share * speed * age;
  if (!(way > 0.0) || !(done > 0.0)) return from;
  if (done >= way) return target;
  const double part = done / way;
  return {from.x + part * (target.x - from.x), from.y + part * (target.y - from.y)};
}

}  // namespace b_human
