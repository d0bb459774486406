// SPDX-License-Identifier: MIT
#include "results/replay.hpp"

#include <gtest/gtest.h>

namespace regista::results {
namespace {

using Clock = RefreshSchedule::Clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(RefreshSchedule, BeginsAtOnceAndThenComesEveryFiveSeconds) {
  RefreshSchedule pace;
  const Clock::time_point begin{seconds(1000)};
  EXPECT_TRUE(pace.due(begin));
  pace.done(begin, begin + milliseconds(20));
  EXPECT_FALSE(pace.due(begin + milliseconds(5000)));
  EXPECT_TRUE(pace.due(begin + milliseconds(5020)));
  EXPECT_EQ(pace.seconds_from(begin + milliseconds(20)), 5);
}

// Whatever a writing takes, of all time it takes at most two hundredths.
TEST(RefreshSchedule, WhatTakesLongComesSeldom) {
  for (const int each : {1, 50, 200, 1000, 7000}) {
    RefreshSchedule pace;
    Clock::time_point now{seconds(50)};
    const Clock::time_point begin = now;
    Clock::duration spent{};
    for (int times = 0; times < 20; ++times) {
      while (!pace.due(now)) now += milliseconds(10);
      pace.done(now, now + milliseconds(each));
      now += milliseconds(each);
      spent += milliseconds(each);
    }
    while (!pace.due(now)) now += milliseconds(10);
    EXPECT_LE(50 * spent, now - begin) << each << " ms";
  }
}

}  // namespace
}  // namespace regista::results
