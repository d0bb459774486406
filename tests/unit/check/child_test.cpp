// SPDX-License-Identifier: MIT
#include "check/isolation.hpp"

#include <gtest/gtest.h>

namespace regista::check {
namespace {

TEST(Deadline, OfWallTimeLeavesRoomForTheProcessorTimeThatWasAskedFor) {
  EXPECT_EQ(Deadline{.processor_seconds = 1}.wall_seconds(), 300.0);
  EXPECT_EQ(Deadline{}.wall_seconds(), 300.0);
  EXPECT_EQ(Deadline{.processor_seconds = 1000}.wall_seconds(), 30'000.0);
}

}  // namespace
}  // namespace regista::check
