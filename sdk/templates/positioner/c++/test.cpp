// SPDX-License-Identifier: MIT
// The algorithm alone.
#include <gtest/gtest.h>

#include "algorithm.hpp"

namespace {

TEST(Ring, IsEvenAndCounterClockwise) {
  std::vector<Point> points;
  ring({1.0, 1.0}, 0.5, 4, {4.5, 3.0}, points);
  ASSERT_EQ(points.size(), 4u);
  const double x[] = {1.5, 1.0, 0.5, 1.0}, y[] = {1.0, 1.5, 1.0, 0.5};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(points[i].x, x[i], 1e-12) << i;
    EXPECT_NEAR(points[i].y, y[i], 1e-12) << i;
  }
}

TEST(Ring, StaysOnTheField) {
  std::vector<Point> points;
  ring({4.4, -2.9}, 2.0, 12, {4.5, 3.0}, points);
  for (const Point& each : points) {
    EXPECT_LE(std::abs(each.x), 4.5);
    EXPECT_LE(std::abs(each.y), 3.0);
  }
}

TEST(Ring, ForgetsTheOneBefore) {
  std::vector<Point> points(7);
  ring({}, 1.0, 3, {4.5, 3.0}, points);
  EXPECT_EQ(points.size(), 3u);
}

}  // namespace
