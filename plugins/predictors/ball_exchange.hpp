// SPDX-License-Identifier: MIT
// From the host's visible area to the view of a ball. Glue of the predictors of the ball.
#pragma once

#include <cmath>

#include <regista/predictor.hpp>

#include "ball_view.hpp"

namespace ball {

inline View view_of(const regista::VisibleArea& area) {
  const double right = area.heading - area.half_angle, left = area.heading + area.half_angle;
  return {{area.x, area.y},
          {std::cos(right), std::sin(right)},
          {std::cos(left), std::sin(left)},
          area.half_angle,
          area.range_ball};
}

}  // namespace ball
