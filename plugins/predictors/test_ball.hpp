// SPDX-License-Identifier: MIT
// What the tests of the predictors of the ball share: its mean and covariance as a whole, a ball about which all errors
// are correlated, areas that are seen, and a camera.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "ball_view.hpp"
#include "planar_state.hpp"

namespace ball {

using planar::Sighting, planar::State;

inline Eigen::Vector4d mean(const State& ball) {
  Eigen::Vector4d all;
  all << ball.position, ball.velocity;
  return all;
}

inline Eigen::Matrix4d covariance(const State& ball) {
  Eigen::Matrix4d all;
  all << ball.position_covariance, ball.cross, ball.cross.transpose(), ball.velocity_covariance;
  return all;
}

inline State correlated(const Eigen::Vector2d& velocity) {
  State ball;
  ball.position << 0.5, -1.0;
  ball.velocity = velocity;
  Eigen::Matrix4d root;
  root << 0.1, 0.0, 0.0, 0.0, 0.02, 0.2, 0.0, 0.0, 0.05, -0.03, 0.2, 0.0, 0.01, 0.04, 0.05, 0.15;
  const Eigen::Matrix4d all = root * root.transpose();
  ball.position_covariance = all.topLeftCorner<2, 2>();
  ball.cross = all.topRightCorner<2, 2>();
  ball.velocity_covariance = all.bottomRightCorner<2, 2>();
  return ball;
}

inline const View everywhere{{0.0, 0.0}, {-1.0, 0.0}, {-1.0, 0.0}, 4.0, 100.0};

// Ahead of the origin, 0.95 rad wide, 5 m deep.
inline View ahead() {
  const double half = 0.477;
  return {{0.0, 0.0}, {std::cos(-half), std::sin(-half)}, {std::cos(half), std::sin(half)}, half, 5.0};
}

// Tells positions with the deviation `noise` per axis.
struct Camera {
  std::mt19937_64 random;
  double noise = 0.05;

  explicit Camera(std::uint64_t seed) : random(seed) {}
  Sighting sight(const Eigen::Vector2d& truth) {
    std::normal_distribution<double> normal(0.0, noise);
    const double x = truth.x() + normal(random);
    const double y = truth.y() + normal(random);
    return {{x, y}, noise * noise * Eigen::Matrix2d::Identity()};
  }
  std::vector<Sighting> image(const std::vector<Eigen::Vector2d>& balls) {
    std::vector<Sighting> seen;
    for (const Eigen::Vector2d& each : balls) seen.push_back(sight(each));
    return seen;
  }
};

// Up to five balls anywhere on the field, in 5000 images, half of them of all of it: the weights stay probabilities,
// best first. step(balls, view) has the filter take in an image of them.
template <class Filter, class Step>
void expect_probabilities(const Filter& filter, const Step& step) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> place(-4.5, 4.5);
  std::uniform_int_distribution<int> count(0, 5);
  for (int i = 0; i < 5000; ++i) {
    std::vector<Eigen::Vector2d> balls(static_cast<std::size_t>(count(random)));
    for (Eigen::Vector2d& each : balls) {
      each.x() = place(random);
      each.y() = place(random);
    }
    step(balls, i % 2 == 0 ? everywhere : ahead());
    double sum = 0.0, last = 1.0;
    for (const auto& each : filter) {
      ASSERT_GT(each.weight, 0.0);
      ASSERT_LE(each.weight, last) << "best first";
      last = each.weight;
      sum += each.weight;
    }
    ASSERT_LE(sum, 1.0 + 1e-12);
  }
}

}  // namespace ball
