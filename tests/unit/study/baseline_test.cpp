// SPDX-License-Identifier: MIT
// The baselines against the closed forms of mechanics, and against small steps.
#include "study/prediction/evaluation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace regista::study {
namespace {

using Eigen::Vector2d;

TEST(FittedVelocity, IsExactOnALine) {
  std::vector<Sample> samples;
  for (const double t : {1000.0, 1000.013, 1000.03, 1000.1}) {
    samples.push_back({t, 0, 3.0 - 2.5 * (t - 1000.0), 1.0 + 0.5 * (t - 1000.0)});
  }
  const auto velocity = fitted_velocity(samples, 4);
  ASSERT_TRUE(velocity);
  EXPECT_NEAR(velocity->x(), -2.5, 1e-9);
  EXPECT_NEAR(velocity->y(), 0.5, 1e-9);
}

// Slope of least squares through (0, 0), (1, 1), (2, 1), by hand: 1/2.
TEST(FittedVelocity, MinimisesSquares) {
  const std::vector<Sample> samples{{0, 0, 0, 0}, {1, 0, 1, 0}, {2, 0, 1, 0}};
  EXPECT_NEAR(fitted_velocity(samples, 3)->x(), 0.5, 1e-15);
}

TEST(FittedVelocity, TakesEnoughObservationsAndTwoTimes) {
  const std::vector<Sample> samples{{0, 0, 0, 0}, {1, 0, 1, 0}, {2, 0, 1, 0}};
  EXPECT_FALSE(fitted_velocity(samples, 4));
  EXPECT_FALSE(fitted_velocity({}, 2));
  const std::vector<Sample> at_once{{5, 0, 0, 0}, {5, 0, 1, 0}, {5, 0, 2, 0}};
  EXPECT_FALSE(fitted_velocity(at_once, 2));
}

TEST(Decay, FollowsItsDifferentialEquation) {
  const Vector2d start(1.2, -0.9);  // 1.5 m/s
  for (const double ahead : {0.1, 1.0, 4.9, 5.1, 30.0}) {
    Vector2d rolling = start, rolled_to = Vector2d::Zero(), slackening = start, slackened_to = Vector2d::Zero();
    const int steps = 200'000;
    const double dt = ahead / steps;
    for (int i = 0; i < steps; ++i) {
      rolled_to += dt * rolling;
      slackened_to += dt * slackening;
      const double speed = rolling.norm();
      rolling *= speed > 0.3 * dt ? 1.0 - 0.3 * dt / speed : 0.0;
      slackening *= 1.0 - dt / 0.8;
    }
    EXPECT_LT((rolled(start, ahead, 0.3) - rolled_to).norm(), 2e-4) << ahead;
    EXPECT_LT((slackened(start, ahead, 0.8) - slackened_to).norm(), 2e-4) << ahead;
  }
  EXPECT_NEAR(rolled(start, 1e9, 0.3).norm(), 1.5 * 1.5 / 0.6, 1e-12) << "v^2 / 2a";
  EXPECT_NEAR(slackened(start, 1e9, 0.8).norm(), 1.5 * 0.8, 1e-12) << "v tau";
  EXPECT_EQ(rolled(Vector2d::Zero(), 1.0, 0.3), Vector2d::Zero());
}

}  // namespace
}  // namespace regista::study
