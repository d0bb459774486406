// SPDX-License-Identifier: MIT
// What is believed of a ball, by mean and covariance, and how a sighting changes it: the Kalman update in Joseph's
// form, which stays positive semi-definite (Bar-Shalom, Li, Kirubarajan, "Estimation with Applications to Tracking and
// Navigation", 2001). Shared by the predictors of the ball.
#pragma once

#include <Eigen/Core>

namespace ball {

// Position and velocity with the blocks of their covariance; cross = E[dp dv']. m, m/s, field frame.
struct State {
  Eigen::Vector2d position = Eigen::Vector2d::Zero(), velocity = Eigen::Vector2d::Zero();
  Eigen::Matrix2d position_covariance = Eigen::Matrix2d::Zero(), cross = Eigen::Matrix2d::Zero(),
                  velocity_covariance = Eigen::Matrix2d::Zero();
};

// Nothing but its place is believed from now on.
inline void stand(State& ball) {
  ball.velocity.setZero();
  ball.cross.setZero();
  ball.velocity_covariance.setZero();
}

// A sighting that is off by `innovation`. noise: covariance of the sighting; inverse: of the innovation's covariance.
// The velocity of a ball that does not move stays as it is.
inline void update(State& ball, const Eigen::Vector2d& innovation, const Eigen::Matrix2d& noise,
                   const Eigen::Matrix2d& inverse, bool moves) {
  const Eigen::Matrix2d gain = ball.position_covariance * inverse;
  const Eigen::Matrix2d kept = Eigen::Matrix2d::Identity() - gain;
  ball.position += gain * innovation;
  if (moves) {
    const Eigen::Matrix2d velocity_gain = ball.cross.transpose() * inverse;
    ball.velocity += velocity_gain * innovation;
    const Eigen::Matrix2d noisy = noise * velocity_gain.transpose();
    const Eigen::Matrix2d shared = velocity_gain * ball.cross;
    ball.velocity_covariance +=
        velocity_gain * (ball.position_covariance * velocity_gain.transpose() + noisy) - shared - shared.transpose();
    ball.cross = (kept * (ball.cross - ball.position_covariance * velocity_gain.transpose()) + gain * noisy).eval();
    ball.velocity_covariance(1, 0) = ball.velocity_covariance(0, 1);
  }
  ball.position_covariance =
      (kept * ball.position_covariance * kept.transpose() + gain * noise * gain.transpose()).eval();
  ball.position_covariance(1, 0) = ball.position_covariance(0, 1);
}

}  // namespace ball
