// SPDX-License-Identifier: MIT
// Where to stand beside the ball. Knows nothing of Regista, so that it can be tested and used alone.
#pragma once

#include <cmath>

struct Place {
  double x = 0.0, y = 0.0, heading = 0.0;
};

// The point nearest to (x, y) that is not nearer to the ball than `distance`, facing the ball. Where the ball itself is
// wanted, the point is behind it, towards the own goal.
inline Place beside(double ball_x, double ball_y, double x, double y, double distance) {
  const double dx = x - ball_x, dy = y - ball_y, away = std::hypot(dx, dy);
  Place out{x, y, 0.0};
  if (away < 1e-6) {
    out = {ball_x - distance, ball_y, 0.0};
  } else if (away < distance) {
    out = {ball_x + dx * distance / away, ball_y + dy * distance / away, 0.0};
  }
  out.heading = std::atan2(ball_y - out.y, ball_x - out.x);
  return out;
}
