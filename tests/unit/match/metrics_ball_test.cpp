// SPDX-License-Identifier: MIT
// Who is at the ball, in scenes of three against three. Home 1..3 are 0..2, away 1..3 are 3..5, the ball is 6.
#include "match/metrics_play.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace regista::match {
namespace {

constexpr RobotSet everybody = 0b111111;

struct AtTheBall : testing::Test {
  std::array<config::Robot, 2> robots;
  BallMeasures measures{3, robots};
  GameState state;
  std::vector<BodyState> bodies = std::vector<BodyState>(7, BodyState{});

  // Everybody stands far away, each at a place of its own.
  AtTheBall() {
    state.phase = mind::Phase::playing;
    for (std::size_t id = 0; id < 6; ++id) put(id, id < 3 ? -3.0 : 3.0, static_cast<double>(id % 3) - 1.0);
  }
  void put(std::size_t id, double x, double y) {
    bodies[id].x = static_cast<float>(x);
    bodies[id].y = static_cast<float>(y);
  }
  void sample(int times, RobotSet able = everybody) {
    for (int i = 0; i < times; ++i) measures.sample(state, bodies, able);
  }
  void plays(int id) { measures.decided(id, true, false, std::nullopt); }
  void supports(int id, Vector target) { measures.decided(id, false, false, target); }
  BallMetrics home() const { return measures.result(Side::home); }
  BallMetrics away() const { return measures.result(Side::away); }
};

TEST_F(AtTheBall, NothingSampledIsNothingSaid) {
  EXPECT_EQ(home().nearest_plays_share, std::nullopt);
  EXPECT_EQ(home().robots_near, std::nullopt);
  EXPECT_EQ(home().chased_by_several_seconds, 0.0);
  EXPECT_EQ(measures.rests().seconds, 0.0);
}

TEST_F(AtTheBall, TheNearestPlaysItOrAnotherOne) {
  put(1, -2.0, 0.0);
  plays(1);
  plays(5);
  sample(3);
  put(2, -1.9, 0.0);
  sample(1);
  EXPECT_EQ(home().nearest_plays_share, 0.75);
  EXPECT_EQ(away().nearest_plays_share, 0.0) << "away 2 is the nearest of them";
}

TEST_F(AtTheBall, WhoGoesForItPlaysItWhateverTheRole) {
  put(1, -2.0, 0.0);
  plays(2);
  sample(1);
  EXPECT_EQ(home().nearest_plays_share, 0.0);
  supports(1, {0.0, 0.29});
  sample(1);
  EXPECT_EQ(home().nearest_plays_share, 0.5);
}

TEST_F(AtTheBall, OfEquallyNearOnesTheFirst) {
  put(1, -1.0, 0.0);
  put(2, 1.0, 0.0);
  plays(2);
  sample(1);
  EXPECT_EQ(home().nearest_plays_share, 0.0);
}

TEST_F(AtTheBall, WhoCannotGoIsNotTheNearest) {
  put(0, -0.5, 0.0);
  put(1, -1.0, 0.0);
  put(2, -2.0, 0.0);
  plays(2);
  sample(2);
  state.penalised[0] = 0b001;
  sample(2, everybody & ~only(1));
  EXPECT_EQ(home().nearest_plays_share, 0.5);
  EXPECT_EQ(home().robots_near, 1.5) << "one of them lies there, the other one is off the field";
  sample(4, everybody & ~only(1) & ~only(2));
  EXPECT_EQ(home().nearest_plays_share, 0.5) << "of the samples with an able robot";
}

TEST_F(AtTheBall, NearIsAMetre) {
  put(0, 0.99, 0.0);
  put(1, 0.0, -0.99);
  put(2, 0.8, 0.7);
  put(3, 0.0, 1.01);
  sample(5);
  EXPECT_EQ(home().robots_near, 2.0);
  EXPECT_EQ(away().robots_near, 0.0);
  put(6, 3.0, 0.0);
  sample(5);
  EXPECT_EQ(home().robots_near, 1.0);
  EXPECT_EQ(away().robots_near, 1.0) << "two on the line of three, and one that has left it";
}

TEST_F(AtTheBall, SeveralChaseItWhateverTheirRoles) {
  put(6, 2.0, 1.0);
  plays(0);
  sample(10);
  EXPECT_EQ(home().chased_by_several_seconds, 0.0) << "one of them alone";
  supports(1, {2.0, 1.29});
  sample(10);
  EXPECT_EQ(home().chased_by_several_seconds, 1.0);
  supports(1, {2.0, 1.31});
  sample(10);
  EXPECT_EQ(home().chased_by_several_seconds, 1.0) << "beside the ball";
  measures.decided(1, false, true, Vector{-4.0, 0.0});
  sample(10);
  EXPECT_EQ(home().chased_by_several_seconds, 2.0) << "it would kick";
  sample(10, everybody & ~only(0));
  state.penalised[0] = 0b010;
  sample(10);
  EXPECT_EQ(home().chased_by_several_seconds, 2.0) << "who lies or is off the field chases nothing";
  EXPECT_EQ(away().chased_by_several_seconds, 0.0);
}

// The frame of the side: away attacks towards -x in the first half, home in the second.
TEST_F(AtTheBall, TargetsAreInTheFrameOfTheirSide) {
  put(6, 2.0, 1.0);
  for (const int id : {0, 1, 3, 4}) supports(id, {-2.0, -1.0});
  sample(10);
  EXPECT_EQ(home().chased_by_several_seconds, 0.0);
  EXPECT_EQ(away().chased_by_several_seconds, 1.0);
  state.half = 2;
  sample(20);
  EXPECT_EQ(home().chased_by_several_seconds, 2.0);
  EXPECT_EQ(away().chased_by_several_seconds, 1.0);
}

// 0.15 m of body and 3 s at 0.25 m/s are 0.9 m.
TEST_F(AtTheBall, ItRestsWhereSomebodyCouldBeThereSoon) {
  sample(10);
  EXPECT_EQ(measures.rests().seconds, 0.0) << "all are too far away";
  put(4, 0.0, 0.91);
  sample(10);
  EXPECT_EQ(measures.rests().seconds, 0.0);
  put(4, 0.0, 0.89);
  sample(10);
  EXPECT_EQ(measures.rests().seconds, 1.0);
  sample(10, everybody & ~only(4));
  EXPECT_EQ(measures.rests().seconds, 1.0) << "it lies";
  bodies[6].vx = 0.03f;
  bodies[6].vy = -0.03f;
  sample(10);
  EXPECT_EQ(measures.rests().seconds, 2.0) << "0.042 m/s";
  bodies[6].vx = 0.05f;
  sample(10);
  EXPECT_EQ(measures.rests().seconds, 2.0) << "0.058 m/s";
}

TEST_F(AtTheBall, ARestLastsUntilTheBallMovesOrNobodyIsNear) {
  EXPECT_EQ(measures.rests().count, 0);
  put(4, 0.0, 0.5);
  sample(150);
  EXPECT_EQ(measures.rests().count, 1);
  EXPECT_EQ(measures.rests().long_ones, 0) << "15 s are not more than 15 s";
  sample(1);
  EXPECT_EQ(measures.rests().long_ones, 1);
  sample(29);
  EXPECT_EQ(measures.rests().long_ones, 1) << "it is one rest";
  EXPECT_EQ(measures.rests().longest_seconds, 18.0);
  bodies[6].vx = 0.1f;
  sample(10);
  bodies[6].vx = 0.0f;
  sample(20);
  EXPECT_EQ(measures.rests().count, 2);
  sample(1, 0);
  sample(20);
  EXPECT_EQ(measures.rests().count, 3);
  EXPECT_EQ(measures.rests().seconds, 22.0);
  EXPECT_EQ(measures.rests().longest_seconds, 18.0);
}

TEST_F(AtTheBall, FiveOfBothTeamsAreACrowd) {
  for (const std::size_t id : {0u, 1u, 3u, 4u}) put(id, 0.2 * static_cast<double>(id), 0.5);
  sample(10);
  EXPECT_EQ(measures.crowd_seconds(), 0.0);
  put(5, -0.5, 0.0);
  sample(10);
  EXPECT_EQ(measures.crowd_seconds(), 1.0);
  state.penalised[1] = 0b100;
  sample(10);
  EXPECT_EQ(measures.crowd_seconds(), 1.0) << "one has left the field";
}

TEST(TheBallRests, ByTheSpeedOfTheRobotsOfEachSide) {
  std::array<config::Robot, 2> robots;
  robots[1].walk.forward = 0.5;
  robots[1].body.radius = 0.2;
  BallMeasures measures(1, robots);
  GameState state;
  std::vector<BodyState> bodies(3, BodyState{});
  bodies[0].x = -1.0f;
  bodies[1].x = 1.69f;
  measures.sample(state, bodies, 0b11);
  EXPECT_EQ(measures.rests().seconds, 0.1);
  measures.sample(state, bodies, 0b01);
  EXPECT_EQ(measures.rests().seconds, 0.1);
  bodies[1].x = 1.71f;
  measures.sample(state, bodies, 0b11);
  EXPECT_EQ(measures.rests().seconds, 0.1);
}

}  // namespace
}  // namespace regista::match
