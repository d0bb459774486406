// SPDX-License-Identifier: MIT
// Soccer on courses of the ball whose numbers follow from the rolling law: v^2 / (2 a).
#include "match/metrics_play.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "match/body.hpp"

namespace regista::match {
namespace {

// Home 1..7 are 0..6, away 1..7 are 7..13. All of the ball is behind the goal line at x = 4.575.
struct Play : testing::Test {
  config::Rules rules;
  PlayMeasures measures{rules};
  int half = 1;

  static BodyState ball(double x, double y, double vx = 0.0, double vy = 0.0) {
    BodyState out{};
    out.x = static_cast<float>(x);
    out.y = static_cast<float>(y);
    out.vx = static_cast<float>(vx);
    out.vy = static_cast<float>(vy);
    return out;
  }
  void touch(int id, double x, double y, double vx = 0.0, double vy = 0.0) {
    measures.step(ball(x, y, vx, vy), id, half);
  }
  void roll(double x, double y, double vx = 0.0, double vy = 0.0) { measures.step(ball(x, y, vx, vy), -1, half); }
  double speed(double distance) const { return speed_for_distance(distance, rules.ball.rolling_deceleration); }
  PlayMetrics home() const { return measures.result(Side::home); }
  PlayMetrics away() const { return measures.result(Side::away); }
};

TEST_F(Play, AShotRollsFarEnough) {
  touch(2, 2.0, 0.0, speed(2.574));
  EXPECT_EQ(home().shots, 0) << "it stops on the line";
  touch(2, 2.0, 0.0, speed(2.576));
  EXPECT_EQ(home().shots, 1);
  EXPECT_EQ(away().shots, 0);
}

TEST_F(Play, AShotGoesBetweenThePosts) {
  const double far = speed(5.0);
  const auto towards = [&](double y) {
    const double angle = std::atan2(y, 2.575);
    touch(2, 2.0, 0.0, far * std::cos(angle), far * std::sin(angle));
    measures.ball_placed();
  };
  towards(0.76);
  towards(-0.76);
  EXPECT_EQ(home().shots, 0);
  towards(0.74);
  towards(-0.74);
  EXPECT_EQ(home().shots, 2);
}

TEST_F(Play, SidesShootTheirOwnWayInEachHalf) {
  touch(8, 2.0, 0.0, speed(4.0));
  EXPECT_EQ(away().shots, 0) << "towards its own goal";
  measures.ball_placed();
  half = 2;
  touch(8, 2.0, 0.0, speed(4.0));
  EXPECT_EQ(away().shots, 1);
  measures.ball_placed();
  touch(3, -2.0, 0.0, -speed(4.0));
  EXPECT_EQ(home().shots, 1);
}

TEST_F(Play, TouchesThatLeaveAShotOnItsWayArePartOfIt) {
  touch(2, 2.0, 0.0, speed(4.0));
  touch(2, 2.1, 0.0, speed(4.0));
  touch(3, 2.2, 0.1, speed(4.0));
  touch(9, 2.3, 0.1, speed(3.0));
  EXPECT_EQ(home().shots, 1);
  EXPECT_EQ(home().shots_saved, 0) << "the defender's touch did not turn it away";
  measures.scored(Side::home);
  EXPECT_EQ(home().shots_scored, 1);
  measures.scored(Side::home);
  EXPECT_EQ(home().shots_scored, 1) << "that was no shot";
}

TEST_F(Play, ASaveTurnsTheBallAway) {
  touch(2, 2.0, 0.0, speed(4.0));
  roll(4.0, 0.0, speed(2.0));
  touch(7, 4.2, 0.0, -1.0);
  EXPECT_EQ(home().shots_saved, 1);
  EXPECT_EQ(away().interceptions, 0) << "it counts as a save";
  touch(9, 3.0, 0.0, -0.1);
  EXPECT_EQ(home().shots_saved, 1);
  touch(2, 2.8, 0.0, speed(4.0));
  touch(3, 3.0, 0.0, 0.0, 1.0);
  EXPECT_EQ(home().shots, 2);
  EXPECT_EQ(home().shots_saved, 1) << "its own side turned it away";
}

TEST_F(Play, WhatAPostTurnedAwayIsNotSaved) {
  touch(2, 2.0, 0.0, speed(4.0));
  roll(4.0, 0.8, -0.5);
  touch(7, 3.8, 0.8, -1.0);
  EXPECT_EQ(home().shots, 1);
  EXPECT_EQ(home().shots_saved, 0);
  EXPECT_EQ(away().interceptions, 1);
}

TEST_F(Play, ADeadBallEndsAShotAndAPass) {
  touch(2, 2.0, 0.0, speed(4.0));
  measures.ball_placed();
  roll(0.0, 0.0);
  touch(7, 1.0, 0.0, -1.0);
  EXPECT_EQ(home().shots_saved, 0);
  EXPECT_EQ(away().interceptions, 0);
}

TEST_F(Play, PassesGoToAnotherOfTheTeam) {
  touch(1, 0.0, 0.0, 1.0);
  touch(2, 0.49, 0.0);
  EXPECT_EQ(home().passes, 0) << "too near";
  touch(1, 0.0, 0.3);
  touch(1, 1.0, 0.3);
  EXPECT_EQ(home().passes, 1) << "nobody passes to oneself";
  touch(3, 1.0, -0.3);
  EXPECT_EQ(home().passes, 2);
  touch(10, 1.0, 0.1);
  EXPECT_EQ(away().interceptions, 0) << "a duel";
  touch(3, 1.0, 0.1);
  touch(11, 0.0, 0.1);
  EXPECT_EQ(away().interceptions, 1);
  touch(12, -1.0, 0.1);
  EXPECT_EQ(away().passes, 1);
  EXPECT_EQ(home().interceptions, 0);
}

TEST_F(Play, MeantPassesArriveOrAreIntercepted) {
  measures.kicked(1, 3);
  touch(1, 0.0, 0.0, 1.0);
  EXPECT_EQ(home().meant_passes, 1);
  touch(1, 0.1, 0.0, 1.0);
  EXPECT_EQ(home().meant_passes_arrived, 0) << "nobody else has it yet";
  touch(2, 1.0, 0.0);
  EXPECT_EQ(home().meant_passes_arrived, 1) << "another one than was meant";
  measures.kicked(2, 4);
  touch(9, 1.5, 0.0);
  EXPECT_EQ(home().meant_passes_intercepted, 1);
  touch(3, 2.0, 0.0);
  EXPECT_EQ(home().meant_passes_arrived, 1) << "that is over";
  measures.kicked(3, 4);
  measures.kicked(3, 0);
  touch(4, 2.5, 0.0);
  EXPECT_EQ(home().meant_passes, 3);
  EXPECT_EQ(home().meant_passes_arrived, 1) << "it kicked again, for nobody";
  measures.kicked(4, 5);
  measures.ball_placed();
  touch(5, 2.5, 0.0);
  EXPECT_EQ(home().meant_passes_arrived, 1) << "somebody put it down in between";
  measures.kicked(10, 2);
  touch(11, 0.0, 0.0);
  EXPECT_EQ(away().meant_passes_arrived, 1);
}

// The place counts where the ball was touched last, not first: who dribbles a metre has not passed.
TEST_F(Play, APassBeginsWhereTheBallWasLeft) {
  touch(1, 0.0, 0.0);
  touch(1, 1.0, 0.0);
  touch(2, 1.3, 0.0);
  EXPECT_EQ(home().passes, 0);
}

// Ends of what is told: kind, robot, outcome. Times are those of now().
struct Told : Play {
  std::vector<PlayEvent> events;
  std::vector<double> times;
  Told() {
    measures.tell([this](double time, const PlayEvent& event) {
      times.push_back(time);
      events.push_back(event);
    });
  }
  // Of home robot 2 and away robot 3 at these places, everybody else far away; the ball lies at (0, 0).
  void stand(double home_x, double away_x, int samples, RobotSet able = ~RobotSet{0}) {
    GameState state;
    state.phase = mind::Phase::playing;
    std::vector<BodyState> bodies(15, ball(4.0, 2.0));
    bodies[1].x = static_cast<float>(home_x);
    bodies[9].x = static_cast<float>(away_x);
    bodies[1].y = bodies[9].y = 0.0f;
    bodies[14] = ball(0.0, 0.0);
    for (int i = 0; i < samples; ++i) measures.sample(state, bodies, std::nullopt, able);
  }
};

TEST_F(Told, EachShotOnceWithWhatBecameOfIt) {
  measures.now(1.0);
  touch(2, 2.0, 0.0, speed(4.0));
  EXPECT_TRUE(events.empty()) << "it is under way";
  measures.now(3.0);
  touch(7, 4.2, 0.0, -1.0);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, PlayKind::shot);
  EXPECT_EQ(events[0].outcome, PlayOutcome::saved);
  EXPECT_EQ(events[0].side, Side::home);
  EXPECT_EQ(events[0].number, 3);
  EXPECT_EQ(events[0].began, 1.0);
  EXPECT_EQ(times[0], 3.0);
  EXPECT_NEAR(events[0].at.x, 2.0, 1e-6);
  touch(2, 2.0, 0.0, speed(4.0));
  measures.scored(Side::home);
  touch(2, 2.0, 0.0, speed(4.0));
  measures.ball_placed();
  touch(2, 2.0, 0.0, speed(4.0));
  measures.finish();
  ASSERT_EQ(events.size(), 4u);
  EXPECT_EQ(events[1].outcome, PlayOutcome::goal);
  EXPECT_EQ(events[2].outcome, PlayOutcome::missed);
  EXPECT_EQ(events[3].outcome, PlayOutcome::missed) << "the match ended";
  EXPECT_EQ(home().shots, 4);
}

TEST_F(Told, EachMeantPassOnceWithItsReceiver) {
  measures.kicked(1, 3);
  touch(1, 0.0, 0.0, 1.0);
  touch(2, 1.0, 0.0);
  measures.kicked(2, 4);
  touch(9, 1.5, 0.0);
  measures.kicked(9, 1);
  measures.kicked(9, 2);
  measures.finish();
  ASSERT_EQ(events.size(), 4u);
  EXPECT_EQ(events[0].outcome, PlayOutcome::arrived);
  EXPECT_EQ(events[0].number, 2);
  EXPECT_EQ(events[0].receiver, 3) << "whom it was meant for, not who got it";
  EXPECT_EQ(events[1].outcome, PlayOutcome::intercepted);
  EXPECT_EQ(events[2].outcome, PlayOutcome::lost) << "it kicked again";
  EXPECT_EQ(events[2].side, Side::away);
  EXPECT_EQ(events[3].outcome, PlayOutcome::lost);
  EXPECT_EQ(home().meant_passes + away().meant_passes, 4);
}

// A kick meets the ball before the step in which it counts as a touch.
TEST_F(Told, WhoKicksAPassOnHasReceivedIt) {
  measures.kicked(1, 3);
  measures.kicked(3, 4);
  measures.kicked(9, 0);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].outcome, PlayOutcome::arrived);
  EXPECT_EQ(events[1].outcome, PlayOutcome::intercepted);
  touch(9, 1.0, 0.0);
  EXPECT_EQ(home().meant_passes_arrived, 1);
  EXPECT_EQ(home().meant_passes_intercepted, 1);
}

