// SPDX-License-Identifier: MIT
// The ball that rolls: from which speed on it is met where it will be, and how far it rolls by itself.
#pragma once

#include "situation.hpp"

namespace behaviours {

struct RollingSettings {
  double rolling = 0.25;  // m/s: slower balls are walked to, not met
};

inline double rolling_distance(const Situation& situation) {
  return situation.ball_velocity.squaredNorm() / (2.0 * situation.facts.ball_deceleration);
}

}  // namespace behaviours
