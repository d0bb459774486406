// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <regista/abi.h>

#include <set>
#include <stdexcept>
#include <string>

#include "cli/live_line.hpp"
#include "cli/match_report.hpp"

namespace regista::cli {
namespace {

TEST(RoleNames, ShowTheListOnlyWhereTheNameAloneIsAmbiguous) {
  const std::vector<match::Role> roles{{.name = "goalkeeper"},
                                       {.name = "striker"},
                                       {.name = "goalkeeper", .list = "searching"},
                                       {.name = "seeker", .list = "searching"}};
  EXPECT_EQ(role_names(roles),
            (std::vector<std::string>{"playing.goalkeeper", "striker", "searching.goalkeeper", "seeker"}));
}

TEST(ReasonNames, EveryReasonHasOne) {
  std::set<std::string_view> names;
  for (int reason = 0; reason < REGISTA_EVENT_COUNT; ++reason) names.insert(reason_name(reason));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(REGISTA_EVENT_COUNT));
  EXPECT_EQ(reason_name(REGISTA_EVENT_PERIOD), "period");
  EXPECT_EQ(reason_name(REGISTA_EVENT_GOALKEEPER_SAW_BALL), "goalkeeper_saw_ball");
  EXPECT_EQ(reason_name(REGISTA_EVENT_RETURNED), "returned");
  EXPECT_EQ(reason_name(REGISTA_EVENT_OFFER), "offer");
  EXPECT_THROW(reason_name(REGISTA_EVENT_COUNT), std::out_of_range);
}

TEST(ClockText, IsMinutesAndSeconds) {
  EXPECT_EQ(clock_text(0.0), "00:00");
  EXPECT_EQ(clock_text(59.99), "00:59");
  EXPECT_EQ(clock_text(192.4), "03:12");
  EXPECT_EQ(clock_text(36000.0), "600:00");
}

}  // namespace
}  // namespace regista::cli