// The own third of home ends at x = -1.5 in the first half.
TEST_F(Told, AClearanceLeavesTheOwnThird) {
  touch(1, -2.0, 0.0);
  measures.kicked(1, 0);
  touch(1, -2.0, 0.0, 1.0);
  roll(-1.6, 0.0, 1.0);
  EXPECT_EQ(home().clearances, 0);
  roll(-1.4, 0.0, 1.0);
  EXPECT_EQ(home().clearances, 1);
  roll(-1.0, 0.0, 1.0);
  EXPECT_EQ(home().clearances, 1) << "once";
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, PlayKind::clearance);
  EXPECT_EQ(events[0].outcome, PlayOutcome::none);
  EXPECT_NEAR(events[0].at.x, -2.0, 1e-6);
}

TEST_F(Told, OrGetsTwoMetresFartherFromTheOwnGoal) {
  touch(1, -4.0, 0.0);
  measures.kicked(1, 0);
  roll(-4.0, 2.4);
  EXPECT_EQ(home().clearances, 0) << "0.5 m from the goal's centre before, 2.45 m now";
  roll(-4.0, 2.6);
  EXPECT_EQ(home().clearances, 1);
}

TEST_F(Told, NoClearanceIsAPassAShotABlockedKickOrAGoalKick) {
  const auto kick = [&](int receiver) {
    touch(1, -2.0, 0.0);
    measures.kicked(1, receiver);
  };
  kick(3);
  roll(0.0, 0.0);
  EXPECT_EQ(home().clearances, 0) << "a meant pass";
  kick(0);
  touch(1, -2.0, 0.0, speed(8.0));
  roll(0.0, 0.0, speed(6.0));
  EXPECT_EQ(home().clearances, 0) << "a shot";
  kick(0);
  touch(8, -1.9, 0.0);
  roll(0.0, 0.0);
  EXPECT_EQ(home().clearances, 0) << "an opponent was in the way";
  measures.ball_placed();
  roll(-4.0, 1.1);
  measures.kicked(1, 0);
  roll(0.0, 0.0);
  EXPECT_EQ(home().clearances, 0) << "a goal kick";
  touch(1, -1.4, 0.0);
  measures.kicked(1, 0);
  roll(0.0, 0.0);
  EXPECT_EQ(home().clearances, 0) << "not in the own third";
  half = 2;
  touch(1, 2.0, 0.0);
  measures.kicked(1, 0);
  roll(1.0, 0.0);
  EXPECT_EQ(home().clearances, 1) << "after the change of sides";
}

