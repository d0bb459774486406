// SPDX-License-Identifier: MIT
#include "match/placement.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "game.hpp"

namespace regista::match {
namespace {

struct InSet : testing::Test {
  config::Rules rules;
  Roster roster{7};
  GameState state;
  std::vector<Vector> robots = std::vector<Vector>(14);
  InSet() {
    state.phase = mind::Phase::set;
    state.set_play = mind::SetPlay::kick_off;
    for (int number = 1; number <= 7; ++number) {
      at(Side::home, number) = {-2.0, 0.6 * (number - 4)};
      at(Side::away, number) = {2.0, 0.6 * (number - 4)};
    }
  }
  Vector& at(Side side, int number) { return robots[static_cast<std::size_t>(roster.id(side, number))]; }
  RobotSet illegal() const { return illegal_in_set(rules, state, roster, robots, (RobotSet{1} << 14) - 1, 0.15); }
  RobotSet id(Side side, int number) const { return only(roster.id(side, number)); }
};

TEST_F(InSet, OwnHalvesAreLegal) { EXPECT_EQ(illegal(), 0u); }

TEST_F(InSet, OnlyTheSideThatKicksOffMayBeInTheCircle) {
  at(Side::home, 2) = {-0.5, 0.0};
  at(Side::away, 2) = {0.5, 0.2};
  EXPECT_EQ(illegal(), id(Side::away, 2));
  state.kicking = Side::away;
  EXPECT_EQ(illegal(), id(Side::home, 2));
}

TEST_F(InSet, OneOfThemMayStandBeyondTheHalfwayLineInTheCircle) {
  at(Side::home, 2) = {0.3, 0.3};
  EXPECT_EQ(illegal(), 0u);
  at(Side::home, 3) = {0.4, -0.4};
  EXPECT_EQ(illegal(), id(Side::home, 3)) << "the nearer one kicks off";
  at(Side::home, 3) = {0.9, -0.4};
  EXPECT_EQ(illegal(), id(Side::home, 3)) << "out of the circle";
}

TEST_F(InSet, NobodyMayBlockTheMark) {
  at(Side::home, 2) = {-0.15, 0.0};
  EXPECT_EQ(illegal(), id(Side::home, 2));
}

TEST_F(InSet, ThreeMayBeInTheirGoalAreaTheInnermost) {
  at(Side::home, 1) = {-4.4, 0.0};
  at(Side::home, 2) = {-4.2, 0.3};
  at(Side::home, 3) = {-4.2, -0.3};
  EXPECT_EQ(illegal(), 0u);
  at(Side::home, 4) = {-3.95, 0.0};
  EXPECT_EQ(illegal(), id(Side::home, 4));
  at(Side::home, 5) = {-4.2, 1.05};
  EXPECT_EQ(illegal(), id(Side::home, 4) | id(Side::home, 5));
}

TEST_F(InSet, TheBorderStripIsIllegalButTheGoalIsNot) {
  at(Side::home, 1) = {-4.7, 0.0};
  at(Side::home, 2) = {-4.7, 2.0};
  at(Side::away, 3) = {1.0, 3.2};
  at(Side::away, 4) = {1.0, 3.1};  // on the line
  EXPECT_EQ(illegal(), id(Side::home, 2) | id(Side::away, 3));
}

TEST_F(InSet, EverythingTurnsWithTheSecondHalf) {
  state.half = 2;
  for (Vector& robot : robots) robot = -1.0 * robot;
  EXPECT_EQ(illegal(), 0u);
  at(Side::home, 3) = {-1.0, 0.0};
  EXPECT_EQ(illegal(), id(Side::home, 3));
}

}  // namespace
}  // namespace regista::match
