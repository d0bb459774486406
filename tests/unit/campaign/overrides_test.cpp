// SPDX-License-Identifier: MIT
#include "campaign/overrides.hpp"

#include <gtest/gtest.h>

namespace regista::campaign {
namespace {

using List = config::Overrides;

TEST(SortedOverrides, GoWhereTheirFirstPartSays) {
  const SortedOverrides sorted({"home.team=a", "away.team=b", "rules.team_size=5", "robot.walk.forward=1",
                                "disturbance.radio.delay=1", "away_disturbance.radio.loss=0.5",
                                "home_disturbance.radio.delay=2", "opening.length=20", "sender.params.reserve=3",
                                "roles.playing=[]"});
  EXPECT_EQ(sorted.of("home"), (List{"team=a", "sender.params.reserve=3", "roles.playing=[]"}));
  EXPECT_EQ(sorted.of("away"), (List{"team=b", "sender.params.reserve=3", "roles.playing=[]"}));
  EXPECT_EQ(sorted.of("rules"), List{"team_size=5"});
  EXPECT_EQ(sorted.of("robot"), List{"walk.forward=1"});
  EXPECT_EQ(sorted.of("home_disturbance"), (List{"radio.delay=1", "radio.delay=2"}));
  EXPECT_EQ(sorted.of("away_disturbance"), (List{"radio.delay=1", "radio.loss=0.5"}));
  EXPECT_EQ(sorted.of("opening"), List{"length=20"});
}

TEST(SortedOverrides, KeepTheirOrder) {
  const SortedOverrides sorted({"team=a", "home.team=b", "team=c"});
  EXPECT_EQ(sorted.of("home"), (List{"team=a", "team=b", "team=c"}));
  EXPECT_EQ(sorted.of("away"), (List{"team=a", "team=c"}));
}

TEST(SortedOverrides, ErrorsAreToldAsTyped) {
  const SortedOverrides sorted({"rules.team_size=50"});
  try {
    sorted.read("rules", [](const config::Overrides& overrides) {
      throw config::Error({"--set " + overrides.front(), 0, 0}, "team_size: 50 is outside 1 to 11");
    });
    FAIL() << "nothing was thrown";
  } catch (const config::Error& error) {
    EXPECT_STREQ(error.what(), "--set rules.team_size=50: team_size: 50 is outside 1 to 11");
  }
}

TEST(SortedOverrides, ErrorsOfFilesStayAsTheyAre) {
  const SortedOverrides sorted({"rules.team_size=50"});
  try {
    sorted.read("rules", [](const config::Overrides&) { throw config::Error({"a.yaml", 3, 4}, "wrong"); });
    FAIL() << "nothing was thrown";
  } catch (const config::Error& error) {
    EXPECT_STREQ(error.what(), "a.yaml:3:4: wrong");
    EXPECT_EQ(error.where().line, 3);
  }
}

}  // namespace
}  // namespace regista::campaign
