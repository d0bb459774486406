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

// Statues that tell where they would stand, and that the odd ones see another context. No ball is near them.
TEST(MetricsOfAMatch, WhatMindsTellIsMeasured) {
  match::Setup s = short_halves(4);
  for (auto& roles : s.roles) roles = {{.name = "striker", .plays_ball = true}, {.name = "supporter"}};
  std::vector<mind::Think> minds;
  for (int number = 1; number <= 7; ++number) {
    minds.emplace_back(
        [number](const mind::Percepts& percepts, std::span<const mind::HeardPacket>, mind::Outcome& out) {
          out.context = number % 2;
          out.kept = {0, 1};
          out.target = mind::Target{static_cast<double>(number), 0.0};
          // Robot 2 takes the other role every 2 s.
          out.role = number == 2 && static_cast<int>((percepts.time + 1e-6) / 2.0) % 2 == 1 ? 0 : 1;
        });
  }
  const Result result = play(s, minds, statues(7));
  const TeamMetrics& home = result.metrics.teams[0];
  EXPECT_EQ(home.agreement.context, 0.0);
  EXPECT_EQ(home.agreement.kept_tasks, 1.0);
  EXPECT_EQ(home.agreement.assignment_given_tasks, 1.0);
  EXPECT_NEAR(*home.targets.mean_metres, 8.0 / 3.0, 1e-9) << "of seven points in a row, 1 m apart";
  EXPECT_NEAR(*home.targets.least_metres, 1.0, 1e-9);
  EXPECT_NEAR(*home.tenure.median_seconds, 2.0, 1e-9);
  EXPECT_EQ(result.metrics.teams[1].targets.mean_metres, std::nullopt);
  EXPECT_EQ(result.metrics.teams[1].tenure.median_seconds, std::nullopt);
}

// A game from the middle, of one robot a side: one turns about 0.6 m from the ball, the other one is far away.
match::Setup beside_the_ball() {
  match::Setup s = setup(5, 1);
  config::Opening opening;
  opening.ball.at = {0.0, 2.5};
  opening.home = {{{-0.6, 2.5}, {}}};
  opening.away = {{{3.0, 0.0}, {}}};
  s.opening = opening;
  s.limit = 10.0;
  for (auto& robot : s.robots) robot.body.falls_per_walking_minute = 0.0;
  return s;
}

double rest(const match::Setup& s) {
  const mind::Think turns = [](const mind::Percepts&, std::span<const mind::HeardPacket>, mind::Outcome& out) {
    out.command.walk.turn = 0.5;
  };
  return play(s, std::vector{turns}, std::vector{turns}).metrics.ball_rests.seconds;
}

TEST(MetricsOfAMatch, TheBallRestsBesideWhoStands) {
  match::Setup s = beside_the_ball();
  EXPECT_NEAR(rest(s), 10.0, 0.2);
  s.robots[0].body.falls_per_walking_minute = 1e9;  // as soon as it has got up
  EXPECT_LT(rest(s), 1.0);
}

TEST(MetricsOfAMatch, TheBallDoesNotRestBesideWhoHasCrashed) {
  match::Setup s = beside_the_ball();
  config::Incident crash;
  crash.kind = config::Incident::Kind::crash;
  crash.robots = {config::Incident::Whom::Choice::listed, {1}};
  crash.at = {4.0};
  s.disturbances[0].incidents = {crash};
  EXPECT_NEAR(rest(s), 4.0, 0.2);
}

// What is told of the play is what the metrics count. The minds of home mean every second kick for a teammate.
TEST(MetricsOfAMatch, AsMuchIsToldAsIsCounted) {
  match::Setup s = setup(3);
  s.rules.durations.half = 240.0;
  std::vector<mind::Think> home = chasers(7, 0, true);
  for (mind::Think& think : home) {
    think = [think, kicks = 0](const mind::Percepts& percepts, std::span<const mind::HeardPacket> heard,
                               mind::Outcome& out) mutable {
      think(percepts, heard, out);
      if (out.command.kick) out.command.kick->receiver = ++kicks % 2;
    };
  }
  std::array<std::array<int, 4>, 2> told{};
  std::array<std::array<int, 9>, 2> outcomes{};
  double last = 0.0;
  Observer observer;
  observer.play = [&](double time, const PlayEvent& event) {
    ++told[index(event.side)][static_cast<std::size_t>(event.kind)];
    const bool lost_duel = event.kind == PlayKind::duel && event.outcome == PlayOutcome::lost;
    const Side whose = lost_duel ? opposite(event.side) : event.side;
    ++outcomes[index(whose)][static_cast<std::size_t>(lost_duel ? PlayOutcome::won : event.outcome)];
    EXPECT_LE(last, time);
    EXPECT_LE(event.began, time);
    last = time;
  };
  const Result result = play(s, home, chasers(7, 0, true), &observer);
  const auto number = [](const auto& list, auto what) { return list[static_cast<std::size_t>(what)]; };
  int duels = 0, all = 0;
  for (const Side side : both_sides) {
    const PlayMetrics& counted = result.metrics.teams[index(side)].play;
    EXPECT_EQ(number(told[index(side)], PlayKind::shot), counted.shots);
    EXPECT_EQ(number(told[index(side)], PlayKind::pass), counted.meant_passes);
    EXPECT_EQ(number(told[index(side)], PlayKind::clearance), counted.clearances);
    duels += number(told[index(side)], PlayKind::duel);
    EXPECT_EQ(number(outcomes[index(side)], PlayOutcome::goal), counted.shots_scored);
    EXPECT_EQ(number(outcomes[index(side)], PlayOutcome::saved), counted.shots_saved);
    EXPECT_EQ(number(outcomes[index(side)], PlayOutcome::arrived), counted.meant_passes_arrived);
    EXPECT_EQ(number(outcomes[index(side)], PlayOutcome::intercepted), counted.meant_passes_intercepted);
    EXPECT_EQ(number(outcomes[index(side)], PlayOutcome::won), counted.duels_won);
    all += counted.shots + counted.meant_passes + counted.clearances;
  }
  EXPECT_EQ(duels, result.metrics.duels);
  EXPECT_GT(duels, 0);
  EXPECT_GT(all, 10);
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
