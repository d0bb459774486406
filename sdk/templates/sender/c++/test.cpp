// SPDX-License-Identifier: MIT
// The algorithm alone.
#include <gtest/gtest.h>

#include "algorithm.hpp"

namespace {

constexpr Thrift thrift{.period = 10.0, .after_news = 2.0};

TEST(Due, WaitsForItsPeriodWithoutNews) {
  EXPECT_FALSE(due(thrift, 9.9, false, 100, 90.0));
  EXPECT_TRUE(due(thrift, 10.0, false, 100, 110.0));
}

TEST(Due, NewsDoNotWait) {
  EXPECT_TRUE(due(thrift, 2.0, true, 100, 100.0));
  EXPECT_FALSE(due(thrift, 1.9, true, 100, 100.0));
}

TEST(Due, NewsWaitWhileTooMuchWasSpent) {
  EXPECT_FALSE(due(thrift, 9.9, true, 99, 100.0));
  EXPECT_TRUE(due(thrift, 10.0, true, 99, 100.0));
}

TEST(Due, SpendsNothingThatIsNotThere) {
  EXPECT_FALSE(due(thrift, 100.0, true, 0, 0.0));
  EXPECT_FALSE(due(thrift, 100.0, true, -1, -1.0));
}

}  // namespace
