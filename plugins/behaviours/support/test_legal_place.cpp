// SPDX-License-Identifier: MIT
// Where robots may stand, against the rules of each set play worked out by hand: a robot's radius of 0.15 m and a
// margin of 0.2 m beyond what the SPL rule book 2023 asks for.
#include <gtest/gtest.h>

#include <regista/testkit/dice.hpp>

#include "../legal_place.hpp"
#include "../test_situations.hpp"

namespace {

using namespace behaviours;

class LegalPlace : public testing::Test {
 protected:
  Vector2d place(double x, double y) const {
    const Pose pose = legal_place(situation, {}, {x, y, 0.5});
    return {pose.x, pose.y};
  }
  // The wanted place, unless it is another one that this says.
  void expect(const Vector2d& wanted, const Vector2d& expected) const {
    const Vector2d got = place(wanted.x(), wanted.y());
    EXPECT_NEAR((got - expected).norm(), 0.0, 1e-12) << got.transpose() << " and not " << expected.transpose();
  }
  void expect(const Vector2d& wanted) const { expect(wanted, wanted); }

  Situation situation = [] {
    Situation out = standing(0, 0);
    out.facts.own_number = 3;
    return out;
  }();
};

TEST_F(LegalPlace, AnywhereOnTheFieldInPlay) {
  expect({4.5, -3});
  expect({6, 5}, {4.5, 3});
  expect({-6, -5}, {-4.5, -3});
  EXPECT_EQ(legal_place(situation, {}, {1, 1, 0.5}).heading, 0.5);
}

// It ends 0.6 m before the goal line and is 2.2 m wide.
TEST_F(LegalPlace, OutOfTheOwnGoalAreaWithoutBusinessThere) {
  expect({-4.4, 1}, {-3.7, 1});
  expect({-3.6, 1});
  expect({-4.4, 1.31});
  expect({4.4, 1});
  for (const Duty duty : {Duty::plays_ball, Duty::keeps_goal}) {
    situation.duty = duty;
    expect({-4.4, 1});
  }
}

TEST_F(LegalPlace, OwnKickOff) {
  for (const Phase phase : {Phase::ready, Phase::set, Phase::playing}) {
    situation = in_set_play(situation, SetPlay::kick_off, true, phase);
    situation.duty = Duty::other;
    expect({1, 2}, {-0.35, 2});
    expect({-0.1, 0.1}, {-0.35, 0.1});
    expect({-1, 0});
    situation.duty = Duty::plays_ball;
    expect({0.2, 0}, phase == Phase::playing ? Vector2d(0.2, 0) : Vector2d(-0.35, 0));
  }
}

TEST_F(LegalPlace, OpponentsKickOff) {
  for (const Phase phase : {Phase::ready, Phase::set, Phase::playing}) {
    for (const Duty duty : {Duty::other, Duty::plays_ball}) {
      situation = in_set_play(situation, SetPlay::kick_off, false, phase);
      situation.duty = duty;
      expect({3, 0}, {-1.1, 0});
      expect({-0.8, 0.6}, {-0.88, 0.66});  // on its way out of the circle, at 1.1 m
      expect({-0.4, 2});
      expect({1, 2}, {-0.35, 2});
    }
  }
}

TEST_F(LegalPlace, ReadyIsAKickOffEvenWhenNobodyHasSaidSo) {
  situation = in_set_play(situation, SetPlay::none, true, Phase::ready);
  expect({1, 2}, {-0.35, 2});
}

// The mark is 1.3 m before the goal line; the area ends 1.65 m before it.
TEST_F(LegalPlace, OwnPenaltyKick) {
  situation = in_set_play(situation, SetPlay::penalty_kick, true, Phase::ready);
  expect({4, 1}, {2.5, 1});
  expect({-4, 2});
  situation.duty = Duty::plays_ball;
  expect({0, 0}, {2.75, 0});
  EXPECT_EQ(legal_place(situation, {}, {0, 0, 0.5}).heading, 0.0);
  situation.phase = Phase::playing;
  expect({3.1, 0.2});
}

TEST_F(LegalPlace, OpponentsPenaltyKick) {
  situation = in_set_play(situation, SetPlay::penalty_kick, false, Phase::playing);
  expect({-4, 2}, {-2.5, 2});
  expect({4, 1});
  situation.duty = Duty::plays_ball;
  expect({-4, 0}, {-2.5, 0});
  situation.duty = Duty::keeps_goal;
  situation.facts.own_number = 1;
  expect({-3, 0.4}, {-4.5, 0.4});
  expect({-3, 2}, {-4.5, 0.6});
  expect({-3, -2}, {-4.5, -0.6});
}

// 0.75 m, the robot and the margin: 1.1 m.
TEST_F(LegalPlace, AwayFromTheBallOfTheOpponentsSetPlays) {
  for (const SetPlay play : {SetPlay::kick_in, SetPlay::goal_kick, SetPlay::corner_kick, SetPlay::pushing_free_kick}) {
    situation = with_ball(situation, {1, 1});
    situation = in_set_play(situation, play, false);
    expect({2, 1}, {2.1, 1});
    expect({1, 1}, {-0.1, 1});
    expect({3, 1});
    situation.duty = Duty::plays_ball;
    expect({1, 0}, {1, -0.1});
    situation.ball_trusted = false;
    expect({1, 0});
    situation = in_set_play(with_ball(situation, {1, 1}), play, true);
    expect({1, 0});
    situation.duty = Duty::other;
  }
}

TEST_F(LegalPlace, WithoutAMarginOnlyWhatTheRulesAsk) {
  situation = in_set_play(situation, SetPlay::kick_off, false);
  const Pose pose = legal_place(situation, {.margin = 0.0}, {0.0, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(pose.x, -0.9);
}

// What is legal stays where it is: asked again, the answer is the same.
TEST_F(LegalPlace, ALegalPlaceIsLegal) {
  regista::testkit::Dice dice(1);
  for (int round = 0; round < 3000; ++round) {
    Situation any = in_set_play(situation, static_cast<SetPlay>(dice.integer(0, 6)), dice.chance(0.5),
                                static_cast<Phase>(dice.integer(1, 3)));
    any.duty = static_cast<Duty>(dice.integer(0, 2));
    any.facts.own_number = dice.integer(1, 3);
    // Where keeping away from the ball leads neither off the field nor into the goal area.
    const double bx = dice.real(-2.5, 3.3), by = dice.real(-1.8, 1.8);
    any = with_ball(any, {bx, by});
    const double x = dice.real(-5, 5), y = dice.real(-4, 4);
    const Pose once = legal_place(any, {}, {x, y, 0.0}), twice = legal_place(any, {}, once);
    EXPECT_NEAR(std::hypot(twice.x - once.x, twice.y - once.y), 0.0, 1e-9) << "round " << round;
  }
}

}  // namespace
