// SPDX-License-Identifier: MIT
// Kick-off, free kicks and penalty kicks as small scenes: RoboCup SPL rule book 2023, sections 3.3 to 3.9 and 4.4.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "game.hpp"

namespace regista::match {
namespace {

using SetPlays = Game;

TEST_F(SetPlays, EndWithATouchOrInThirtySeconds) {
  play();
  ball = {1.2, 3.08};
  step(id(Side::home, 4));
  wait(29.9);
  EXPECT_EQ(state().set_play, SetPlay::kick_in);
  wait(0.2);
  EXPECT_TRUE(state().in_play());
  ball = {-1.0, -3.2};
  step(id(Side::home, 4));
  step(id(Side::away, 2));
  EXPECT_TRUE(state().in_play());
}

TEST_F(SetPlays, WhoMustKeepAwayCannotTakeThem) {
  play();
  ball = {1.2, 3.08};
  step(id(Side::home, 4));
  ASSERT_EQ(state().kicking, Side::away);
  ball = {0.4, 2.0};
  step(id(Side::home, 5));
  EXPECT_EQ(state().set_play, SetPlay::kick_in);
  EXPECT_EQ(ball, (Vector{1.2, 3.0})) << "it lies again where it lay";
  EXPECT_EQ(penalty(Side::home, 5), Offence::illegal_position);
}

TEST_F(SetPlays, AGoalFromKickOffCountsButNotDirectlyFromAGoalKick) {
  until(Phase::playing);
  kick(Side::home, 2);
  ball = {4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[0], 1);
  until(Phase::playing);
  kick(Side::away, 2);
  kick(Side::away, 3);
  ball = {-4.6, 2.0};
  step();  // goal kick for home
  ASSERT_EQ(state().set_play, SetPlay::goal_kick);
  kick(Side::home, 1);
  ball = {4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[0], 1);
  EXPECT_TRUE(happened(EventKind::goal_not_counted));
  EXPECT_EQ(state().set_play, SetPlay::goal_kick);
  EXPECT_EQ(state().kicking, Side::away);
  kick(Side::away, 1);
  kick(Side::home, 5);  // a second robot
  ball = {4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[0], 2);
}

TEST_F(SetPlays, ADeflectionIsNoSecondPlay) {
  play();
  ball = {0.0, 3.2};
  step(id(Side::away, 4));
  kick(Side::home, 2);
  step(id(Side::away, 3));  // hit by the ball
  ball = {4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[0], 0);
  EXPECT_EQ(state().set_play, SetPlay::goal_kick);
}

TEST_F(SetPlays, ADribbleOfAnotherIsASecondPlay) {
  play();
  ball = {0.0, 3.2};
  step(id(Side::away, 4));
  kick(Side::home, 2);
  for (int i = 0; i < 20; ++i) step(id(Side::home, 3));  // 0.4 s
  ball = {4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[0], 1);
}

TEST_F(SetPlays, DribblingOnIsNoSelfPass) {
  play();
  ball = {0.0, 3.2};
  step(id(Side::away, 4));
  for (int i = 0; i < 60; ++i) {  // 1.2 m in touch with the ball
    ball = {0.02 * i, 2.9};
    step(id(Side::home, 2));
  }
  kick(Side::home, 2);
  ball = {4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[0], 0);
}

TEST_F(SetPlays, AnOwnGoalNeedsNoSecondPlay) {
  play();
  ball = {-4.6, 2.0};
  step(id(Side::away, 4));
  ASSERT_EQ(state().set_play, SetPlay::goal_kick);
  ASSERT_EQ(state().kicking, Side::home);
  kick(Side::home, 1);
  ball = {-4.6, 0.0};
  step();
  EXPECT_EQ(state().goals, (std::array{0, 1}));
}

TEST_F(SetPlays, ASelfPassMustLeaveTheCircle) {
  play();
  ball = {0.0, 3.2};
  step(id(Side::away, 4));
  kick(Side::home, 2);
  ball = {0.5, 2.8};
  kick(Side::home, 2);
  ball = {4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[0], 0);
  kick(Side::away, 2);
  kick(Side::away, 3);
  ball = {0.0, 3.2};
  step();
  kick(Side::home, 2);
  ball = {0.8, 2.8};
  step();
  kick(Side::home, 2);
  ball = {4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[0], 1);
}

TEST_F(SetPlays, WhoEntersTheCircleBeforeTheKickOffIsRemoved) {
  until(Phase::playing);
  robot(Side::away, 3) = {0.5, 0.0};
  robot(Side::home, 3) = {-0.5, 0.2};
  const Calls& calls = step();
  EXPECT_EQ(calls.removed, std::vector{id(Side::away, 3)});
  EXPECT_TRUE(state().is_penalised(Side::away, 3));
  EXPECT_FALSE(state().is_penalised(Side::home, 3));
}

TEST_F(SetPlays, UntilTheKickOffIsTakenEverybodyStaysAtHome) {
  until(Phase::playing);
  robot(Side::away, 3) = {-0.3, 2.0};  // beyond the halfway line
  robot(Side::home, 3) = {0.3, 2.0};   // so, and not in the circle
  robot(Side::home, 2) = {0.3, 0.2};   // may take it
  step();
  EXPECT_EQ(penalty(Side::away, 3), Offence::illegal_position);
  EXPECT_EQ(penalty(Side::home, 3), Offence::illegal_position);
  EXPECT_EQ(penalty(Side::home, 2), Offence::none);
  kick(Side::home, 2);
  robot(Side::away, 4) = {-0.3, 2.0};
  step();
  EXPECT_EQ(penalty(Side::away, 4), Offence::none);
}

TEST_F(SetPlays, AHalfEndsInAPenaltyKickToo) {
  rules.durations.half = 60.0;
  restart();
  play();
  robot(Side::home, 5) = {-3.7, 1.0};
  robot(Side::away, 5) = {-3.4, 1.0};
  ball = {-3.7, 1.3};
  legs_of(Side::home, 5) = {0.2, 0.0};
  in_contact(Side::home, 5, Side::away, 5);
  wait(1.2);
  legs_of(Side::home, 5) = {};
  contacts.clear();
  ASSERT_EQ(state().set_play, SetPlay::penalty_kick);
  wait(60.0);
  EXPECT_EQ(state().half, 2);
  EXPECT_NE(state().set_play, SetPlay::penalty_kick);
}

TEST_F(SetPlays, WhoStoodNearHasTenSecondsToLeaveAndWhoComesNearNone) {
  play();
  ball = {1.0, 3.2};
  robot(Side::away, 5) = {1.0, 2.5};
  robot(Side::home, 5) = {1.4, 2.6};
  step(id(Side::away, 4));
  wait(4.0);
  robot(Side::away, 6) = {1.0, 2.26};  // 0.74 m
  robot(Side::away, 7) = {1.0, 2.24};  // 0.76 m
  step();
  EXPECT_TRUE(state().is_penalised(Side::away, 6));
  EXPECT_FALSE(state().is_penalised(Side::away, 7));
  wait(5.8);
  EXPECT_FALSE(state().is_penalised(Side::away, 5));
  wait(0.4);
  EXPECT_TRUE(state().is_penalised(Side::away, 5));
  EXPECT_FALSE(state().is_penalised(Side::home, 5)) << "the kicking side may be there";
}

TEST_F(SetPlays, NobodyIsLeftStandingOnTheBall) {
  play();
  ball = {1.0, 3.2};
  robot(Side::home, 5) = {1.05, 3.0};
  robot(Side::away, 6) = {0.95, 3.1};
  step(id(Side::away, 4));
  EXPECT_GE(length(robot(Side::home, 5) - ball), 0.2);
  EXPECT_GE(length(robot(Side::away, 6) - ball), 0.75);
  EXPECT_GE(length(robot(Side::home, 5) - robot(Side::away, 6)), 0.3);
}

// Home 5 walks into away 5 for longer than a second.
struct Pushing : Game {
  void push(Vector at, double ball_away) {
    play();
    robot(Side::home, 5) = at;
    robot(Side::away, 5) = at + Vector{0.3, 0.0};
    ball = at + Vector{0.0, ball_away};
    legs_of(Side::home, 5) = {0.2, 0.0};
    in_contact(Side::home, 5, Side::away, 5);
    wait(0.9);
    ASSERT_EQ(penalty(Side::home, 5), Offence::none);
    wait(0.2);
    legs_of(Side::home, 5) = {};
    contacts.clear();
  }
};

TEST_F(Pushing, NearTheBallGivesAFreeKickWhereItLies) {
  push({1.0, 1.0}, 0.4);
  EXPECT_EQ(penalty(Side::home, 5), Offence::pushing);
  EXPECT_EQ(state().set_play, SetPlay::pushing_free_kick);
  EXPECT_EQ(state().kicking, Side::away);
  EXPECT_EQ(state().phase, Phase::playing);
  EXPECT_EQ(state().spot, (Vector{1.0, 1.4}));
  EXPECT_EQ(ball, (Vector{1.0, 1.4}));
  kick(Side::away, 4);
  ball = {-4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[1], 0) << "indirect";
}

TEST_F(Pushing, FarFromTheBallCostsTheRobotOnly) {
  push({1.0, 1.0}, 0.6);
  EXPECT_EQ(penalty(Side::home, 5), Offence::pushing);
  EXPECT_TRUE(state().in_play());
}

TEST_F(Pushing, InTheOwnPenaltyAreaGivesAPenaltyKick) {
  push({-3.7, 1.0}, 0.4);
  EXPECT_EQ(penalty(Side::home, 5), Offence::pushing);
  EXPECT_EQ(state().phase, Phase::ready);
  EXPECT_EQ(state().set_play, SetPlay::penalty_kick);
  EXPECT_EQ(state().kicking, Side::away);
  EXPECT_EQ(ball, (Vector{-3.2, 0.0}));
}

TEST_F(Pushing, InTheOtherPenaltyAreaGivesAFreeKick) {
  push({3.7, 1.0}, 0.4);
  EXPECT_EQ(state().set_play, SetPlay::pushing_free_kick);
}

struct PenaltyKick : Pushing {
  PenaltyKick() {
    push({-3.7, 1.0}, 0.4);
    awarded = time;
    for (int number = 2; number <= 7; ++number) {
      robot(Side::home, number) = {-1.0, number - 4.0};
      robot(Side::away, number) = {0.5, number - 4.0};
    }
    robot(Side::home, 1) = {-4.5, 0.2};
    robot(Side::away, 1) = {4.0, 0.0};
    robot(Side::away, 2) = {-2.9, 0.0};
  }
  double awarded = 0.0;
};

TEST_F(PenaltyKick, RunsThroughReadyAndSetAndIsWhistled) {
  until(Phase::set);
  EXPECT_NEAR(time - awarded, 30.0, 0.11);
  const double set = time;
  bool whistle = false, late = false;
  while (state().phase == Phase::set) {
    const Calls& calls = step();
    whistle = calls.whistle;
    late = calls.told_late;
  }
  EXPECT_NEAR(time - set, 5.0, 0.021);
  EXPECT_TRUE(whistle);
  EXPECT_TRUE(late);
  EXPECT_EQ(state().set_play, SetPlay::penalty_kick);
  EXPECT_TRUE(happened(EventKind::whistle));
  EXPECT_EQ(penalty(Side::away, 2), Offence::none);
  wait(29.9);
  EXPECT_EQ(state().set_play, SetPlay::penalty_kick);
  wait(0.2);
  EXPECT_TRUE(state().in_play());
}

TEST_F(PenaltyKick, OnlyTakerAndGoalkeeperMayBeInTheArea) {
  robot(Side::home, 3) = {-3.5, 1.5};
  robot(Side::away, 4) = {-3.0, -1.5};
  until(Phase::set);
  EXPECT_EQ(penalty(Side::home, 3), Offence::illegal_position_in_set);
  EXPECT_EQ(penalty(Side::away, 4), Offence::illegal_position_in_set) << "farther from the mark than the taker";
  EXPECT_EQ(penalty(Side::away, 2), Offence::none);
  until(Phase::playing);
  robot(Side::home, 4) = {-3.0, 1.0};
  step();
  EXPECT_EQ(penalty(Side::home, 4), Offence::illegal_position);
}

TEST_F(PenaltyKick, TheGoalkeeperIsPutBackOnItsLine) {
  robot(Side::home, 1) = {-3.8, 0.3};
  until(Phase::set);
  EXPECT_EQ(robot(Side::home, 1), (Vector{-4.5, 0.3}));
  EXPECT_TRUE(happened(EventKind::put_back));
  EXPECT_FALSE(state().is_penalised(Side::home, 1));
}

TEST_F(PenaltyKick, TheGoalkeeperStaysOnItsLineUntilTheTouch) {
  until(Phase::playing);
  robot(Side::home, 1) = {-4.35, 0.0};
  step();
  EXPECT_EQ(penalty(Side::home, 1), Offence::none) << "still in touch with the line";
  robot(Side::home, 1) = {-4.2, 0.0};
  step();
  EXPECT_EQ(penalty(Side::home, 1), Offence::illegal_position);
}

TEST_F(PenaltyKick, ScoresWithOneTouch) {
  until(Phase::playing);
  kick(Side::away, 2);
  EXPECT_TRUE(state().in_play());
  step(id(Side::away, 2));  // still the same touch
  ball = {-4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[1], 1);
}

TEST_F(PenaltyKick, DoesNotScoreWithASecondTouchOfTheTaker) {
  until(Phase::playing);
  kick(Side::away, 2);
  wait(1.0);
  kick(Side::away, 2);
  ball = {-4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[1], 0);
  EXPECT_EQ(state().set_play, SetPlay::goal_kick);
}

TEST_F(PenaltyKick, TheTakerMayScoreAfterAnother) {
  until(Phase::playing);
  kick(Side::away, 2);
  step(id(Side::home, 1));
  wait(1.0);
  kick(Side::away, 2);
  ball = {-4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[1], 1);
}

}  // namespace
}  // namespace regista::match
