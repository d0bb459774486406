// SPDX-License-Identifier: MIT
// The algorithm alone.
#include <gtest/gtest.h>

#include "algorithm.hpp"

namespace {

TEST(Nearness, BeginsBelowTheDistance) {
  Nearness nearness;
  EXPECT_FALSE(nearness.update(2.1, 2.0, 0.5));
  EXPECT_TRUE(nearness.update(1.9, 2.0, 0.5));
}

TEST(Nearness, EndsAboveTheMargin) {
  Nearness nearness;
  EXPECT_TRUE(nearness.update(1.9, 2.0, 0.5));
  EXPECT_TRUE(nearness.update(2.4, 2.0, 0.5));
  EXPECT_FALSE(nearness.update(2.6, 2.0, 0.5));
  EXPECT_FALSE(nearness.update(2.4, 2.0, 0.5));
}

TEST(Nearness, ForgetsWhatWas) {
  Nearness nearness;
  EXPECT_TRUE(nearness.update(1.0, 2.0, 0.5));
  nearness.forget();
  EXPECT_FALSE(nearness.update(2.2, 2.0, 0.5));
}

}  // namespace
