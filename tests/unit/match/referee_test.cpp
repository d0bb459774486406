// SPDX-License-Identifier: MIT
// Each rule as a small scene. Home attacks towards +x in the first half.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "game.hpp"

namespace regista::match {
namespace {

TEST_F(Game, GoesThroughThePhasesInTheirTime) {
  EXPECT_EQ(state().phase, Phase::initial);
  until(Phase::ready);
  EXPECT_EQ(state().kicking, Side::home);
  const double ready = time;
  until(Phase::set);
  EXPECT_NEAR(time - ready, 45.0, 0.021);
  const double set = time;
  bool whistle = false;
  while (state().phase == Phase::set) whistle = step().whistle;
  EXPECT_TRUE(whistle);
  EXPECT_NEAR(time - set, 5.0, 0.021);
  EXPECT_EQ(state().set_play, SetPlay::kick_off);
  EXPECT_EQ(ball, Vector{});
}

TEST_F(Game, RobotsStartAtTheTouchLinesOfTheirHalf) {
  for (const Side side : both_sides) {
    for (int number = 1; number <= 7; ++number) {
      EXPECT_DOUBLE_EQ(std::fabs(robot(side, number).y), 3.0);
      EXPECT_LT(robot(side, number).x * attack(side, 1), 0.0);
      for (int other = 1; other < number; ++other) {
        EXPECT_GT(length(robot(side, number) - robot(side, other)), 0.35);
      }
    }
  }
}

TEST_F(Game, TheClockBeginsWithTheFirstKickOffAndThenRunsAlways) {
  until(Phase::playing);
  EXPECT_EQ(state().clock, 0.0);
  const double kick_off = time;
  wait(20.0);
  ball = {4.6, 0.0};
  step(id(Side::home, 2));
  EXPECT_EQ(state().phase, Phase::ready);
  wait(30.0);
  EXPECT_EQ(state().phase, Phase::ready);
  EXPECT_NEAR(state().clock, time - kick_off, 1e-9);
}

TEST_F(Game, ABallOverTheLineBetweenThePostsIsAGoalAndTheOthersKickOff) {
  play();
  ball = {4.5, 0.3};
  step();
  EXPECT_EQ(state().goals[0], 0) << "all of the ball must be over all of the line";
  ball = {4.58, 0.3};
  const Calls& calls = step();
  EXPECT_TRUE(calls.whistle);
  EXPECT_TRUE(calls.announced);
  EXPECT_TRUE(calls.told_late);
  EXPECT_EQ(state().goals, (std::array{1, 0}));
  EXPECT_EQ(state().phase, Phase::ready);
  EXPECT_EQ(state().kicking, Side::away);
  EXPECT_EQ(ball, Vector{});
}

TEST_F(Game, AnOwnGoalCountsForTheOthers) {
  play();
  ball = {-4.6, -0.2};
  step(id(Side::home, 1));
  EXPECT_EQ(state().goals, (std::array{0, 1}));
  EXPECT_EQ(state().kicking, Side::home);
}

TEST_F(Game, BallOverTheTouchLineGivesAKickInWhereItLeft) {
  play();
  ball = {1.2, 3.08};
  const Calls& calls = step(id(Side::home, 4));
  EXPECT_FALSE(calls.whistle);
  EXPECT_FALSE(calls.told_late);
  EXPECT_EQ(state().phase, Phase::playing);
  EXPECT_EQ(state().set_play, SetPlay::kick_in);
  EXPECT_EQ(state().kicking, Side::away);
  EXPECT_EQ(ball, (Vector{1.2, 3.0}));
}

TEST_F(Game, BallOverTheGoalLineGivesGoalKickOrCorner) {
  play();
  ball = {4.6, -2.0};
  step(id(Side::home, 4));
  EXPECT_EQ(state().set_play, SetPlay::goal_kick);
  EXPECT_EQ(state().kicking, Side::away);
  EXPECT_EQ(ball, (Vector{3.9, -1.1}));
  step(id(Side::away, 4));
  step(id(Side::away, 5));
  ball = {4.6, 1.5};
  step();
  EXPECT_EQ(state().set_play, SetPlay::corner_kick);
  EXPECT_EQ(state().kicking, Side::home);
  EXPECT_EQ(ball, (Vector{4.5, 3.0}));
}

TEST_F(Game, TheKickOffBallIsFreeAfterTenSecondsOrATouch) {
  until(Phase::playing);
  wait(9.9);
  EXPECT_EQ(state().set_play, SetPlay::kick_off);
  wait(0.2);
  EXPECT_TRUE(state().in_play());
}

TEST_F(Game, SidesChangeAtHalfTimeWithoutABreak) {
  play();
  while (state().half == 1) step(id(Side::home, 3));
  EXPECT_EQ(state().phase, Phase::initial);
  EXPECT_EQ(state().kicking, Side::away);
  for (int number = 1; number <= 7; ++number) EXPECT_GT(robot(Side::home, number).x, 0.0);
  play();
  ball = {-4.6, 0.0};
  step();
  EXPECT_EQ(state().goals, (std::array{1, 0})) << "home attacks towards -x now";
}

TEST_F(Game, EndsAfterItsHalves) {
  while (state().ended == Ended::no && time < 2000.0) {
    step(state().phase == Phase::playing ? id(Side::home, 3) : -1);
  }
  EXPECT_EQ(state().ended, Ended::full_time);
  EXPECT_NEAR(time, 2.0 * (1.0 + 45.0 + 5.0 + 600.0), 0.2);
  EXPECT_EQ(state().phase, Phase::finished);
}

TEST_F(Game, TheMercyRuleEndsIt) {
  int goals = 0;
  while (state().ended == Ended::no) {
    until(Phase::playing);
    step(id(Side::home, 2));
    ball = {attack(Side::home, state().half) * 4.6, 0.0};
    step();
    ASSERT_LE(++goals, 10);
    step();
  }
  EXPECT_EQ(state().ended, Ended::mercy);
  EXPECT_EQ(state().goals, (std::array{10, 0}));
}

TEST_F(Game, ChargesPacketsInReadySetAndPlayingOnly) {
  EXPECT_FALSE(referee.packet(Side::home, 50)) << "Initial has no radio";
  EXPECT_EQ(state().packets[0], 0);
  for (const Phase phase : {Phase::ready, Phase::set, Phase::playing}) {
    until(phase);
    EXPECT_TRUE(referee.packet(Side::home, 128));
  }
  EXPECT_EQ(state().packets, (std::array{3, 0}));
  EXPECT_EQ(state().packets_left, (std::array{1197, 1200}));
}

TEST_F(Game, OverTheBudgetTheScoreIsZeroForEver) {
  rules.messages.budget = 5;
  restart();
  play();
  ball = {4.6, 0.0};
  step();
  ASSERT_EQ(state().goals[0], 1);
  for (int i = 0; i < 5; ++i) referee.packet(Side::home, 10);
  step();
  EXPECT_EQ(state().goals[0], 1) << "the whole budget may be used";
  referee.packet(Side::home, 10);
  referee.packet(Side::home, 10);
  step();
  EXPECT_EQ(state().goals[0], 0);
  EXPECT_EQ(state().packets_left[0], 0);
  EXPECT_EQ(std::ranges::count(events, EventKind::too_many_packets, &Event::kind), 1);
  play();
  ball = {4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[0], 0);
  EXPECT_EQ(state().phase, Phase::ready);
  until(Phase::playing);
  step(id(Side::away, 2));
  ball = {-4.6, 0.0};
  step();
  EXPECT_EQ(state().goals, (std::array{0, 1}));
}

TEST_F(Game, AnOverlongPacketIsNotSentAndSanctioned) {
  play();
  ball = {4.6, 0.0};
  step();
  EXPECT_FALSE(referee.packet(Side::home, 129));
  step();
  EXPECT_EQ(state().goals[0], 0);
  EXPECT_TRUE(happened(EventKind::packet_too_long));
  EXPECT_FALSE(state().sanctioned[1]);
}

}  // namespace
}  // namespace regista::match
