// SPDX-License-Identifier: MIT
// Offences and what they cost, as small scenes: RoboCup SPL rule book 2023, section 4.
#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include "game.hpp"

namespace regista::match {
namespace {

using Offences = Game;

TEST_F(Offences, PenaltiesGrowAndEndAtTheTouchLineFarFromTheBall) {
  play();
  for (int number = 1; number <= 7; ++number) robot(Side::away, number) = {3.0, 0.4 * (number - 4)};
  double expected = 45.0;
  for (int offence = 0; offence < 3; ++offence, expected += 10.0) {
    ball = {1.0, 3.2};
    step(id(Side::away, 4));  // kick-in for home
    wait(6.0);
    robot(Side::away, 5) = {1.0, 2.4};
    step();
    ASSERT_TRUE(state().is_penalised(Side::away, 5));
    const double begin = time;
    for (double side = 0.3; state().is_penalised(Side::away, 5); side = -side) {
      if (state().in_play()) ball.x = 1.0 + side;
      step();
    }
    EXPECT_NEAR(time - begin, expected, 0.021);
    EXPECT_NEAR(robot(Side::away, 5).x, 3.2, 1e-9) << "own half, level with the penalty mark";
    EXPECT_NEAR(robot(Side::away, 5).y, -3.0, 1e-9);
  }
}

TEST_F(Offences, ThePenaltyClockStandsInSet) {
  until(Phase::ready);
  wait(30.0);
  fallen = only(id(Side::home, 4));
  wait(15.1);  // to the first steps of Set: removed for 45 s
  fallen = 0;
  ASSERT_EQ(state().phase, Phase::set);
  ASSERT_EQ(penalty(Side::home, 4), Offence::fallen);
  const double served = 45.0 - (45.0 - 30.0 - 15.0);
  until(Phase::playing);
  const double begin = time;
  while (state().is_penalised(Side::home, 4)) step();
  EXPECT_NEAR(time - begin, served, 0.15);
}

TEST_F(Offences, LyingForLongAndDoingNothingCostTheRobotButDoNotCount) {
  play();
  fallen = only(id(Side::home, 4));
  asleep = only(id(Side::away, 5));
  wait(9.9);
  EXPECT_EQ(penalty(Side::away, 5), Offence::none);
  wait(0.2);
  EXPECT_EQ(penalty(Side::away, 5), Offence::inactive);
  wait(4.8);
  EXPECT_EQ(penalty(Side::home, 4), Offence::none);
  wait(0.2);
  EXPECT_EQ(penalty(Side::home, 4), Offence::fallen);
  fallen = asleep = 0;
  // The next offence of either side is its first that counts.
  robot(Side::home, 6) = {4.8, 2.0};
  at_walls = only(id(Side::home, 6));
  legs_of(Side::home, 6) = {0.2, 0.0};
  wait(5.1);
  ASSERT_EQ(penalty(Side::home, 6), Offence::leaving_the_field);
  at_walls = 0;
  const double begin = time;
  for (double side = 0.3; state().is_penalised(Side::home, 6); side = -side) {
    ball = {side, 0.0};
    step();
  }
  EXPECT_NEAR(time - begin, 45.0, 0.15);
}

TEST_F(Offences, WhoStandsAtAWallDoesNotLeave) {
  play();
  at_walls = only(id(Side::home, 6));
  wait(10.0);
  EXPECT_EQ(penalty(Side::home, 6), Offence::none);
}

TEST_F(Offences, MotionInSetFreezesOnTheSpotForFifteenSeconds) {
  until(Phase::set);
  const Vector where = robot(Side::away, 6);
  legs_of(Side::away, 6) = {0.1, 0.0};
  wait(0.9);
  EXPECT_EQ(penalty(Side::away, 6), Offence::none) << "it may come to rest";
  RobotSet frozen = 0;
  for (int i = 0; i < 10 && frozen == 0; ++i) frozen = step().frozen;
  EXPECT_EQ(frozen, only(id(Side::away, 6)));
  legs_of(Side::away, 6) = {};
  EXPECT_EQ(penalty(Side::away, 6), Offence::motion_in_set);
  EXPECT_EQ(robot(Side::away, 6), where);
  until(Phase::playing);
  const double begin = time;
  while (state().is_penalised(Side::away, 6)) step();
  EXPECT_NEAR(time - begin, 15.0, 0.05);
  EXPECT_EQ(robot(Side::away, 6), where);
}

TEST_F(Offences, TurningInSetIsMotionToo) {
  until(Phase::set);
  turning = only(id(Side::away, 6));
  wait(1.2);
  EXPECT_EQ(penalty(Side::away, 6), Offence::motion_in_set);
}

TEST_F(Offences, WhoMayMoveAgainHasTimeToLeaveAFreeKick) {
  until(Phase::set);
  turning = only(id(Side::away, 6));
  wait(1.2);
  turning = 0;
  ASSERT_EQ(penalty(Side::away, 6), Offence::motion_in_set);
  until(Phase::playing);
  kick(Side::home, 2);
  wait(1.0);
  robot(Side::away, 6) = {1.5, 2.6};
  ball = {1.5, 3.2};
  step(id(Side::away, 4));  // kick-in for home, next to who must not move
  ASSERT_EQ(state().set_play, SetPlay::kick_in);
  while (state().is_penalised(Side::away, 6)) step();
  step();
  EXPECT_FALSE(state().is_penalised(Side::away, 6));
  wait(9.0);
  EXPECT_FALSE(state().is_penalised(Side::away, 6));
  wait(1.2);
  EXPECT_TRUE(state().is_penalised(Side::away, 6));
}

TEST_F(Offences, WithoutPatienceForTheFallenWhoStandsIsSafe) {
  rules.offences.fallen = 0.0;
  restart();
  play();
  EXPECT_EQ(state().penalised, (std::array<std::uint32_t, 2>{}));
}

TEST_F(Offences, WhoComesBackStandsBesideWhoIsThere) {
  play();
  ball = {1.0, 1.0};
  for (int number = 1; number <= 7; ++number) robot(Side::home, number) = {-1.0, 0.5 * (number - 4)};
  fallen = only(id(Side::home, 4)) | only(id(Side::home, 5));
  for (int i = 0; i < 760; ++i) {
    ball.x = i % 200 < 100 ? 1.3 : 0.7;
    step();
  }
  fallen = 0;
  ASSERT_TRUE(state().is_penalised(Side::home, 4) && state().is_penalised(Side::home, 5));
  for (int i = 0; i < 2300; ++i) {
    ball.x = i % 200 < 100 ? 1.3 : 0.7;
    step();
  }
  EXPECT_FALSE(state().is_penalised(Side::home, 4) || state().is_penalised(Side::home, 5));
  EXPECT_EQ(robot(Side::home, 4), (Vector{-3.2, -3.0}));
  EXPECT_EQ(robot(Side::home, 5).y, -3.0) << "on the line too";
  EXPECT_LT(robot(Side::home, 5).x, -3.2) << "away from the ball";
}

TEST_F(Offences, AFourthInTheOwnGoalAreaIsOneTooMany) {
  play();
  for (const int number : {1, 2, 3}) robot(Side::home, number) = {-4.2, 0.5 * (number - 2)};
  robot(Side::away, 5) = {-4.1, 0.8};  // not theirs
  step();
  EXPECT_EQ(state().penalised[0], 0u);
  robot(Side::home, 7) = {-4.0, -0.9};
  step();
  EXPECT_EQ(penalty(Side::home, 7), Offence::illegal_position);
  EXPECT_EQ(std::popcount(state().penalised[0]), 1);
  EXPECT_EQ(state().penalised[1], 0u);
}

TEST_F(Offences, WhoIsPushedIntoTheGoalAreaHasFiveSeconds) {
  play();
  for (const int number : {1, 2, 3}) robot(Side::home, number) = {-4.2, 0.5 * (number - 2)};
  step();
  robot(Side::home, 7) = {-3.85, -0.9};
  robot(Side::away, 5) = {-3.55, -0.9};
  legs_of(Side::away, 5) = {-0.2, 0.0};
  in_contact(Side::away, 5, Side::home, 7);
  ball = {2.0, 2.0};
  step();
  robot(Side::home, 7) = {-3.95, -0.9};
  step();
  legs_of(Side::away, 5) = {};
  contacts.clear();
  wait(4.8);
  EXPECT_EQ(penalty(Side::home, 7), Offence::none);
  wait(0.4);
  EXPECT_EQ(penalty(Side::home, 7), Offence::illegal_position);
}

TEST_F(Offences, HoldingTheBallIsTimedAndReleasingCountsBack) {
  play();
  robot(Side::home, 4) = {1.0, 0.0};
  touching = only(id(Side::home, 4));
  wait(2.8);
  EXPECT_EQ(penalty(Side::home, 4), Offence::none);
  touching = 0;
  wait(1.2);
  touching = only(id(Side::home, 4));
  wait(0.8);
  EXPECT_EQ(penalty(Side::home, 4), Offence::none);
  wait(0.6);
  EXPECT_EQ(penalty(Side::home, 4), Offence::ball_holding);
}

TEST_F(Offences, DribblingIsNotHolding) {
  play();
  touching = only(id(Side::home, 4));
  for (int i = 0; i < 400; ++i) {
    ball.x += 0.002;
    step();
  }
  EXPECT_EQ(penalty(Side::home, 4), Offence::none);
}

TEST_F(Offences, TheGoalkeeperMayHoldItLongerInItsArea) {
  play();
  robot(Side::home, 1) = {-4.0, 0.0};
  touching = only(id(Side::home, 1));
  wait(9.8);
  EXPECT_EQ(penalty(Side::home, 1), Offence::none);
  wait(0.4);
  EXPECT_EQ(penalty(Side::home, 1), Offence::ball_holding);
}

struct Contact : Game {
  // Home 5 to the left of away 5, in touch for two seconds.
  void meet(Vector home_legs, Vector away_legs) {
    play();
    robot(Side::home, 5) = {1.0, 1.0};
    robot(Side::away, 5) = {1.3, 1.0};
    ball = {-2.0, -2.0};
    legs_of(Side::home, 5) = home_legs;
    legs_of(Side::away, 5) = away_legs;
    in_contact(Side::home, 5, Side::away, 5);
    wait(2.0);
  }
  bool called(Side side) const { return penalty(side, 5) == Offence::pushing; }
};

TEST_F(Contact, WhoWalksIntoAStandingOpponentPushes) {
  meet({0.2, 0.0}, {});
  EXPECT_TRUE(called(Side::home));
  EXPECT_FALSE(called(Side::away));
}

TEST_F(Contact, BothPressingIsNoOffence) {
  meet({0.2, 0.0}, {-0.15, 0.0});
  EXPECT_FALSE(called(Side::home) || called(Side::away));
}

TEST_F(Contact, PassingByIsASideContact) {
  meet({0.11, 0.22}, {});
  EXPECT_FALSE(called(Side::home));
}

TEST_F(Contact, WhoKicksDoesNotPush) {
  kicking = only(id(Side::home, 5));
  meet({0.2, 0.0}, {});
  EXPECT_FALSE(called(Side::home));
}

TEST_F(Contact, TeammatesMayTouch) {
  play();
  robot(Side::home, 5) = {1.0, 1.0};
  robot(Side::home, 6) = {1.3, 1.0};
  legs_of(Side::home, 5) = {0.2, 0.0};
  in_contact(Side::home, 5, Side::home, 6);
  wait(2.0);
  EXPECT_EQ(penalty(Side::home, 5), Offence::none);
}

TEST_F(Contact, AFallEndsTheWaiting) {
  play();
  robot(Side::home, 5) = {1.0, 1.0};
  robot(Side::away, 5) = {1.3, 1.0};
  legs_of(Side::home, 5) = {0.2, 0.0};
  in_contact(Side::home, 5, Side::away, 5);
  wait(0.2);
  fallen = only(id(Side::away, 5));
  step();
  EXPECT_TRUE(called(Side::home));
}

TEST_F(Contact, TheGoalkeeperMayInItsArea) {
  play();
  robot(Side::home, 1) = {-4.0, 0.0};
  robot(Side::away, 5) = {-3.7, 0.0};
  legs_of(Side::home, 1) = {0.2, 0.0};
  in_contact(Side::home, 1, Side::away, 5);
  wait(2.0);
  EXPECT_EQ(penalty(Side::home, 1), Offence::none);
}

TEST_F(Offences, WhoStandsAtAStuckBallIsRemoved) {
  play();
  ball = {1.0, 1.0};
  robot(Side::away, 5) = {1.4, 1.0};
  step();
  wait(29.9);
  EXPECT_EQ(penalty(Side::away, 5), Offence::none);
  wait(0.3);
  EXPECT_EQ(penalty(Side::away, 5), Offence::local_game_stuck);
  EXPECT_TRUE(state().in_play());
}

TEST_F(Offences, WithNobodyNearTheNearerSideKicksOff) {
  play();
  ball = {2.0, 0.0};
  robot(Side::away, 5) = {2.7, 0.0};
  step();
  wait(30.1);
  EXPECT_EQ(state().phase, Phase::ready);
  EXPECT_EQ(state().set_play, SetPlay::kick_off);
  EXPECT_EQ(state().kicking, Side::away);
  EXPECT_TRUE(happened(EventKind::game_stuck));
}

TEST_F(Offences, ABallThatNobodyTouchedSinceTheKickOffIsNotStuck) {
  until(Phase::playing);
  wait(60.0);
  EXPECT_EQ(state().phase, Phase::playing);
  EXPECT_FALSE(happened(EventKind::game_stuck));
}

TEST_F(Offences, AnOwnGoalWithoutOpponentsIsAGoalKick) {
  play();
  asleep = 0;
  for (int number = 1; number <= 7; ++number) asleep |= only(id(Side::away, number));
  for (int i = 0; i < 520; ++i) {
    ball.x = i % 100 < 50 ? 0.3 : -0.3;
    step();
  }
  ASSERT_EQ(std::popcount(state().penalised[1]), 7);
  ball = {-4.6, 0.0};
  step(id(Side::home, 1));
  EXPECT_EQ(state().goals, (std::array{0, 0}));
  EXPECT_EQ(state().set_play, SetPlay::goal_kick);
  EXPECT_EQ(state().kicking, Side::home);
}

}  // namespace
}  // namespace regista::match