TEST_F(Told, ADuelLastsASecondAndIsWonByTheNextTouch) {
  measures.now(5.0);
  stand(0.3, -0.2, 9);
  touch(1, 0.0, 0.0);
  stand(0.3, -0.6, 1);
  touch(1, 0.0, 0.0);
  EXPECT_EQ(measures.duels(), 0) << "0.9 s";
  stand(0.3, -0.2, 10);
  touch(1, 0.0, 0.0);
  EXPECT_EQ(measures.duels(), 0) << "both are still there";
  stand(0.3, -0.6, 1);
  EXPECT_EQ(measures.duels(), 0) << "nobody has had the ball since";
  measures.now(7.0);
  touch(1, 0.0, 0.0);
  EXPECT_EQ(measures.duels(), 1);
  EXPECT_EQ(home().duels_won, 1);
  EXPECT_EQ(away().duels_won, 0);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, PlayKind::duel);
  EXPECT_EQ(events[0].side, Side::away) << "whose robot was nearer";
  EXPECT_EQ(events[0].number, 3);
  EXPECT_EQ(events[0].opponent, 2);
  EXPECT_EQ(events[0].outcome, PlayOutcome::lost);
  EXPECT_DOUBLE_EQ(events[0].duration, 1.0);
  EXPECT_EQ(events[0].began, 5.0);
  EXPECT_EQ(times[0], 7.0);
}

