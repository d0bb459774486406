// SPDX-License-Identifier: MIT
// What the tests of imm_ball share.
#pragma once

#include <Eigen/Dense>

#include "algorithm.hpp"

namespace imm_ball {

using Eigen::Matrix2d;
using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector4d;

inline const View everywhere{{0.0, 0.0}, {-1.0, 0.0}, {-1.0, 0.0}, 4.0, 100.0};
inline constexpr auto in_reach = [](const Whereabouts&) { return true; };
inline constexpr auto out_of_reach = [](const Whereabouts&) { return false; };

inline Matrix4d covariance(const BallState& ball) {
  Matrix4d all;
  all << ball.position_covariance, ball.cross, ball.cross.transpose(), ball.velocity_covariance;
  return all;
}

inline Vector4d mean(const BallState& ball) {
  Vector4d all;
  all << ball.position, ball.velocity;
  return all;
}

// Squared error under the covariance that the estimate tells.
inline double normalised(const Vector2d& error, const Matrix2d& told) { return error.dot(told.inverse() * error); }
inline double normalised(const Vector4d& error, const Matrix4d& told) { return error.dot(told.inverse() * error); }

}  // namespace imm_ball
