// SPDX-License-Identifier: MIT
// What the measures are fed with, on courses that can be counted by hand.
#include "match/metrics.hpp"

#include <gtest/gtest.h>

#include <tuple>
#include <vector>

namespace regista::match {
namespace {

const std::vector<Role> table{{"goalkeeper", "playing", 0, {1}}, {"striker", "playing", 1, {}, 1, true}};
constexpr RobotSet everybody = 0b111111;

config::Rules rules_of_three() {
  config::Rules rules;
  rules.team_size = 3;
  return rules;
}

mind::Outcome of_role(int role) {
  mind::Outcome out;
  out.role = role;
  return out;
}

struct Course : testing::Test {
  Metrics metrics{rules_of_three(), {}, {table, {}}};
  GameState state;
  std::vector<BodyState> bodies = std::vector<BodyState>(7, BodyState{});
  Course() { state.phase = mind::Phase::playing; }

  void sample(int times, RobotSet able = everybody) {
    for (int i = 0; i < times; ++i) metrics.sample(state, bodies, able);
  }
  void decide(Side side, int number, const mind::Outcome& outcome, double time = 0.0, bool sees_ball = false) {
    metrics.decided(side, number, outcome, sees_ball, time, state);
  }
  void touch(int id) { metrics.stepped(bodies.back(), id, state); }
  MatchMetrics result(double end = 0.0) const { return metrics.result(state, end); }
};

TEST_F(Course, CountsOnlyWhilePlaying) {
  state.phase = mind::Phase::ready;
  decide(Side::home, 2, of_role(1), 0.0, true);
  decide(Side::home, 3, of_role(1), 0.0, true);
  sample(10);
  const MatchMetrics all = result();
  EXPECT_EQ(all.teams[0].coordination.roles[1].all.overlap_seconds, 0.0);
  EXPECT_EQ(all.teams[0].coordination.roles[1].all.switches, 0);
  EXPECT_EQ(all.teams[0].world_model.ball_seen_share, std::nullopt);
  EXPECT_EQ(all.playing_seconds, 0.0);
}

TEST_F(Course, PossessionGoesToTheLastTouchWhileTheBallIsInPlay) {
  sample(10);
  touch(3);
  sample(20);
  state.set_play = mind::SetPlay::kick_in;
  sample(30);
  const MatchMetrics all = result();
  EXPECT_EQ(all.playing_seconds, 6.0);
  EXPECT_EQ(all.in_play_seconds, 3.0);
  EXPECT_EQ(all.teams[1].play.possession_seconds, 2.0);
  EXPECT_EQ(all.teams[0].play.possession_seconds, 0.0);
  EXPECT_EQ(all.teams[1].touches, 1);
}

TEST_F(Course, AccountsPacketsByReason) {
  metrics.sent(Side::home, 0, 40, 1.0);
  metrics.sent(Side::home, 5, 128, 2.0);
  metrics.sent(Side::home, 5, 0, 3.0);
  const TeamMetrics team = result().teams[0];
  EXPECT_EQ(team.packet_bytes, 168);
  EXPECT_EQ(team.packets_by_reason[0], 1);
  EXPECT_EQ(team.packets_by_reason[5], 2);
}

TEST_F(Course, SegmentsAreCountedInEveryPhase) {
  mind::Outcome outcome;
  outcome.segments = {.offered = 5, .refused = 1, .sent = 2, .dropped = 2, .heard = 7, .bytes = 30};
  decide(Side::away, 1, outcome);
  state.phase = mind::Phase::ready;
  decide(Side::away, 2, outcome, 0.1);
  metrics.crashed(Side::away, 2, state);
  const mind::SegmentCounts home = result().teams[0].segments, away = result().teams[1].segments;
  EXPECT_EQ(home.offered + home.refused + home.sent + home.dropped + home.heard + home.bytes, 0);
  EXPECT_EQ(std::tuple(away.offered, away.refused, away.sent, away.dropped, away.heard, away.bytes),
            std::tuple(10, 2, 4, 4, 14, 60));
}

TEST_F(Course, SilenceIsOfOneTeam) {
  decide(Side::home, 2, of_role(1));
  decide(Side::home, 3, of_role(1));
  sample(300);
  metrics.sent(Side::home, 0, 40, 30.0);
  sample(500);
  metrics.sent(Side::away, 0, 40, 79.0);
  const MatchMetrics all = result(80.0);
  EXPECT_EQ(all.teams[0].coordination.silent_seconds, 50.0);
  EXPECT_EQ(all.teams[1].coordination.silent_seconds, 0.0);
  EXPECT_EQ(all.teams[0].coordination.roles[1].after_silence.overlap_seconds, 50.0);
}

// A team of three that agrees on its context alone, with targets at the corners of a triangle of 3, 4 and 5 m.
TEST_F(Course, WhatWasDecidedReachesTheMeasuresOfItsTeam) {
  bodies[1].x = 0.5f;
  bodies[2].x = 0.9f;
  mind::Outcome first, second, third;
  first.context = second.context = third.context = 0;
  first.role = 0;
  first.kept = {0};
  second.kept = third.kept = {0, 1};
  first.target = {-3.0, 0.0};
  second.target = {0.0, 0.0};
  second.role = 1;
  third.target = {0.0, 4.0};
  third.command.kick = mind::KickRequest{};
  bodies[0].x = -4.0f;
  decide(Side::home, 1, first);
  decide(Side::home, 2, second);
  decide(Side::home, 3, third);
  sample(10);
  const MatchMetrics all = result();
  const TeamMetrics& home = all.teams[0];
  EXPECT_EQ(home.agreement.context, 1.0);
  EXPECT_EQ(home.agreement.kept_tasks, 0.0);
  EXPECT_EQ(home.agreement.assignment_given_tasks, std::nullopt);
  EXPECT_DOUBLE_EQ(*home.targets.mean_metres, 4.0);
  EXPECT_DOUBLE_EQ(*home.targets.least_metres, 3.0);
  EXPECT_EQ(home.ball.nearest_plays_share, 1.0);
  EXPECT_EQ(home.ball.robots_near, 2.0);
  EXPECT_EQ(home.ball.chased_by_several_seconds, 1.0) << "one plays it, one wants to kick it";
  EXPECT_EQ(all.ball_rests.seconds, 1.0);
  EXPECT_EQ(all.teams[1].ball.nearest_plays_share, 0.0);
  EXPECT_EQ(all.teams[1].targets.mean_metres, std::nullopt);
  // Out of play nothing of it is about the ball; the rest goes on.
  state.set_play = mind::SetPlay::kick_in;
  decide(Side::home, 1, second);
  decide(Side::home, 3, second);
  sample(10);
  EXPECT_EQ(result().teams[0].ball.chased_by_several_seconds, 1.0);
  EXPECT_EQ(result().ball_rests.seconds, 1.0);
  EXPECT_EQ(result().teams[0].agreement.kept_tasks, 0.5);
  EXPECT_EQ(result().teams[0].agreement.assignment_given_tasks, 1.0);
}

// What the behaviour announces counts, and not the role: a striker that leaves the ball, a supporter that takes it.
TEST_F(Course, WhoAnnouncesATargetGoesThere) {
  bodies[0].x = -4.0f;
  bodies[1].x = 0.5f;
  bodies[2].x = 2.0f;
  mind::Outcome leaves = of_role(1), takes = of_role(0);
  decide(Side::home, 2, leaves);
  decide(Side::home, 3, takes);
  sample(10);
  EXPECT_EQ(result().teams[0].ball.nearest_plays_share, 1.0);
  leaves.announced = {-1.2, 0.0};
  decide(Side::home, 2, leaves);
  sample(10);
  EXPECT_EQ(result().teams[0].ball.nearest_plays_share, 0.5);
  takes.announced = {0.0, 0.0};
  decide(Side::home, 3, takes);
  bodies[2].x = 0.4f;
  sample(20);
  EXPECT_EQ(result().teams[0].ball.nearest_plays_share, 0.75);
  EXPECT_EQ(result().teams[0].ball.chased_by_several_seconds, 0.0) << "one at a time";
}

TEST_F(Course, MeantPassesAreOfTheKicker) {
  metrics.kicked(2, 2);
  metrics.kicked(4, 0);
  EXPECT_EQ(result().teams[0].play.meant_passes, 1);
  EXPECT_EQ(result().teams[0].kicks, 1);
  EXPECT_EQ(result().teams[1].play.meant_passes, 0);
  EXPECT_EQ(result().teams[1].kicks, 1);
}

TEST_F(Course, TenuresAreFinishedByDecisionsInPlayAlone) {
  const auto take = [this](int role, double time) { decide(Side::home, 2, of_role(role), time); };
  take(0, 0.0);
  take(1, 3.0);
  EXPECT_EQ(result().teams[0].tenure.median_seconds, 3.0);
  state.penalised[0] = 0b010;
  take(-1, 4.0);
  state.penalised[0] = 0;
  take(1, 5.0);
  metrics.crashed(Side::home, 2, state);
  take(0, 9.0);
  state.phase = mind::Phase::ready;
  take(1, 10.0);
  state.phase = mind::Phase::playing;
  EXPECT_EQ(result().teams[0].tenure.median_seconds, 3.0);
  take(1, 11.0);
  take(0, 16.0);
  EXPECT_EQ(result().teams[0].tenure.median_seconds, 4.0) << "the mean of 3 s and 5 s";
  EXPECT_EQ(result().teams[1].tenure.median_seconds, std::nullopt);
}

TEST_F(Course, WhoHasCrashedDecidesOnNothing) {
  mind::Outcome same;
  same.context = 0;
  same.role = 1;
  same.target = {0.0, 0.0};
  for (int number = 1; number <= 3; ++number) decide(Side::home, number, same);
  metrics.crashed(Side::home, 1, state);
  sample(10, everybody & ~only(0));
  const TeamMetrics home = result().teams[0];
  EXPECT_EQ(home.agreement.context, 0.0);
  EXPECT_EQ(home.coordination.roles[1].robot_seconds, (std::vector{0.0, 1.0, 1.0}));
  EXPECT_EQ(home.targets.mean_metres, 0.0) << "of the other two";
  EXPECT_EQ(home.ball.nearest_plays_share, 1.0);
}

// Two halves of ten minutes; a packet of home every ten seconds of the clock.
TEST_F(Course, TheBudgetCurveHasAPointForEachMinuteOfTheClock) {
  state.packets_left = {1200, 1200};
  for (state.half = 1; state.half <= 2; ++state.half) {
    for (int tenths = 0; tenths <= 6000; ++tenths) {
      state.clock = 0.1 * tenths;
      if (tenths > 0 && tenths % 100 == 0) --state.packets_left[0];
      // The last one ends the match, and is not sampled.
      if (state.half < 2 || tenths < 6000) metrics.sample(state, bodies, everybody);
    }
  }
  state.half = 2;
  state.clock = 600.0;
  const MatchMetrics all = result();
  ASSERT_EQ(all.teams[0].budget_curve.size(), 20u);
  for (int minute = 1; minute <= 20; ++minute) {
    EXPECT_EQ(all.teams[0].budget_curve[static_cast<std::size_t>(minute - 1)], 1200 - 6 * minute);
    EXPECT_EQ(all.teams[1].budget_curve[static_cast<std::size_t>(minute - 1)], 1200);
  }
}

// Beliefs are in the frame of the side, which is turned about in the second half and for away.
TEST_F(Course, BeliefsMeetTheTruthInTheirOwnFrame) {
  const auto put = [this](std::size_t id, double x, double y) {
    bodies[id].x = static_cast<float>(x);
    bodies[id].y = static_cast<float>(y);
  };
  put(3, 3.0, 0.5);
  put(4, 1.0, -0.5);
  put(5, 8.0, 8.0);
  put(0, -2.0, 0.25);
  put(1, 0.5, 0.5);
  put(2, 8.0, -8.0);
  put(6, 1.5, 0.75);
  state.penalised = {0b100, 0b100};
  Belief belief;
  belief.self = {true, {-3.0, -0.5}, 1.0, 0.0, 1.0};
  belief.ball = {true, {-1.5, -0.75}, 1.0, 0.0, 1.0};
  belief.teammates = {{}, {true, {-1.0, 0.5}, 1.0, 0.0, 1.0}, {}};
  belief.opponents = {{-0.5, -0.5}, {2.0, -0.25}};
  metrics.believes(Side::away, 1, belief, bodies, state);
  const auto check = [this](std::size_t side) {
    const WorldModelMetrics model = result().teams[side].world_model;
    EXPECT_EQ(model.self.rmse_metres, 0.0);
    EXPECT_EQ(model.ball.rmse_metres, 0.0);
    EXPECT_EQ(model.teammates.rmse_metres, 0.0);
    EXPECT_EQ(model.teammates.known_share, 1.0) << "the third one is off the field";
    EXPECT_EQ(model.ospa_metres, 0.0) << "their third one, too";
  };
  check(1);
  EXPECT_EQ(result().teams[0].world_model.self.rmse_metres, std::nullopt);
  // In the second half home attacks where away did.
  state.half = 2;
  std::swap_ranges(bodies.begin(), bodies.begin() + 3, bodies.begin() + 3);
  metrics.believes(Side::home, 1, belief, bodies, state);
  check(0);
}

}  // namespace
}  // namespace regista::match
