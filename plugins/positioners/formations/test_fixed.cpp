// SPDX-License-Identifier: MIT
// Written places: what is read, what is refused, when sides change; and the contract of positioners.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "fixed_places.hpp"

namespace {

using formations::fixed_places;
using formations::Ground;
using formations::Role;

const std::vector<Role> roles{{"goalkeeper", "playing", 0}, {"striker", "playing", 1}, {"goalkeeper", "searching", 0}};
constexpr Ground ground{5.2, 3.7};

std::string refusal(std::string_view file, std::string_view text) {
  try {
    fixed_places(file, text, roles, ground);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "read";
}

TEST(FixedPlaces, TextGoesBeforeFileAndListBeforeName) {
  const auto places = fixed_places("# set play\ngoalkeeper: -4.2 0\nstriker: 0.5 -1\n",
                                   "searching/goalkeeper: -4 1, striker: 1e-1\t2", roles, ground);
  ASSERT_EQ(places.size(), 3u);
  EXPECT_EQ(places[0]->x, -4.2);
  EXPECT_EQ(places[2]->x, -4.0);
  EXPECT_EQ(places[2]->y, 1.0);
}

TEST(FixedPlaces, RolesNotNamedHaveNone) {
  const auto places = fixed_places("", "striker: 0 0", roles, ground);
  EXPECT_FALSE(places[0].has_value());
  EXPECT_TRUE(places[1].has_value());
  for (const auto& place : fixed_places("", " ,\n # nothing", roles, ground)) EXPECT_FALSE(place.has_value());
}

TEST(FixedPlaces, Refused) {
  EXPECT_EQ(refusal("goalkeeper: -4 0\nstriker 0 0", ""),
            "file: line 2: \"striker 0 0\" has no colon; an entry is \"role: value\"");
  EXPECT_EQ(refusal("", "striker: 0"), "places: line 1: striker: \"0\" is not 2 numbers");
  EXPECT_EQ(refusal("", "striker: 0 inf"), "places: line 1: striker: \"0 inf\" is not 2 numbers");
  EXPECT_EQ(refusal("", "striker: 6 0"), "places: line 1: striker: (6, 0) is off the ground, |x| <= 5.2, |y| <= 3.7");
  EXPECT_EQ(refusal("", "stricker: 0 0"), "places: line 1: no role \"stricker\"; the nearest is \"striker\"");
  EXPECT_EQ(refusal("\x7f"
                    "ELF\x02\x01",
                    ""),
            "file: line 1: \"?ELF??\" has no colon; an entry is \"role: value\"");
}

// --- The plugin ----------------------------------------------------------------------------------------------------

using namespace regista::testkit;

void base(Values& values) { values.set("places", "striker: 1 2, goalkeeper: -4 0.5"); }

FrameBuilder scene() {
  return FrameBuilder{}.own(2).robot(2).ball(4.0, -2.0).task("supporter").task("goalkeeper").task("striker");
}

TEST(FixedFormation, PointsAreBoundToTheirTasks) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "fixed_formation");
  Values values(plugin);
  base(values);
  Instance positioner(plugin, EnvironmentBuilder{}.own(2), values);
  const Placed placed = positioner.place(scene().build().before_placing());
  ASSERT_EQ(placed.points.size(), 2u);
  EXPECT_EQ(placed.points[0].task, 1);
  EXPECT_EQ(placed.points[0].x, -4.0);
  EXPECT_EQ(placed.points[0].y, 0.5);
  EXPECT_EQ(placed.points[1].task, 2);
  EXPECT_EQ(placed.points[1].y, 2.0);
}

TEST(FixedFormation, MirroredInSetPlaysOnTheRight) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "fixed_formation");
  Values values(plugin);
  base(values);
  values.set("mirror", 1.0);
  Instance positioner(plugin, EnvironmentBuilder{}.own(2), values);
  const auto striker_y = [&](FrameBuilder builder) {
    return positioner.place(builder.build().before_placing()).points.at(1).y;
  };
  EXPECT_EQ(striker_y(scene()), 2.0);
  EXPECT_EQ(striker_y(scene().set_play(REGISTA_SET_PLAY_CORNER_KICK, true)), -2.0);
  EXPECT_EQ(striker_y(scene().set_play(REGISTA_SET_PLAY_KICK_OFF, true)), 2.0);
  EXPECT_EQ(striker_y(scene().set_play(REGISTA_SET_PLAY_CORNER_KICK, true).ball(4.0, 2.0)), 2.0);
  EXPECT_EQ(striker_y(scene().set_play(REGISTA_SET_PLAY_CORNER_KICK, true).no_ball()), 2.0);
}

REGISTA_POSITIONER_CONTRACT(REGISTA_PLUGIN_FILE, "fixed_formation", {.base = base});

}  // namespace
