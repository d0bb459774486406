// SPDX-License-Identifier: MIT
// Who knows what of the game, and when.
#include "match/game_state.hpp"

#include <gtest/gtest.h>

namespace regista::match {
namespace {

using mind::Phase;
using mind::SetPlay;

struct Scene : testing::Test {
  config::Rules rules;
  GameControllerFeed feed{rules};
  GameState state;

  void announce(Phase phase, SetPlay set_play, double time, double delay, bool follows = false) {
    state.phase = phase;
    state.set_play = set_play;
    state.phase_began = time;
    feed.announce(state, time, delay, follows);
  }
  mind::GameTold at(double time, int id = 0) {
    mind::GameTold out;
    feed.tell(id, state, time, out);
    return out;
  }
  // Set at 45 s, the kick-off at 50 s.
  void kick_off() {
    announce(Phase::ready, SetPlay::kick_off, 0.0, 0.0);
    announce(Phase::set, SetPlay::kick_off, 45.0, 0.0);
    at(46.0);
    at(46.0, 1);
    announce(Phase::playing, SetPlay::kick_off, 50.0, 15.0);
  }
};

TEST_F(Scene, TheKickOffIsToldLateButHeardAtOnce) {
  kick_off();
  feed.whistle(1, 50.0);
  EXPECT_EQ(at(50.1).phase, Phase::set);
  EXPECT_EQ(at(50.1, 1).phase, Phase::playing);
  EXPECT_EQ(at(64.9).phase, Phase::set);
  EXPECT_EQ(at(65.0).phase, Phase::playing);
  EXPECT_DOUBLE_EQ(at(65.0).phase_time, 15.0);
}

TEST_F(Scene, AFreeBallIsNoNewsToWhoMissedTheKickOff) {
  kick_off();
  feed.whistle(1, 50.0);
  announce(Phase::playing, SetPlay::none, 53.0, 0.0, true);
  EXPECT_EQ(at(53.1).phase, Phase::set);
  EXPECT_EQ(at(53.1, 1).phase, Phase::playing);
  EXPECT_EQ(at(53.1, 1).set_play, SetPlay::none);
  EXPECT_EQ(at(65.1).set_play, SetPlay::none);
  EXPECT_EQ(at(65.1).phase, Phase::playing);
}

TEST_F(Scene, ASetPlayTellsEverybodyAtOnce) {
  kick_off();
  announce(Phase::playing, SetPlay::none, 53.0, 0.0, true);
  state.kicking = Side::away;
  announce(Phase::playing, SetPlay::corner_kick, 55.0, 0.0);
  EXPECT_EQ(at(55.0).set_play, SetPlay::corner_kick);
  EXPECT_FALSE(at(55.0).own_kick);
  EXPECT_TRUE(at(55.0, rules.team_size).own_kick);
  EXPECT_EQ(at(66.0).set_play, SetPlay::corner_kick) << "the older news that arrives now is no news";
}

TEST_F(Scene, AGoalIsToldLateAndTheWhistleTellsOnlyThatItFell) {
  kick_off();
  announce(Phase::playing, SetPlay::none, 53.0, 0.0, true);
  at(66.0);
  at(66.0, 1);
  state.goals = {1, 0};
  state.kicking = Side::away;
  announce(Phase::ready, SetPlay::kick_off, 70.0, 15.0);
  feed.whistle(1, 70.0);
  EXPECT_EQ(at(70.1).phase, Phase::playing);
  EXPECT_EQ(at(70.1, 1).phase, Phase::ready);
  EXPECT_EQ(at(70.1, 1).own_score, 0);
  EXPECT_TRUE(at(70.1, 1).own_kick);
  EXPECT_EQ(at(85.0).phase, Phase::ready);
  EXPECT_EQ(at(85.0, 1).own_score, 1);
  EXPECT_FALSE(at(85.0, 1).own_kick);
  EXPECT_EQ(at(85.0, rules.team_size).opponent_score, 1);
}

TEST_F(Scene, AGoalsWhistleInSetIsTakenForTheKickOff) {
  kick_off();
  announce(Phase::ready, SetPlay::kick_off, 55.0, 15.0);
  feed.whistle(0, 55.0);
  EXPECT_EQ(at(55.1).phase, Phase::playing);
  EXPECT_EQ(at(70.0).phase, Phase::ready);
}

// A clock that starts would tell of a kick-off that the robot has not heard of.
TEST_F(Scene, TheClockRunsFromWhatWasTold) {
  announce(Phase::set, SetPlay::kick_off, 45.0, 0.0);
  at(46.0);
  state.clock_runs = true;
  announce(Phase::playing, SetPlay::kick_off, 50.0, 15.0);
  EXPECT_DOUBLE_EQ(at(60.0).half_time_left, 600.0);
  EXPECT_DOUBLE_EQ(at(66.0).half_time_left, 584.0);
  EXPECT_DOUBLE_EQ(at(66.0).match_time_left, 1184.0);
}

TEST_F(Scene, PenaltiesAndBudgetAreNeverLate) {
  kick_off();
  state.packets_left = {7, 8};
  state.penalised = {1u, 2u};
  const mind::GameTold away = at(51.0, rules.team_size);
  EXPECT_EQ(away.packets_left, 8);
  EXPECT_EQ(away.own_penalised, 2u);
  EXPECT_EQ(away.opponent_penalised, 1u);
}

}  // namespace
}  // namespace regista::match
