// SPDX-License-Identifier: MIT
// Angles at their borders, the two changes of frame, the nearest point of a segment.
#include "mind/geometry.hpp"

#include <gtest/gtest.h>

#include <random>

namespace regista::mind {
namespace {

TEST(Geometry, WrappedAnglesAreTheSameDirectionInTheHalfOpenTurn) {
  for (int turns = -20; turns <= 20; ++turns) {
    for (const double angle : {-pi, -3.0, -1e-12, 0.0, 1e-12, 1.0, pi / 2, 3.0, pi}) {
      const double given = angle + 2.0 * pi * turns, wrapped = wrap(given);
      EXPECT_GT(wrapped, -pi);
      EXPECT_LE(wrapped, pi);
      EXPECT_NEAR(std::cos(wrapped), std::cos(given), 1e-12);
      EXPECT_NEAR(std::sin(wrapped), std::sin(given), 1e-12);
    }
  }
  EXPECT_EQ(wrap(-pi), pi);
  EXPECT_EQ(wrap(pi), pi);
  EXPECT_EQ(wrap(std::nextafter(pi, 4.0)), std::nextafter(pi, 4.0) - 2.0 * pi);
  EXPECT_EQ(wrap(std::nextafter(-pi, 0.0)), std::nextafter(-pi, 0.0));
}

TEST(Geometry, AnglesOfVectorsAreInTheHalfOpenTurn) {
  EXPECT_EQ(angle_of({-1.0, -0.0}), pi);
  EXPECT_EQ(angle_of({-1.0, 0.0}), pi);
  EXPECT_DOUBLE_EQ(angle_of({0.0, -2.0}), -pi / 2);
  EXPECT_EQ(angle_of({0.0, 0.0}), 0.0);
}

TEST(Geometry, FramesRoundTripAndKeepLengths) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> place(-10.0, 10.0), heading(-pi, pi);
  for (int i = 0; i < 1000; ++i) {
    const double x = place(engine), y = place(engine), angle = heading(engine);
    const Frame2 frame(Pose{x, y, angle});
    const double px = place(engine), py = place(engine);
    const Vector2d point(px, py);
    EXPECT_LT((frame.to_field(frame.to_robot(point)) - point).norm(), 1e-12);
    EXPECT_LT((frame.to_robot(frame.to_field(point)) - point).norm(), 1e-12);
    EXPECT_NEAR(frame.direction_to_field(point).norm(), point.norm(), 1e-12);
    EXPECT_LT((frame.direction_to_robot(frame.direction_to_field(point)) - point).norm(), 1e-12);
    EXPECT_LT((frame.to_field({0, 0}) - Vector2d(x, y)).norm(), 1e-15);
    EXPECT_LT((frame.to_field({1, 0}) - Vector2d(x, y) - Vector2d(std::cos(angle), std::sin(angle))).norm(), 1e-12);
  }
  // Facing left: what is ahead lies to the left on the field.
  const Frame2 left(Pose{1.0, 2.0, pi / 2});
  EXPECT_LT((left.to_field({3.0, 0.5}) - Vector2d(0.5, 5.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace regista::mind
