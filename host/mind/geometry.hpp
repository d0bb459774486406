// SPDX-License-Identifier: MIT
// Plane geometry for all parts of a mind: angles, and conversions between robot frame and field frame. Radians, metres.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "mind/percepts.hpp"

namespace regista::mind {

using Eigen::Vector2d;

inline constexpr double pi = std::numbers::pi;

// Returns the angle in (-pi, pi] that differs from `angle` by full turns.
inline double wrap(double angle) {
  if (angle > -pi && angle <= pi) return angle;
  const double wrapped = std::remainder(angle, 2.0 * pi);
  return wrapped <= -pi ? pi : wrapped;
}

inline Vector2d position(const Pose& pose) { return {pose.x, pose.y}; }

// Returns the angle of `v` in (-pi, pi]; 0 for a zero vector.
inline double angle_of(const Vector2d& v) {
  const double angle = std::atan2(v.y(), v.x());
  return angle == -pi ? pi : angle;  // atan2 gives -pi for y = -0
}

// A pose whose heading is stored as a vector, so that changes of frame need no trigonometry.
class Frame2 {
 public:
  explicit Frame2(const Pose& pose)
      : origin_(pose.x, pose.y), cos_(std::cos(pose.heading)), sin_(std::sin(pose.heading)) {}
  Vector2d direction_to_field(const Vector2d& v) const {
    return {cos_ * v.x() - sin_ * v.y(), sin_ * v.x() + cos_ * v.y()};
  }
  Vector2d direction_to_robot(const Vector2d& v) const {
    return {cos_ * v.x() + sin_ * v.y(), cos_ * v.y() - sin_ * v.x()};
  }
  Vector2d to_field(const Vector2d& v) const { return origin_ + direction_to_field(v); }
  Vector2d to_robot(const Vector2d& v) const { return direction_to_robot(v - origin_); }
  const Vector2d& origin() const { return origin_; }

 private:
  Vector2d origin_;
  double cos_, sin_;
};

}  // namespace regista::mind
