// SPDX-License-Identifier: MIT
// What is believed of something that moves in the plane, a ball or a robot, by mean and covariance, and how a sighting
// changes it: the Kalman update in Joseph's form, which stays positive semi-definite (Bar-Shalom, Li, Kirubarajan,
// "Estimation with Applications to Tracking and Navigation", 2001). And what is believed when one of two beliefs holds.
#pragma once

#include <Eigen/Core>

namespace planar {

// Position and velocity with the blocks of their covariance; cross = E[dp dv']. m, m/s, field frame.
struct State {
  Eigen::Vector2d position = Eigen::Vector2d::Zero(), velocity = Eigen::Vector2d::Zero();
  Eigen::Matrix2d position_covariance = Eigen::Matrix2d::Zero(), cross = Eigen::Matrix2d::Zero(),
                  velocity_covariance = Eigen::Matrix2d::Zero();
};

struct Sighting {
  Eigen::Vector2d position;    // m, field frame
  Eigen::Matrix2d covariance;  // m^2
};

// Nothing but its place is believed from now on.
inline void stand(State& state) {
  state.velocity.setZero();
  state.cross.setZero();
  state.velocity_covariance.setZero();
}

// A sighting that is off by `innovation`. noise: covariance of the sighting; inverse: of the innovation's covariance.
// The velocity of what does not move stays as it is.
inline void update(State& state, const Eigen::Vector2d& innovation, const Eigen::Matrix2d& noise,
                   const Eigen::Matrix2d& inverse, bool moves) {
  const Eigen::Matrix2d gain = state.position_covariance * inverse;
  const Eigen::Matrix2d kept = Eigen::Matrix2d::Identity() - gain;
  state.position += gain * innovation;
  if (moves) {
    const Eigen::Matrix2d velocity_gain = state.cross.transpose() * inverse;
    state.velocity += velocity_gain * innovation;
    const Eigen::Matrix2d noisy = noise * velocity_gain.transpose();
    const Eigen::Matrix2d shared = velocity_gain * state.cross;
    state.velocity_covariance +=
        velocity_gain * (state.position_covariance * velocity_gain.transpose() + noisy) - shared - shared.transpose();
    state.cross = (kept * (state.cross - state.position_covariance * velocity_gain.transpose()) + gain * noisy).eval();
    state.velocity_covariance(1, 0) = state.velocity_covariance(0, 1);
  }
  state.position_covariance =
      (kept * state.position_covariance * kept.transpose() + gain * noise * gain.transpose()).eval();
  state.position_covariance(1, 0) = state.position_covariance(0, 1);
}

// The mixture of `a` and `b`, by its first two moments, into `a`. share: probability of b, in [0, 1].
inline void mix(State& a, const State& b, double share) {
  const double other = 1.0 - share, both = share * other;
  const Eigen::Vector2d dp = b.position - a.position, dv = b.velocity - a.velocity;
  a.position += share * dp;
  a.velocity += share * dv;
  a.position_covariance = other * a.position_covariance + share * b.position_covariance + both * dp * dp.transpose();
  a.cross = other * a.cross + share * b.cross + both * dp * dv.transpose();
  a.velocity_covariance = other * a.velocity_covariance + share * b.velocity_covariance + both * dv * dv.transpose();
}

}  // namespace planar
