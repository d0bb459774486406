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
using set_play::Pattern;
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
  EXPECT_EQ(ticks_held({.hold_seconds = 2.05}), 50);  // counted from the decision at 3.9 s, the last in the set play
  // What ended early does not come back when the set play is over.
  EXPECT_EQ(ticks_held({.at_most = 1.05, .hold_seconds = 20.0}), 11);
}

TEST(SetPlay, AnotherSetPlayEndsWhatIsLeftOfTheFirst) {
  const Rule rule{.kinds = one(corner), .hold_seconds = 10.0};
  Memory memory;
  ASSERT_TRUE(memory.update(rule, 0.0, {corner, REGISTA_PHASE_PLAYING, true, 0.0}));
  ASSERT_TRUE(memory.update(rule, 1.0, {}));
  EXPECT_FALSE(memory.update(rule, 2.0, {goal_kick, REGISTA_PHASE_PLAYING, true, 0.0}));
  EXPECT_FALSE(memory.update(rule, 3.0, {}));
}

// All robots of a team have one pattern, from the first second of a set play to its last, whenever they decide.
TEST(SetPlay, ThePatternIsOneForAllAndStays) {
  for (int began = 0; began < 500; ++began) {
    const double start = 0.02 * began;  // of a physics step
    for (const double later : {0.02, 0.1, 0.37, 5.0, 29.9}) {
      const Game game{corner, REGISTA_PHASE_PLAYING, true, start + later - start};
      EXPECT_EQ(pattern_of(game, start + later), began / 50 % 2 == 0 ? Pattern::first : Pattern::second) << start;
    }
  }
}

TEST(SetPlay, OneOfTwoPatternsHolds) {
  int first = 0;
  for (int second = 0; second < 20; ++second) {
    const Game game{corner, REGISTA_PHASE_PLAYING, true, 2.0};
    const bool one_holds = Memory().update({.pattern = Pattern::first}, 2.5 + second, game);
    EXPECT_NE(one_holds, Memory().update({.pattern = Pattern::second}, 2.5 + second, game));
    EXPECT_TRUE(Memory().update({}, 2.5 + second, game));
    first += one_holds ? 1 : 0;
  }
  EXPECT_EQ(first, 10);
}

// Ready, Set and the play of one kick-off begin at different times, and with a whistle at different ones for each
// robot.
TEST(SetPlay, TheKickOffsPatternFollowsFromGoalsAndHalf) {
  for (int goals = 0; goals < 4; ++goals) {
    for (const int half : {1, 2}) {
      for (const double time : {0.0, 45.3, 50.9}) {
        const Game game{REGISTA_SET_PLAY_KICK_OFF, REGISTA_PHASE_READY, true, 0.3, half, goals};
        EXPECT_EQ(pattern_of(game, time), (goals + half) % 2 == 1 ? Pattern::first : Pattern::second);
      }
    }
  }
}

TEST(SetPlay, ForgetStartsAfresh) {
  const Rule rule{.hold_seconds = 10.0};
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
