// SPDX-License-Identifier: MIT
// What one robot believes at one instant, as far as the truth can be held against it. Plain values, so that any mind
// can be asked. Field frame of the robot's own side, metres.
#pragma once

#include <functional>
#include <vector>

#include "match/side.hpp"

namespace regista::match {

// A place with its covariance, m^2.
struct Estimate {
  bool known = false;  // it believes something at all
  Vector at;
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

struct Belief {
  Estimate self, ball;
  std::vector<Estimate> teammates;  // by robot (n - 1); known: it reckons with it. Its own is not looked at
  std::vector<Vector> opponents;
};

// Fills `out`, whose memory is used again, with what robot `number` believes since its last decision.
using Beliefs = std::function<void(Side side, int number, Belief& out)>;

}  // namespace regista::match
