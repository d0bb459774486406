// SPDX-License-Identifier: MIT
// The rule against every game state there is, and against a clock counted by hand.
#include <gtest/gtest.h>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using set_play::Game;
using set_play::Memory;
using set_play::one;
using set_play::Rule;
using set_play::Whose;

constexpr int corner = REGISTA_SET_PLAY_CORNER_KICK, goal_kick = REGISTA_SET_PLAY_GOAL_KICK;

TEST(SetPlay, HoldsInExactlyTheStatesThatAreMeant) {
  const Rule rule{one(corner) | one(goal_kick), one(REGISTA_PHASE_PLAYING) | one(REGISTA_PHASE_SET), Whose::opponent};
  for (int kind = REGISTA_SET_PLAY_NONE; kind <= REGISTA_SET_PLAY_PENALTY_KICK; ++kind) {
    for (int phase = REGISTA_PHASE_INITIAL; phase <= REGISTA_PHASE_FINISHED; ++phase) {
      for (const bool own : {false, true}) {
        const bool expected = (kind == corner || kind == goal_kick) &&
                              (phase == REGISTA_PHASE_PLAYING || phase == REGISTA_PHASE_SET) && !own;
        EXPECT_EQ(Memory().update(rule, 5.0, {kind, phase, own, 1.0}), expected) << kind << ' ' << phase << ' ' << own;
      }
    }
  }
}

TEST(SetPlay, TheSideThatKicks) {
  for (const bool own : {false, true}) {
    const Game game{corner, REGISTA_PHASE_PLAYING, own, 0.0};
    EXPECT_TRUE(Memory().update({.whose = Whose::either}, 0.0, game));
    EXPECT_EQ(Memory().update({.whose = Whose::own}, 0.0, game), own);
    EXPECT_EQ(Memory().update({.whose = Whose::opponent}, 0.0, game), !own);
  }
}

// Tenths of a second for which it holds: a corner kick from 1.0 s that is over at 4.0 s.
int ticks_held(const Rule& rule) {
  Memory memory;
  int held = 0;
  for (int tick = 0; tick < 200; ++tick) {
    Game game;
    if (tick >= 10 && tick < 40) game = {corner, REGISTA_PHASE_PLAYING, true, 0.1 * (tick - 10)};
    held += memory.update(rule, 0.1 * tick, game) ? 1 : 0;
  }
  return held;
}

TEST(SetPlay, EndsEarlyOrLate) {
  EXPECT_EQ(ticks_held({}), 30);
  EXPECT_EQ(ticks_held({.at_most = 1.05}), 11);
  EXPECT_EQ(ticks_held({.at_most = 0.0}), 1);
  EXPECT_EQ(ticks_held({.still_for = 2.05}), 50);  // counted from the decision at 3.9 s, the last in the set play
  // What ended early does not come back when the set play is over.
  EXPECT_EQ(ticks_held({.at_most = 1.05, .still_for = 20.0}), 11);
}

TEST(SetPlay, AnotherSetPlayEndsWhatIsLeftOfTheFirst) {
  const Rule rule{.kinds = one(corner), .still_for = 10.0};
  Memory memory;
  ASSERT_TRUE(memory.update(rule, 0.0, {corner, REGISTA_PHASE_PLAYING, true, 0.0}));
  ASSERT_TRUE(memory.update(rule, 1.0, {}));
  EXPECT_FALSE(memory.update(rule, 2.0, {goal_kick, REGISTA_PHASE_PLAYING, true, 0.0}));
  EXPECT_FALSE(memory.update(rule, 3.0, {}));
}

TEST(SetPlay, ForgetStartsAfresh) {
  const Rule rule{.still_for = 10.0};
  Memory memory;
  ASSERT_TRUE(memory.update(rule, 0.0, {corner, REGISTA_PHASE_PLAYING, true, 0.0}));
  memory.forget();
  EXPECT_FALSE(memory.update(rule, 0.1, {}));
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

Scene scene(int kind, bool own, int phase = REGISTA_PHASE_PLAYING) {
  return FrameBuilder{}.robot(2).phase(phase, 3.0).set_play(kind, own).build().before_tasks();
}

TEST(SetPlayPlugin, AllCountWhenNoneIsChosen) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "set_play");
  Instance context(plugin, EnvironmentBuilder{});
  EXPECT_EQ(context.holds(scene(REGISTA_SET_PLAY_NONE, true)), 0);
  for (int kind = REGISTA_SET_PLAY_KICK_OFF; kind <= REGISTA_SET_PLAY_PENALTY_KICK; ++kind) {
    EXPECT_EQ(context.holds(scene(kind, true)), 1);
    EXPECT_EQ(context.holds(scene(kind, false, REGISTA_PHASE_READY)), 1);
    EXPECT_EQ(context.holds(scene(kind, false, REGISTA_PHASE_FINISHED)), 0);
  }
}

TEST(SetPlayPlugin, EachNameStandsForItsSetPlayAndPhase) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "set_play");
  const std::vector<const char*> names{"kick_off",    "kick_in",           "goal_kick",
                                       "corner_kick", "pushing_free_kick", "penalty_kick"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    Instance context(plugin, EnvironmentBuilder{}, Values(plugin).set(names[k], 1.0).set("whose", "own"));
    for (int kind = REGISTA_SET_PLAY_KICK_OFF; kind <= REGISTA_SET_PLAY_PENALTY_KICK; ++kind) {
      EXPECT_EQ(context.holds(scene(kind, true)), kind == static_cast<int>(k) + 1 ? 1 : 0) << names[k] << ' ' << kind;
      EXPECT_EQ(context.holds(scene(kind, false)), 0);
    }
  }
  const std::vector<const char*> phases{"ready", "set", "playing"};
  for (std::size_t k = 0; k < phases.size(); ++k) {
    Instance context(plugin, EnvironmentBuilder{}, Values(plugin).set(phases[k], 1.0));
    for (int phase = REGISTA_PHASE_INITIAL; phase <= REGISTA_PHASE_FINISHED; ++phase) {
      EXPECT_EQ(context.holds(scene(corner, true, phase)), phase == static_cast<int>(k) + 1 ? 1 : 0) << phases[k];
    }
  }
}

REGISTA_CONTEXT_CONTRACT(REGISTA_PLUGIN_FILE, "set_play");

}  // namespace
