// SPDX-License-Identifier: MIT
// The rule against a clock counted by hand.
#include <gtest/gtest.h>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using ball_lost::Memory;
using ball_lost::Rule;

TEST(BallLost, UnknownIsLostAtOnce) {
  Memory memory;
  EXPECT_TRUE(memory.update({}, 0.0, false, 0.0));
}

TEST(BallLost, HoldsOnlyBeyondTheAge) {
  Memory memory;
  EXPECT_FALSE(memory.update({}, 4.5, true, 4.5));
  EXPECT_TRUE(memory.update({}, 4.6, true, 4.6));
}

TEST(BallLost, OneSightingEndsTheSearchByDefault) {
  Memory memory;
  ASSERT_TRUE(memory.update({}, 10.0, true, 5.0));
  EXPECT_FALSE(memory.update({}, 10.1, true, 0.0));
}

// Ticks until the search ends when the ball is seen at every tick of 0.1 s from the first.
int ticks_of_sight(double seen_again) {
  const Rule rule{4.5, seen_again};
  Memory memory;
  memory.update(rule, 0.0, false, 0.0);
  int tick = 0;
  while (memory.update(rule, 10.0 + 0.1 * tick, true, 0.0)) ++tick;
  return tick;
}

TEST(BallLost, HysteresisWantsSightingsOverItsSpan) {
  EXPECT_EQ(ticks_of_sight(0.0), 0);
  EXPECT_EQ(ticks_of_sight(0.5), 5);
  EXPECT_EQ(ticks_of_sight(2.0), 20);
}

TEST(BallLost, OneFalseSightingDoesNotEndTheSearchWithHysteresis) {
  const Rule rule{4.5, 1.0};
  Memory memory;
  ASSERT_TRUE(memory.update(rule, 0.0, false, 0.0));
  for (int tick = 0; tick <= 60; ++tick) {  // one sighting at 10 s that only grows older
    EXPECT_TRUE(memory.update(rule, 10.0 + 0.1 * tick, true, 0.1 * tick)) << tick;
  }
  // The run was broken by its age, so a later sighting starts a new one.
  EXPECT_TRUE(memory.update(rule, 17.0, true, 0.0));
  EXPECT_TRUE(memory.update(rule, 17.9, true, 0.0));
  EXPECT_FALSE(memory.update(rule, 18.0, true, 0.0));
}

TEST(BallLost, ForgetStartsAfresh) {
  const Rule rule{4.5, 1.0};
  Memory memory;
  ASSERT_TRUE(memory.update(rule, 0.0, false, 0.0));
  memory.forget();
  EXPECT_FALSE(memory.update(rule, 0.1, true, 0.0));
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

TEST(BallLostPlugin, LooksAtTheBallOfTheChosenWorld) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "ball_lost");
  Instance context(plugin, EnvironmentBuilder{}, Values(plugin).set("after", 2.0).set("own_sightings", false));
  const auto stale_in_common = [](WorldBuilder& world) { world.ball_age(9.0); };
  const FrameBuilder frame =
      FrameBuilder{}.own(2).time(20.0).robot(2).at(0, 0).ball(1, 1).ball_age(1.0).common(stale_in_common);
  EXPECT_EQ(context.holds(FrameBuilder(frame).knowledge(REGISTA_MINE).build().before_tasks()), 0);
  EXPECT_EQ(context.holds(FrameBuilder(frame).knowledge(REGISTA_COMMON).build().before_tasks()), 1);
  EXPECT_EQ(context.holds(FrameBuilder(frame).no_ball().build().before_tasks()), 1);
}

// Judged on what all know, by a robot that has seen the ball and not told of it, or the other way round.
TEST(BallLostPlugin, WhoSeesTheBallDoesNotSearch) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "ball_lost");
  const auto searches = [&](bool own_sightings, const FrameBuilder& frame) {
    Instance context(plugin, EnvironmentBuilder{}, Values(plugin).set("own_sightings", own_sightings));
    return context.holds(FrameBuilder(frame).knowledge(REGISTA_COMMON).build().before_tasks()) == 1;
  };
  const auto team_age = [](double age) { return [age](WorldBuilder& world) { world.ball_age(age); }; };
  const FrameBuilder robot = FrameBuilder{}.own(2).time(20.0).robot(2).at(0, 0).ball(1, 1);
  const FrameBuilder in_sight = FrameBuilder(robot).ball_age(0.1);
  EXPECT_TRUE(searches(false, FrameBuilder(in_sight).common(team_age(9.0))));
  EXPECT_FALSE(searches(true, FrameBuilder(in_sight).common(team_age(9.0))));
  EXPECT_FALSE(searches(true, FrameBuilder(in_sight).common([](WorldBuilder& world) { world.no_ball(); })));
  const FrameBuilder seen_long_ago = FrameBuilder(robot).ball_age(4.6);
  EXPECT_TRUE(searches(true, FrameBuilder(seen_long_ago).common(team_age(9.0))));
  EXPECT_FALSE(searches(true, FrameBuilder(seen_long_ago).common(team_age(4.4)))) << "the team has seen it since";
  EXPECT_TRUE(searches(true, FrameBuilder(robot).no_ball()));
}

REGISTA_CONTEXT_CONTRACT(REGISTA_PLUGIN_FILE, "ball_lost");

}  // namespace