TEST_F(Told, TheSameDuelGoesOnWhileNobodyHasTouchedTheBall) {
  stand(0.3, -0.2, 10);
  stand(0.3, -0.6, 3);
  stand(0.3, -0.2, 5);
  stand(0.6, -0.2, 1);
  touch(9, 0.0, 0.0);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_DOUBLE_EQ(events[0].duration, 1.5);
  EXPECT_EQ(events[0].outcome, PlayOutcome::won);
}

TEST_F(Told, ADeadBallLeavesADuelUndecidedAndAGoalDecidesIt) {
  stand(0.3, -0.2, 20);
  measures.ball_placed();
  stand(0.3, -0.2, 20);
  measures.scored(Side::home);
  measures.ball_placed();
  stand(0.3, -0.2, 20);
  measures.finish();
  ASSERT_EQ(events.size(), 3u);
  EXPECT_EQ(events[0].outcome, PlayOutcome::undecided);
  EXPECT_EQ(events[1].outcome, PlayOutcome::lost);
  EXPECT_EQ(events[2].outcome, PlayOutcome::undecided);
  EXPECT_EQ(measures.duels(), 3);
  EXPECT_EQ(home().duels_won, 1);
}

TEST_F(Told, NobodyDuelsWithWhoHasFallen) {
  stand(0.3, -0.2, 20, ~only(9));
  stand(0.6, -0.6, 1);
  touch(1, 0.0, 0.0);
  EXPECT_EQ(measures.duels(), 0);
}

