// SPDX-License-Identifier: MIT
#include "match/game_state.hpp"

#include <gtest/gtest.h>
#include <regista/abi.h>

#include <set>

#include "match/metrics_coordination.hpp"
#include "plugin/description.hpp"

namespace regista::match {
namespace {

TEST(RoleNames, ShowTheListOnlyWhereTheNameAloneIsAmbiguous) {
  const std::vector<Role> roles{{.name = "goalkeeper"},
                                {.name = "striker"},
                                {.name = "goalkeeper", .list = "searching"},
                                {.name = "seeker", .list = "searching"}};
  EXPECT_EQ(role_names(roles),
            (std::vector<std::string>{"playing.goalkeeper", "striker", "searching.goalkeeper", "seeker"}));
}

TEST(ReasonNames, EveryReasonHasOne) {
  const auto& all = plugin::event_names;
  EXPECT_EQ(std::set<std::string_view>(all.begin(), all.end()).size(), std::size_t{REGISTA_EVENT_COUNT});
  EXPECT_STREQ(all[REGISTA_EVENT_PERIOD], "period");
  EXPECT_STREQ(all[REGISTA_EVENT_GOALKEEPER_SAW_BALL], "goalkeeper_saw_ball");
  EXPECT_STREQ(all[REGISTA_EVENT_RETURNED], "returned");
  EXPECT_STREQ(all[REGISTA_EVENT_OFFER], "offer");
}

TEST(Words, OfEventsAreOne) {
  EXPECT_EQ(word(EventKind::kick_off), "kick_off");
  for (int kind = 0; kind <= static_cast<int>(EventKind::opening); ++kind) {
    EXPECT_EQ(word(static_cast<EventKind>(kind)).find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos);
  }
}

TEST(Words, OfOffencesAreOne) {
  std::set<std::string> words;
  for (std::size_t i = 0; i < offence_count; ++i) words.insert(word(static_cast<Offence>(i)));
  EXPECT_EQ(words.size(), offence_count);
  EXPECT_EQ(word(Offence::illegal_position_in_set), "illegal_position_in_set");
}

}  // namespace
}  // namespace regista::match
