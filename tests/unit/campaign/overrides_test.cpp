// SPDX-License-Identifier: MIT
#include "campaign/overrides.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace regista::campaign {
namespace {

std::vector<std::string> of(const SortedOverrides& sorted, std::string_view document) {
  std::vector<std::string> out;
  for (const config::Override& each : sorted.of(document)) out.push_back(to_string(each));
  return out;
}
using List = std::vector<std::string>;

TEST(SortedOverrides, GoWhereTheirFirstPartSays) {
  const SortedOverrides sorted({"home.team=a", "away.team=b", "rules.team_size=5", "robot.walk.forward=1",
                                "disturbance.radio.delay=1", "away_disturbance.radio.loss=0.5",
                                "home_disturbance.radio.delay=2", "opening.length=20", "sender.params.reserve=3",
                                "roles.playing=[]"});
  EXPECT_EQ(of(sorted, "home"), (List{"team=a", "sender.params.reserve=3", "roles.playing=[]"}));
  EXPECT_EQ(of(sorted, "away"), (List{"team=b", "sender.params.reserve=3", "roles.playing=[]"}));
  EXPECT_EQ(of(sorted, "rules"), List{"team_size=5"});
  EXPECT_EQ(of(sorted, "robot"), List{"walk.forward=1"});
  EXPECT_EQ(of(sorted, "home_disturbance"), (List{"radio.delay=1", "radio.delay=2"}));
  EXPECT_EQ(of(sorted, "away_disturbance"), (List{"radio.delay=1", "radio.loss=0.5"}));
  EXPECT_EQ(of(sorted, "opening"), List{"length=20"});
}

TEST(SortedOverrides, KeepTheirOrder) {
  const SortedOverrides sorted({"team=a", "home.team=b", "team=c"});
  EXPECT_EQ(of(sorted, "home"), (List{"team=a", "team=b", "team=c"}));
  EXPECT_EQ(of(sorted, "away"), (List{"team=a", "team=c"}));
}

// So messages name them as they were typed.
TEST(SortedOverrides, KeepTheirPlaces) {
  const SortedOverrides sorted({"rules.team_size=50"});
  EXPECT_EQ(to_string(sorted.of("rules").front().where), "--set rules.team_size=50");
  EXPECT_EQ(to_string(sorted.of("rules").front().value.where()), "--set rules.team_size=50");
}

TEST(SortedOverrides, WhatIsNoneIsRefused) {
  for (const char* const typed : {"rules", "=5", "rules.team_size="})
    EXPECT_THROW(SortedOverrides({typed}), config::Error) << typed;
}

}  // namespace
}  // namespace regista::campaign
