// SPDX-License-Identifier: MIT
// The algorithm alone.
#include <gtest/gtest.h>

#include "algorithm.hpp"

namespace {

constexpr double pi = 3.14159265358979323846;

TEST(Beside, KeepsAPlaceThatIsFarEnough) {
  const Place place = beside(1.0, 0.0, -2.0, 0.0, 1.0);
  EXPECT_DOUBLE_EQ(place.x, -2.0);
  EXPECT_DOUBLE_EQ(place.y, 0.0);
  EXPECT_DOUBLE_EQ(place.heading, 0.0);
}

TEST(Beside, GoesStraightAwayFromTheBall) {
  const Place place = beside(1.0, 1.0, 1.0, 1.5, 2.0);
  EXPECT_DOUBLE_EQ(place.x, 1.0);
  EXPECT_DOUBLE_EQ(place.y, 3.0);
  EXPECT_DOUBLE_EQ(place.heading, -pi / 2.0);
}

TEST(Beside, StandsBehindABallThatIsWanted) {
  const Place place = beside(0.5, 0.2, 0.5, 0.2, 1.0);
  EXPECT_DOUBLE_EQ(place.x, -0.5);
  EXPECT_DOUBLE_EQ(place.y, 0.2);
  EXPECT_DOUBLE_EQ(place.heading, 0.0);
}

}  // namespace
