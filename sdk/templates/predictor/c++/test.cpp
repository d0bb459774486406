// SPDX-License-Identifier: MIT
// The algorithm alone.
#include <gtest/gtest.h>

#include "algorithm.hpp"

namespace {

MovingBall rolling() {
  return {.x = 1.0, .y = 2.0, .vx = 0.5, .vy = -1.0, .place = 0.01, .cross = 0.02, .velocity = 0.1};
}

TEST(MovingBall, KeepsItsVelocity) {
  MovingBall ball = rolling();
  predict(ball, 2.0, 1.0);
  EXPECT_DOUBLE_EQ(ball.x, 2.0);
  EXPECT_DOUBLE_EQ(ball.y, 0.0);
  EXPECT_DOUBLE_EQ(ball.vx, 0.5);
  EXPECT_DOUBLE_EQ(ball.age, 2.0);
}

TEST(MovingBall, IsLessCertainTheLongerItIsUnseen) {
  MovingBall ball = rolling();
  double before = ball.place;
  for (int tick = 0; tick < 50; ++tick) {
    predict(ball, 0.1, 1.0);
    EXPECT_GT(ball.place, before);
    before = ball.place;
  }
}

TEST(MovingBall, OneStepIsAsGoodAsTwo) {
  MovingBall once = rolling(), twice = rolling();
  predict(once, 1.0, 0.7);
  predict(twice, 0.4, 0.7);
  predict(twice, 0.6, 0.7);
  EXPECT_NEAR(once.place, twice.place, 1e-12);
  EXPECT_NEAR(once.cross, twice.cross, 1e-12);
  EXPECT_NEAR(once.velocity, twice.velocity, 1e-12);
}

TEST(MovingBall, LearnsAVelocityFromWhereItIsSeen) {
  MovingBall ball{.place = 0.01, .velocity = 1.0};
  for (int tick = 1; tick <= 30; ++tick) {
    predict(ball, 0.1, 0.1);
    correct(ball, 0.1 * tick, -0.05 * tick, 0.01);
  }
  EXPECT_NEAR(ball.x, 3.0, 0.05);
  EXPECT_NEAR(ball.vx, 1.0, 0.05);
  EXPECT_NEAR(ball.vy, -0.5, 0.05);
  EXPECT_LT(ball.place, 0.01);
  EXPECT_EQ(ball.age, 0.0);
}

}  // namespace