TEST_F(Play, TheGoalIsEmptyWithoutAnAbleRobotInItsPenaltyArea) {
  GameState state;
  state.phase = mind::Phase::playing;
  std::vector<BodyState> bodies(15, BodyState{});  // all at the centre
  const auto sample = [&](int times, RobotSet able) {
    for (int i = 0; i < times; ++i) measures.sample(state, bodies, std::nullopt, able);
  };
  const RobotSet all = (RobotSet{1} << 14) - 1;
  // By section 1.1 of the rule book of 2023 the area reaches 1.65 m into the field and 2 m to either side.
  bodies[2].x = -4.5f + 1.6f;
  bodies[2].y = 1.95f;
  bodies[9].x = 4.5f - 1.7f;
  sample(10, all);
  EXPECT_DOUBLE_EQ(home().goal_empty_seconds, 0.0);
  EXPECT_DOUBLE_EQ(away().goal_empty_seconds, 1.0);
  sample(20, all & ~only(2));  // it has fallen
  EXPECT_DOUBLE_EQ(home().goal_empty_seconds, 2.0);
  state.penalised[0] = 0b100;
  sample(20, all);
  EXPECT_DOUBLE_EQ(home().goal_empty_seconds, 4.0);
  state.penalised[0] = 0;
  state.half = 2;  // its place is now in front of the other goal
  sample(10, all);
  EXPECT_DOUBLE_EQ(home().goal_empty_seconds, 5.0);
  EXPECT_DOUBLE_EQ(away().goal_empty_seconds, 6.0);
  state.set_play = mind::SetPlay::kick_in;
  sample(10, all);
  EXPECT_DOUBLE_EQ(home().goal_empty_seconds, 5.0) << "not in play";
}

TEST_F(Play, TerritoryPossessionAndDistance) {
  GameState state;
  state.phase = mind::Phase::playing;
  std::vector<BodyState> bodies(15, BodyState{});
  bodies[0].vx = 0.3f;
  bodies[0].vy = 0.4f;
  bodies[8].vx = -0.25f;
  bodies[14].x = 1.5f;
  EXPECT_EQ(home().possession_share, std::nullopt);
  EXPECT_EQ(home().ball_x_metres, std::nullopt);
  for (int i = 0; i < 10; ++i) measures.sample(state, bodies, std::nullopt, 0);
  for (int i = 0; i < 30; ++i) measures.sample(state, bodies, Side::away, 0);
  bodies[14].x = -0.5f;
  for (int i = 0; i < 10; ++i) measures.sample(state, bodies, Side::home, 0);
  EXPECT_DOUBLE_EQ(home().possession_seconds, 1.0);
  EXPECT_DOUBLE_EQ(away().possession_seconds, 3.0);
  EXPECT_DOUBLE_EQ(*away().possession_share, 0.75);
  EXPECT_NEAR(*home().ball_x_metres, (40 * 1.5 - 10 * 0.5) / 50.0, 1e-12);
  EXPECT_NEAR(*away().ball_x_metres, -*home().ball_x_metres, 1e-12);
  EXPECT_DOUBLE_EQ(*home().opponent_half_share, 0.8);
  EXPECT_DOUBLE_EQ(*away().opponent_half_share, 0.2);
  EXPECT_NEAR(home().distance_walked_metres, 5.0 * 0.5, 1e-6);
  EXPECT_NEAR(away().robot_distance_metres[1], 5.0 * 0.25, 1e-6);
  // Out of play, and a penalised robot: it walks nowhere, and the ball is nowhere.
  state.set_play = mind::SetPlay::kick_in;
  state.penalised[0] = 0b1;
  for (int i = 0; i < 10; ++i) measures.sample(state, bodies, Side::home, 0);
  EXPECT_NEAR(home().distance_walked_metres, 2.5, 1e-6);
  EXPECT_NEAR(away().distance_walked_metres, 1.5, 1e-6);
  EXPECT_DOUBLE_EQ(home().possession_seconds, 1.0);
  EXPECT_DOUBLE_EQ(*home().opponent_half_share, 0.8);
  // Sides change ends.
  state.set_play = mind::SetPlay::none;
  state.half = 2;
  for (int i = 0; i < 50; ++i) measures.sample(state, bodies, std::nullopt, 0);
  EXPECT_DOUBLE_EQ(*home().opponent_half_share, 0.9);
}

}  // namespace
}  // namespace regista::match
