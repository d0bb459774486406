// SPDX-License-Identifier: MIT
#include "campaign/match_setup.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "config/errors.hpp"
#include "config/scalar.hpp"

namespace regista::campaign {
namespace {

TEST(Seed, TakesEveryNumberOf64Bits) {
  EXPECT_EQ(config::parse_whole("--seed", "0", 0, UINT64_MAX), 0u);
  EXPECT_EQ(config::parse_whole("--seed", "18446744073709551615", 0, UINT64_MAX), UINT64_MAX);
}

TEST(Seed, RefusesEverythingElse) {
  for (const char* text : {"", " 1", "1 ", "-1", "+1", "1.0", "1e3", "0x10", "18446744073709551616", "one"}) {
    EXPECT_THROW(config::parse_whole("--seed", text, 0, UINT64_MAX), config::BadInput) << text;
  }
}

TEST(MatchSetup, LimitsAreSecondsAboveZero) {
  const plugin::Catalogue none({});
  for (const char* text : {"0", "-1", "nan", "inf", "1e400", "10s", " 1", "1000001"}) {
    Job job;
    job.teams = {"a.yaml", "b.yaml"};
    job.limit = text;
    EXPECT_THROW(match_setup(job, none), config::BadInput) << text;
  }
}

}  // namespace
}  // namespace regista::campaign
