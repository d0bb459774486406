// SPDX-License-Identifier: MIT
// Each rule as a small scene. Home attacks towards +x in the first half.
#include "match/referee.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "match/arena.hpp"

namespace regista::match {
namespace {

using mind::Phase;
using mind::SetPlay;

struct Game : testing::Test {
  config::Rules rules;
  Referee referee{rules, 0.15};
  std::vector<Vector> robots = std::vector<Vector>(14);
  Vector ball;
  double time = 0.0;
  std::vector<EventKind> events;

  Game() { referee_step(-1); }
  void restart() {
    referee = Referee(rules, 0.15);
    robots.assign(static_cast<std::size_t>(2 * rules.team_size), {});
    time = 0.0;
    events.clear();
    referee_step(-1);
  }

  const GameState& state() const { return referee.state(); }
  const Calls& referee_step(int touched_by) {
    const Calls& calls = referee.update({time, ball, touched_by, robots});
    for (const Placement& placement : calls.placements) {
      robots[static_cast<std::size_t>(placement.robot)] = {placement.pose.x, placement.pose.y};
    }
    for (const int id : calls.removed) robots[static_cast<std::size_t>(id)] = {-4.0, 5.0};
    if (calls.ball) ball = *calls.ball;
    for (const Event& event : calls.events) events.push_back(event.kind);
    return calls;
  }
  const Calls& step(int touched_by = -1) {
    time += physics_step;
    return referee_step(touched_by);
  }
  void wait(double seconds) {
    const int steps = static_cast<int>(std::lround(seconds / physics_step));
    for (int i = 0; i < steps; ++i) step();
  }
  void until(Phase phase) {
    for (int i = 0; i < 5000 && state().phase != phase; ++i) step();
    ASSERT_EQ(state().phase, phase);
  }
  int id(Side side, int number) const { return Roster{rules.team_size}.id(side, number); }
  Vector& robot(Side side, int number) { return robots[static_cast<std::size_t>(id(side, number))]; }
  // Kick-off is taken by home 2, then home 3 has touched the ball: everything is open.
  void play() {
    until(Phase::playing);
    step(id(Side::home, 2));
    step(id(Side::home, 3));
    ASSERT_TRUE(state().in_play());
  }
  bool happened(EventKind kind) const { return std::find(events.begin(), events.end(), kind) != events.end(); }
};

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

TEST_F(Game, ASetPlayEndsWithATouchOrInThirtySeconds) {
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

TEST_F(Game, TheKickOffBallIsFreeAfterTenSecondsOrATouch) {
  until(Phase::playing);
  wait(9.9);
  EXPECT_EQ(state().set_play, SetPlay::kick_off);
  wait(0.2);
  EXPECT_TRUE(state().in_play());
}

TEST_F(Game, AGoalFromKickOffCountsButNotDirectlyFromAGoalKick) {
  until(Phase::playing);
  step(id(Side::home, 2));
  ball = {4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[0], 1);
  until(Phase::playing);
  step(id(Side::away, 2));
  step(id(Side::away, 3));
  ball = {-4.6, 2.0};
  step();  // goal kick for home
  ASSERT_EQ(state().set_play, SetPlay::goal_kick);
  step(id(Side::home, 1));
  ball = {4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[0], 1);
  EXPECT_TRUE(happened(EventKind::goal_not_counted));
  EXPECT_EQ(state().set_play, SetPlay::goal_kick);
  EXPECT_EQ(state().kicking, Side::away);
  step(id(Side::away, 1));
  step(id(Side::home, 5));  // a second robot
  ball = {4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[0], 2);
}

TEST_F(Game, ASelfPassMustLeaveTheCircle) {
  play();
  ball = {0.0, 3.2};
  step(id(Side::away, 4));
  step(id(Side::home, 2));
  ball = {0.5, 2.8};
  step(id(Side::home, 2));
  ball = {4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[0], 0);
  step(id(Side::away, 2));
  step(id(Side::away, 3));
  ball = {0.0, 3.2};
  step();
  step(id(Side::home, 2));
  ball = {0.8, 2.8};
  step(id(Side::home, 2));
  ball = {4.6, 0.0};
  step();
  EXPECT_EQ(state().goals[0], 1);
}

TEST_F(Game, WhoEntersTheCircleBeforeTheKickOffIsRemoved) {
  until(Phase::playing);
  robot(Side::away, 3) = {0.5, 0.0};
  robot(Side::home, 3) = {-0.5, 0.2};
  const Calls& calls = step();
  EXPECT_EQ(calls.removed, std::vector{id(Side::away, 3)});
  EXPECT_TRUE(state().is_penalised(Side::away, 3));
  EXPECT_FALSE(state().is_penalised(Side::home, 3));
}

TEST_F(Game, PenaltiesGrowAndEndAtTheTouchLineFarFromTheBall) {
  play();
  for (int number = 1; number <= 7; ++number) robot(Side::away, number) = {4.0, 0.4 * (number - 4)};
  double expected = 45.0;
  for (int offence = 0; offence < 3; ++offence, expected += 10.0) {
    ball = {1.0, 3.2};
    step(id(Side::away, 4));  // kick-in for home
    wait(6.0);
    robot(Side::away, 5) = {1.0, 2.4};
    step();
    ASSERT_TRUE(state().is_penalised(Side::away, 5));
    const double begin = time;
    while (state().is_penalised(Side::away, 5)) {
      if (state().in_play())
        step(id(Side::away, 4));
      else
        step();
    }
    EXPECT_NEAR(time - begin, expected, 0.021);
    EXPECT_NEAR(robot(Side::away, 5).x, 3.2, 1e-9) << "own half, level with the penalty mark";
    EXPECT_NEAR(robot(Side::away, 5).y, -3.0, 1e-9);
  }
}

TEST_F(Game, WhoStoodNearHasTimeToLeave) {
  play();
  ball = {1.0, 3.2};
  robot(Side::away, 5) = {1.0, 2.5};
  robot(Side::home, 5) = {1.4, 2.6};
  step(id(Side::away, 4));
  wait(4.8);
  EXPECT_FALSE(state().is_penalised(Side::away, 5));
  wait(0.4);
  EXPECT_TRUE(state().is_penalised(Side::away, 5));
  EXPECT_FALSE(state().is_penalised(Side::home, 5)) << "the kicking side may be there";
}

TEST_F(Game, NobodyIsLeftStandingOnTheBall) {
  play();
  ball = {1.0, 3.2};
  robot(Side::home, 5) = {1.05, 3.0};
  robot(Side::away, 6) = {0.95, 3.1};
  step(id(Side::away, 4));
  EXPECT_GE(length(robot(Side::home, 5) - ball), 0.2);
  EXPECT_GE(length(robot(Side::away, 6) - ball), 0.75);
  EXPECT_GE(length(robot(Side::home, 5) - robot(Side::away, 6)), 0.3);
}

TEST_F(Game, RobotsWhereTheyMustNotBeInSetArePutBack) {
  until(Phase::ready);
  robot(Side::home, 2) = {-0.3, 0.0};  // kicks off: may be in the circle
  robot(Side::home, 3) = {0.5, 1.5};   // beyond the halfway line
  robot(Side::away, 2) = {0.5, 0.2};   // in the circle
  robot(Side::away, 3) = {-1.0, -1.0};
  robot(Side::away, 4) = {0.8, 0.0};
  until(Phase::set);
  EXPECT_EQ(robot(Side::home, 2), (Vector{-0.3, 0.0}));
  EXPECT_EQ(robot(Side::away, 4), (Vector{0.8, 0.0}));
  for (const int number : {2, 3}) {
    EXPECT_GT(robot(Side::away, number).x, 0.75);
  }
  EXPECT_LT(robot(Side::home, 3).x, -0.75);
  robot(Side::away, 4) = {-0.8, 0.0};  // walks in Set
  until(Phase::playing);
  EXPECT_GT(robot(Side::away, 4).x, 0.75);
}

TEST_F(Game, AStuckGameGoesToWhoDidNotTouchLast) {
  play();
  step(id(Side::away, 3));
  wait(29.9);
  EXPECT_TRUE(state().in_play());
  wait(0.2);
  EXPECT_EQ(state().phase, Phase::ready);
  EXPECT_EQ(state().kicking, Side::home);
  EXPECT_TRUE(happened(EventKind::game_stuck));
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
  EXPECT_EQ(std::count(events.begin(), events.end(), EventKind::too_many_packets), 1);
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

TEST(Allowance, GrowsWithAddedMinutes) {
  const config::Messages messages;
  EXPECT_EQ(Referee::allowance(messages, 0.0), 1200);
  EXPECT_EQ(Referee::allowance(messages, 59.0), 1200);
  EXPECT_EQ(Referee::allowance(messages, 150.0), 1320);
}

}  // namespace
}  // namespace regista::match
