// SPDX-License-Identifier: MIT
// Plane geometry that behaviours need: angles, and the change between the field's frame and the robot's. Radians,
// metres.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace behaviours {

using Eigen::Vector2d;

struct Pose {
  double x = 0.0, y = 0.0, heading = 0.0;
};

inline constexpr double pi = std::numbers::pi;

// The same angle in (-pi, pi].
inline double wrap(double angle) {
  if (angle > -pi && angle <= pi) return angle;
  const double wrapped = std::remainder(angle, 2.0 * pi);
  return wrapped <= -pi ? pi : wrapped;
}

// In (-pi, pi]; 0 for no direction at all.
inline double angle_of(const Vector2d& v) {
  const double angle = std::atan2(v.y(), v.x());
  return angle == -pi ? pi : angle;  // atan2 says -pi for a y of -0
}

// Turned to the left by an angle of this cosine and sine.
inline Vector2d turned(const Vector2d& v, double cosine, double sine) {
  return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
}

// A pose with its direction as a vector, so that changing frames costs no trigonometry.
class Frame2 {
 public:
  explicit Frame2(const Pose& pose)
      : origin_(pose.x, pose.y), cos_(std::cos(pose.heading)), sin_(std::sin(pose.heading)) {}
  Vector2d direction_to_robot(const Vector2d& v) const {
    return {cos_ * v.x() + sin_ * v.y(), cos_ * v.y() - sin_ * v.x()};
  }
  Vector2d to_robot(const Vector2d& v) const { return direction_to_robot(v - origin_); }
  const Vector2d& origin() const { return origin_; }

 private:
  Vector2d origin_;
  double cos_, sin_;
};

// The point of the segment a-b nearest to p.
inline Vector2d nearest_on_segment(const Vector2d& a, const Vector2d& b, const Vector2d& p) {
  const Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  if (length2 == 0.0) return a;
  const double t = std::fmin(1.0, std::fmax(0.0, (p - a).dot(along) / length2));
  return a + t * along;
}

}  // namespace behaviours
