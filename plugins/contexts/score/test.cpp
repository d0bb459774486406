// SPDX-License-Identifier: MIT
// The rule by hand.
#include <gtest/gtest.h>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using score_context::holds;

TEST(Score, TheRangeIsClosed) {
  for (int difference = -4; difference <= 4; ++difference) {
    EXPECT_EQ(holds({-2, 1}, {5 + difference, 5, 1, 300.0}), difference >= -2 && difference <= 1) << difference;
    EXPECT_EQ(holds({2, 2}, {5 + difference, 5, 1, 300.0}), difference == 2) << difference;
    EXPECT_FALSE(holds({1, -1}, {5 + difference, 5, 1, 300.0})) << difference;
  }
}

// The teams change sides: ahead by n for one is behind by n for the other.
TEST(Score, IsMirroredByTheOpponent) {
  for (int own = 0; own <= 10; ++own) {
    for (int opponent = 0; opponent <= 10; ++opponent) {
      EXPECT_EQ(holds({1, 3}, {own, opponent, 1, 0.0}), holds({-3, -1}, {opponent, own, 1, 0.0}));
    }
  }
}

TEST(Score, LastMinutesAreThoseOfTheSecondHalf) {
  EXPECT_TRUE(holds({0, 0, 0.0}, {0, 0, 1, 600.0}));
  EXPECT_FALSE(holds({0, 0, 120.0}, {0, 0, 1, 10.0}));
  EXPECT_FALSE(holds({0, 0, 120.0}, {0, 0, 2, 120.1}));
  EXPECT_TRUE(holds({0, 0, 120.0}, {0, 0, 2, 120.0}));
  EXPECT_TRUE(holds({0, 0, 120.0}, {0, 0, 2, 0.0}));
  EXPECT_TRUE(holds({0, 0, 120.0}, {0, 0, 2, -5.0}));
  EXPECT_FALSE(holds({1, 9, 120.0}, {0, 0, 2, 10.0}));
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

TEST(ScorePlugin, LooksAtTheGame) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "score");
  Instance leading(plugin, EnvironmentBuilder{});
  EXPECT_EQ(leading.holds(FrameBuilder{}.robot(2).score(1, 0).build().before_tasks()), 1);
  EXPECT_EQ(leading.holds(FrameBuilder{}.robot(2).score(1, 1).build().before_tasks()), 0);
  Instance behind_late(plugin, EnvironmentBuilder{},
                       Values(plugin).set("least", -100).set("most", -1).set("in_last", 180));
  const auto at = [](int half, double left) {
    regista_game game{};
    game.phase = REGISTA_PHASE_PLAYING;
    game.half = half;
    game.opponent_score = 2;
    game.phase_time = 50.0;
    game.time_left = left;
    return FrameBuilder{}.robot(2).game(game).build().before_tasks();
  };
  EXPECT_EQ(behind_late.holds(at(1, 100.0)), 0);
  EXPECT_EQ(behind_late.holds(at(2, 200.0)), 0);
  EXPECT_EQ(behind_late.holds(at(2, 100.0)), 1);
}

REGISTA_CONTEXT_CONTRACT(REGISTA_PLUGIN_FILE, "score");

}  // namespace
