// SPDX-License-Identifier: MIT
// The metrics of whole matches: what the match feeds them with.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "match/match.hpp"
#include "scripted.hpp"

namespace regista::match {
namespace {

using scripted::chasers;
using scripted::setup;
using scripted::statues;

// Initial 1 s, Ready and Set 1 s each, then 20 s of play in each half.
match::Setup short_halves(std::uint64_t seed) {
  match::Setup s = setup(seed);
  s.rules.durations.ready = 1.0;
  s.rules.durations.set = 1.0;
  s.rules.durations.half = 20.0;
  return s;
}

// Robots that stand where they are put, and are asked for the truth.
TEST(MetricsOfAMatch, WhoIsAskedForTheTruthErrsNowhere) {
  const match::Setup s = short_halves(1);
  const Roster roster{s.rules.team_size};
  std::vector<BodyState> bodies;
  int half = 1;
  Observer observer;
  observer.step = [&](const Snapshot& now) {
    bodies.assign(now.bodies.begin(), now.bodies.end());
    half = now.state.half;
  };
  std::array<std::vector<int>, 2> asked{std::vector<int>(7, 0), std::vector<int>(7, 0)};
  const Beliefs beliefs = [&](Side side, int number, Belief& out) {
    ++asked[index(side)][static_cast<std::size_t>(number - 1)];
    const double direction = attack(side, half);
    const auto estimate = [&](std::size_t i) {
      return Estimate{true, direction * Vector{bodies[i].x, bodies[i].y}, 0.01, 0.0, 0.01};
    };
    out.self = estimate(static_cast<std::size_t>(roster.id(side, number)));
    out.ball = estimate(14);
    out.teammates.clear();
    out.opponents.clear();
    for (int other = 1; other <= 7; ++other) {
      out.teammates.push_back(estimate(static_cast<std::size_t>(roster.id(side, other))));
      out.opponents.push_back(estimate(static_cast<std::size_t>(roster.id(opposite(side), other))).at);
    }
  };
  const Result result = play(s, statues(7), statues(7), &observer, beliefs);
  for (const Side side : both_sides) {
    const TeamMetrics& team = result.metrics.teams[index(side)];
    for (const int times : asked[index(side)]) EXPECT_NEAR(times, 40, 2);
    EXPECT_NEAR(*team.world_model.ball.rmse_metres, 0.0, 1e-6);
    EXPECT_NEAR(*team.world_model.self.rmse_metres, 0.0, 1e-6);
    EXPECT_NEAR(*team.world_model.teammates.rmse_metres, 0.0, 1e-6);
    EXPECT_NEAR(*team.world_model.ospa_metres, 0.0, 1e-6);
    EXPECT_NEAR(team.play.distance_walked_metres, 0.0, 1e-3);
    EXPECT_EQ(team.coordination.silent_seconds, result.metrics.playing_seconds) << "statues send nothing";
  }
}

TEST(MetricsOfAMatch, NobodyIsAskedWhereNobodyAnswers) {
  match::Setup s = short_halves(2);
  const Result result = play(s, chasers(7, 20), chasers(7));
  const auto& teams = result.metrics.teams;
  EXPECT_EQ(teams[0].world_model.ball.known_share, std::nullopt);
  EXPECT_GT(*teams[0].world_model.ball_seen_share, 0.2);
  EXPECT_LE(*teams[0].world_model.ball_seen_share, 1.0);
  EXPECT_EQ(teams[0].coordination.silent_seconds, 0.0);
  EXPECT_EQ(teams[1].coordination.silent_seconds, result.metrics.playing_seconds);
  EXPECT_GT(teams[0].play.distance_walked_metres, 1.0);
  // 0.25 m/s at most, two robots that chase, four that have gone where they wait, and pushing.
  EXPECT_LT(teams[0].play.distance_walked_metres, 7 * 0.25 * result.metrics.playing_seconds);
  EXPECT_EQ(teams[0].budget_curve.size(), 0u) << "forty seconds";
}

// Of a goal that somebody shot there is a shot.
TEST(MetricsOfAMatch, GoalsComeFromShots) {
  match::Setup s = setup(3);
  s.rules.durations.ready = 20.0;
  const Result result = play(s, chasers(7, 0, true), chasers(7, 0, true));
  const auto& teams = result.metrics.teams;
  int goals = 0, shots = 0, scored = 0;
  for (const std::size_t side : {0u, 1u}) {
    goals += result.score[side];
    shots += teams[side].play.shots;
    scored += teams[side].play.shots_scored;
    EXPECT_LE(teams[side].play.shots_scored, result.score[side]);
    EXPECT_LE(teams[side].play.shots_scored + teams[side].play.shots_saved, teams[side].play.shots);
    EXPECT_EQ(teams[side].budget_curve.size(), 20u);
    EXPECT_LE(teams[side].play.shots, teams[side].touches);
  }
  ASSERT_GT(goals, 0);
  EXPECT_GT(scored, goals / 2) << "the others are own goals and rebounds";
  EXPECT_GE(shots, scored);
}

}  // namespace
}  // namespace regista::match
