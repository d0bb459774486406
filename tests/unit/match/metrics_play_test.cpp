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
  for (int i = 0; i < 10; ++i) measures.sample(state, bodies, std::nullopt);
  for (int i = 0; i < 30; ++i) measures.sample(state, bodies, Side::away);
  bodies[14].x = -0.5f;
  for (int i = 0; i < 10; ++i) measures.sample(state, bodies, Side::home);
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
  for (int i = 0; i < 10; ++i) measures.sample(state, bodies, Side::home);
  EXPECT_NEAR(home().distance_walked_metres, 2.5, 1e-6);
  EXPECT_NEAR(away().distance_walked_metres, 1.5, 1e-6);
  EXPECT_DOUBLE_EQ(home().possession_seconds, 1.0);
  EXPECT_DOUBLE_EQ(*home().opponent_half_share, 0.8);
  // Sides change ends.
  state.set_play = mind::SetPlay::none;
  state.half = 2;
  for (int i = 0; i < 50; ++i) measures.sample(state, bodies, std::nullopt);
  EXPECT_DOUBLE_EQ(*home().opponent_half_share, 0.9);
}

}  // namespace
}  // namespace regista::match
