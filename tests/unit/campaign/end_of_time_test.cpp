// SPDX-License-Identifier: MIT
#include "campaign/engine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>

#include "config/errors.hpp"

namespace regista::campaign {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class EndOfTimeTest : public testing::Test {
 protected:
  EndOfTimeTest() { zone("UTC"); }
  ~EndOfTimeTest() override {
    unsetenv("TZ");
    tzset();
  }
  static void zone(const char* name) {
    setenv("TZ", name, 1);
    tzset();
  }
  static Moment at(std::time_t time) { return std::chrono::system_clock::from_time_t(time); }
  // 2026-11-28 08:30:15 in UTC
  const std::time_t now = 1795854615;
};

TEST_F(EndOfTimeTest, ATimeOfDayIsTheNextOne) {
  EXPECT_EQ(in_words(at(now)), "2026-11-28 08:30");
  EXPECT_EQ(in_words(*end_of_time("08:31", "", at(now))), "2026-11-28 08:31");
  EXPECT_EQ(in_words(*end_of_time("08:30", "", at(now))), "2026-11-29 08:30");
  EXPECT_EQ(in_words(*end_of_time("00:00", "", at(now))), "2026-11-29 00:00");
  EXPECT_EQ(*end_of_time("08:31", "", at(now)), at(now + 45));
  // The last day of a month, and of a year.
  EXPECT_EQ(in_words(*end_of_time("08:00", "", at(now + 2 * 86400))), "2026-12-01 08:00");
  EXPECT_EQ(in_words(*end_of_time("08:00", "", at(now + 33 * 86400))), "2027-01-01 08:00");
}

TEST_F(EndOfTimeTest, OneWithADayIsThatOne) {
  EXPECT_EQ(in_words(*end_of_time("2026-11-28T08:31", "", at(now))), "2026-11-28 08:31");
  EXPECT_EQ(in_words(*end_of_time("2027-03-01 00:05", "", at(now))), "2027-03-01 00:05");
}

// The clock of the machine counts: 09:00 in Vienna is 08:00 in UTC. 02:30 of 28 March 2027 is left out there.
TEST_F(EndOfTimeTest, TimesAreOfTheMachinesZone) {
  zone("CET-1CEST,M3.5.0,M10.5.0/3");
  EXPECT_EQ(*end_of_time("10:00", "", at(now)), at(now + 1785));
  EXPECT_THAT([&] { end_of_time("2027-03-28T02:30", "", at(now)); },
              ThrowsMessage<config::BadInput>(HasSubstr("is no time")));
}

TEST_F(EndOfTimeTest, MinutesBeginNow) {
  EXPECT_EQ(*end_of_time("", "1.5", at(now)), at(now + 90));
  EXPECT_FALSE(end_of_time("", "", at(now)));
}

TEST_F(EndOfTimeTest, SaysWhatIsWrong) {
  const auto refused = [&](const char* until, const char* minutes) -> std::string {
    try {
      end_of_time(until, minutes, at(now));
    } catch (const config::BadInput& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refused("2026-11-28T08:30", ""), "--until 2026-11-28T08:30: this time is past, it is 2026-11-28 08:30 now");
  EXPECT_EQ(refused("08:00", "5"), "--until and --minutes: one of them");
  for (const char* text :
       {"8:00", "24:00", "08:60", "eight", "2026-02-30T08:00", "2026-13-01T08:00", "08:00:00", "-8:00"})
    EXPECT_THAT(refused(text, ""), HasSubstr("is no time; expected one such as 08:00 or 2026-11-28T08:00")) << text;
  for (const char* text : {"0", "-1", "nan", "inf", "1e9", "5m"})
    EXPECT_THAT(refused("", text), HasSubstr("expected a number above 0")) << text;
}

}  // namespace
}  // namespace regista::campaign
