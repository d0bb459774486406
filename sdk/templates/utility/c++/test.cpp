// SPDX-License-Identifier: MIT
// The algorithm alone.
#include <gtest/gtest.h>

#include "algorithm.hpp"

namespace {

TEST(Nearness, IsOneThereAndAHalfWhereItWasAsked) {
  EXPECT_DOUBLE_EQ(nearness(0.0, 2.0), 1.0);
  EXPECT_DOUBLE_EQ(nearness(2.0, 2.0), 0.5);
}

TEST(Nearness, FallsWithTheDistance) {
  for (double distance = 0.0; distance < 20.0; distance += 0.1) {
    EXPECT_GT(nearness(distance, 2.0), nearness(distance + 0.1, 2.0));
    EXPECT_GT(nearness(distance, 2.0), 0.0);
  }
}

}  // namespace
