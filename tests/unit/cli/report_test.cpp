// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "results/played_match.hpp"

namespace regista::cli {
namespace {

TEST(ClockText, IsMinutesAndSeconds) {
  EXPECT_EQ(results::clock_text(0.0), "00:00");
  EXPECT_EQ(results::clock_text(59.99), "00:59");
  EXPECT_EQ(results::clock_text(192.4), "03:12");
  EXPECT_EQ(results::clock_text(36000.0), "600:00");
}

}  // namespace
}  // namespace regista::cli
