// SPDX-License-Identifier: MIT
// Where a camera would have seen a ball. Shared by the predictors of the ball.
#pragma once

#include <Eigen/Core>

namespace ball {

// A sector of a disc, seen from `apex`.
struct View {
  Eigen::Vector2d apex;
  Eigen::Vector2d right, left;  // unit vectors along its edges
  double half_angle, range;

  // True when `point` is inside and at least `margin` away from every edge.
  bool holds(const Eigen::Vector2d& point, double margin) const {
    constexpr double half_pi = 1.57079632679489662, pi = 2.0 * half_pi;
    const Eigen::Vector2d arm = point - apex;
    const double reach = range - margin;
    if (reach <= 0.0 || arm.squaredNorm() > reach * reach) return false;
    if (half_angle >= pi) return true;
    const bool inside_right = right.x() * arm.y() - right.y() * arm.x() >= margin;
    const bool inside_left = arm.x() * left.y() - arm.y() * left.x() >= margin;
    return half_angle < half_pi ? inside_right && inside_left : inside_right || inside_left;
  }
};

}  // namespace ball
