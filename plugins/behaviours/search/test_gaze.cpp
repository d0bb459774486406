// SPDX-License-Identifier: MIT
// Where a robot looks, against moments counted by hand.
#include <gtest/gtest.h>

#include "../gaze.hpp"
#include "../test_situations.hpp"

namespace {

using namespace behaviours;

constexpr double quarter = pi / 2;  // as far as the head turns

// Robot 1 at the moment when its own clock, which is 0.37 s ahead, shows `clock`.
double look_at(Situation situation, double clock) {
  situation.time = clock - 0.37;
  return look(situation, {});
}

TEST(Gaze, SweepsWhileTheBallIsLost) {
  const Situation lost = standing(0, 0);
  EXPECT_NEAR(look_at(lost, 4.0), -quarter, 1e-9);
  EXPECT_NEAR(look_at(lost, 5.0), 0.0, 1e-9);
  EXPECT_NEAR(look_at(lost, 6.0), quarter, 1e-9);
  EXPECT_NEAR(look_at(lost, 6.5), quarter / 2, 1e-9);
  EXPECT_NEAR(look_at(lost, 8.0), -quarter, 1e-9);
}

TEST(Gaze, KeepsItsEyesOnTheBall) {
  // Heading left: a ball ahead of the field is to the right.
  const Situation situation = with_ball(standing(1, 1, quarter), {3, 3});
  EXPECT_NEAR(look_at(situation, 3.0), -pi / 4, 1e-12);
  EXPECT_NEAR(look_at(with_ball(standing(1, 1, quarter), {1, 3}), 3.0), 0.0, 1e-12);
  EXPECT_EQ(look_at(with_ball(standing(1, 1, quarter), {0.8, -3}), 3.0), quarter) << "no farther than the head turns";
}

TEST(Gaze, LooksAwayNowAndThen) {
  const Situation situation = with_ball(standing(0, 0), {2, 0});
  EXPECT_NEAR(look_at(situation, 8.001), -quarter, 0.01);
  EXPECT_NEAR(look_at(situation, 8.6), quarter, 1e-9);
  EXPECT_NEAR(look_at(situation, 9.199), -quarter, 0.01);
  EXPECT_NEAR(look_at(situation, 9.201), 0.0, 1e-12);
  EXPECT_NEAR(look_at(situation, 11.99), 0.0, 1e-12);
}

TEST(Gaze, NotWhenTheBallIsNear) {
  EXPECT_NEAR(look_at(with_ball(standing(0, 0), {0.79, 0}), 8.6), 0.0, 1e-12);
  EXPECT_NEAR(look_at(with_ball(standing(0, 0), {0.81, 0}), 8.6), quarter, 1e-9);
}

TEST(Gaze, EachRobotAtItsOwnMoment) {
  Situation one = standing(0, 0), other = one;
  one.facts.own_number = 2;
  other.facts.own_number = 5;
  for (int k = 0; k < 100; ++k) {
    one.time = 10.0 + 0.1 * k + 3 * 0.37;
    other.time = 10.0 + 0.1 * k;
    EXPECT_NEAR(look(one, {}), look(other, {}), 1e-9);
  }
}

TEST(Gaze, NeverFartherThanTheHeadTurns) {
  for (const double limit : {0.0, 0.5, 2.0}) {
    for (int k = 0; k < 400; ++k) {
      Situation situation = standing(0.1 * k - 20.0, 1, 0.05 * k - 3.1);
      situation.time = 0.17 * k;
      situation.facts.head_yaw = limit;
      EXPECT_LE(std::abs(look(situation, {})), limit);
      EXPECT_LE(std::abs(look(with_ball(situation, {0, 0}), {})), limit);
    }
  }
}

}  // namespace
