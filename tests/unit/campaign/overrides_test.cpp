// SPDX-License-Identifier: MIT
#include "campaign/match_setup.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace regista::campaign {
namespace {

std::vector<std::string> of(const config::Overrides& all, std::string_view document) {
  std::vector<std::string> out;
  for (const config::Override& each : overrides_for(document, all)) out.push_back(to_string(each));
  return out;
}
using List = std::vector<std::string>;

TEST(Overrides, GoWhereTheirFirstPartSays) {
  const config::Overrides all{"home.team=a",
                              "away.team=b",
                              "rules.team_size=5",
                              "robot.walk.forward=1",
                              "disturbance.radio.delay=1",
                              "away_disturbance.radio.loss=0.5",
                              "home_disturbance.radio.delay=2",
                              "opening.length=20",
                              "sender.params.reserve=3",
                              "roles.playing=[]"};
  EXPECT_EQ(of(all, "home"), (List{"team=a", "sender.params.reserve=3", "roles.playing=[]"}));
  EXPECT_EQ(of(all, "away"), (List{"team=b", "sender.params.reserve=3", "roles.playing=[]"}));
  EXPECT_EQ(of(all, "rules"), List{"team_size=5"});
  EXPECT_EQ(of(all, "robot"), List{"walk.forward=1"});
  EXPECT_EQ(of(all, "home_disturbance"), (List{"radio.delay=1", "radio.delay=2"}));
  EXPECT_EQ(of(all, "away_disturbance"), (List{"radio.delay=1", "radio.loss=0.5"}));
  EXPECT_EQ(of(all, "opening"), List{"length=20"});
}

TEST(Overrides, TeamsAreCalledByLettersInAMatchToo) {
  const config::Overrides all{"a.team=x", "b.team=y", "b_disturbance.radio.loss=1", "a_disturbance.radio.delay=2",
                              "k=v"};
  EXPECT_EQ(of(all, "home"), (List{"team=x", "k=v"}));
  EXPECT_EQ(of(all, "away"), (List{"team=y", "k=v"}));
  EXPECT_EQ(of(all, "home_disturbance"), List{"radio.delay=2"});
  EXPECT_EQ(of(all, "away_disturbance"), List{"radio.loss=1"});
  EXPECT_NO_THROW(refuse_unknown_sides(all));
  try {
    refuse_unknown_sides({"away.tasks.keep=all"});
    FAIL() << "version 0.2 called it so";
  } catch (const config::Error& error) {
    EXPECT_STREQ(
        error.what(),
        "--set away.tasks.keep=all: the first team, at home, is called a and the second b, as in all commands: "
        "b.tasks.keep");
  }
  EXPECT_THROW(refuse_unknown_sides({"c.tasks.keep=all"}), config::Error);
  EXPECT_NO_THROW(refuse_unknown_sides({"c=1"}));  // a key of both teams, unknown or not
}

TEST(Overrides, KeepTheirOrder) {
  const config::Overrides all{"team=a", "home.team=b", "team=c"};
  EXPECT_EQ(of(all, "home"), (List{"team=a", "team=b", "team=c"}));
  EXPECT_EQ(of(all, "away"), (List{"team=a", "team=c"}));
}

// So messages name them as they were typed.
TEST(Overrides, KeepTheirPlaces) {
  const config::Overrides all{"rules.team_size=50"};
  EXPECT_EQ(to_string(overrides_for("rules", all).front().where), "--set rules.team_size=50");
  EXPECT_EQ(to_string(overrides_for("rules", all).front().value.where()), "--set rules.team_size=50");
}

TEST(Overrides, WhatIsNoneIsRefused) {
  for (const char* const typed : {"rules", "=5", "rules.team_size="})
    EXPECT_THROW(overrides_for("rules", {typed}), config::Error) << typed;
}

}  // namespace
}  // namespace regista::campaign
