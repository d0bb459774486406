// SPDX-License-Identifier: MIT
// Games that start from an opening: what stands where, what is told, when it ends, and that it is a function of all of
// that.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "match/match.hpp"
#include "match/physics_world.hpp"
#include "match/referee.hpp"
#include "scripted.hpp"

namespace regista::match {
namespace {

using mind::Phase;
using mind::SetPlay;
using scripted::chasers;
using scripted::statues;

constexpr double pi = std::numbers::pi;

// Three robots a side; not symmetric, and most headings are written down.
config::Opening scene() {
  config::Opening out;
  out.name = "scene";
  out.length = 12.0;
  out.ball = {{1.25, -0.5}, {0.8, 0.6}};
  out.home = {{{-4.0, 0.1}, 0.25}, {{0.7, -0.4}, std::nullopt}, {{-1.0, 2.0}, -pi / 2.0}};
  out.away = {{{4.1, -0.2}, pi}, {{2.5, 1.5}, 2.0}, {{-0.4, -2.2}, std::nullopt}};
  return out;
}

Setup setup_of(const config::Opening& opening, int team_size = 3, std::uint64_t seed = 1) {
  Setup out = scripted::setup(seed, team_size);
  out.opening = opening;
  return out;
}

const config::Opening::Player& player(const config::Opening& opening, Side side, int number) {
  return (side == Side::home ? opening.home : opening.away)[static_cast<std::size_t>(number - 1)];
}

TEST(RefereeFromAnOpening, BeginsInPlayWithEverybodyInPlace) {
  config::Rules rules;
  rules.team_size = 3;
  const config::Opening opening = scene();
  Referee referee(rules, 0.15, &opening);
  const std::vector<Vector> robots(6);
  const Calls& calls = referee.update({.time = 0.0, .ball = {}, .robots = robots});
  EXPECT_EQ(referee.state().phase, Phase::playing);
  EXPECT_TRUE(referee.state().in_play());
  EXPECT_EQ(referee.state().half, 1);
  EXPECT_TRUE(referee.state().clock_runs);
  ASSERT_TRUE(calls.ball && calls.ball_velocity);
  EXPECT_EQ(*calls.ball, (Vector{1.25, -0.5}));
  EXPECT_EQ(*calls.ball_velocity, (Vector{0.8, 0.6}));
  EXPECT_TRUE(calls.announced);
  EXPECT_FALSE(calls.told_late);
  EXPECT_FALSE(calls.whistle) << "whoever plays takes a whistle for a goal";
  ASSERT_EQ(calls.placements.size(), 6u);
  const Roster roster{3};
  for (const Placement& placement : calls.placements) {
    const auto& wanted = player(opening, roster.side(placement.robot), roster.number(placement.robot));
    EXPECT_EQ(placement.pose.x, wanted.at[0]);
    EXPECT_EQ(placement.pose.y, wanted.at[1]);
    EXPECT_EQ(placement.pose.heading, config::heading(opening, wanted));
  }
}

TEST(RefereeFromAnOpening, PlaysOnByTheRules) {
  config::Rules rules;
  rules.team_size = 3;
  const config::Opening opening = scene();
  Referee referee(rules, 0.15, &opening);
  const std::vector<Vector> robots{{-4.0, 0.1}, {0.7, -0.4}, {-1.0, 2.0}, {4.1, -0.2}, {2.5, 1.5}, {-0.4, -2.2}};
  referee.update({.time = 0.0, .ball = {}, .robots = robots});
  referee.update({.time = 0.02, .ball = {1.3, -0.5}, .robots = robots});
  EXPECT_TRUE(referee.state().in_play());
  EXPECT_DOUBLE_EQ(referee.state().clock, 0.02);
  // A goal that nobody touched counts, and away kicks off.
  const Calls& goal = referee.update({.time = 0.04, .ball = {4.7, 0.0}, .robots = robots});
  EXPECT_EQ(referee.state().score(Side::home), 1);
  EXPECT_EQ(referee.state().phase, Phase::ready);
  EXPECT_EQ(referee.state().kicking, Side::away);
  EXPECT_EQ(*goal.ball, Vector{});
  EXPECT_FALSE(goal.ball_velocity);
  // The clock has run since the beginning: the half ends in its time.
  referee.update({.time = rules.durations.half, .ball = {}, .robots = robots});
  EXPECT_EQ(referee.state().half, 2);
  EXPECT_EQ(referee.state().phase, Phase::initial);
}

TEST(RefereeFromAnOpening, BallThatNobodyTouchesIsStuck) {
  config::Rules rules;
  rules.team_size = 3;
  const config::Opening opening = scene();
  Referee referee(rules, 0.15, &opening);
  const std::vector<Vector> robots{{-4.0, 0.1}, {0.7, -0.4}, {-1.0, 2.0}, {4.1, -0.2}, {2.5, 1.5}, {-0.4, -2.2}};
  referee.update({.time = 0.0, .ball = {}, .robots = robots});
  referee.update({.time = rules.durations.game_stuck - 0.02, .ball = {1.3, -0.5}, .robots = robots});
  EXPECT_TRUE(referee.state().in_play());
  referee.update({.time = rules.durations.game_stuck, .ball = {1.3, -0.5}, .robots = robots});
  EXPECT_EQ(referee.state().phase, Phase::ready);
}

TEST(MatchFromAnOpening, BodiesAreWhereTheSceneSaysBeforeAnythingMoves) {
  const config::Opening opening = scene();
  PhysicsLog log;
  Observer observer;
  observer.physics_log = &log;
  play(setup_of(opening), statues(3), statues(3), &observer);
  ASSERT_FALSE(log.step_ends.empty());
  const Roster roster{3};
  int robots = 0, balls = 0;
  Vector velocity;
  for (std::size_t i = 0; i < log.step_ends[0]; ++i) {
    const Operation& done = log.operations[i];
    const int id = done.body;
    if (done.kind == Operation::Kind::velocity && id == roster.count() && i < 8) velocity = {done.x, done.y};
    if (done.kind != Operation::Kind::place) continue;
    if (id == roster.count()) {
      ++balls;
      EXPECT_EQ(done.x, 1.25f);
      EXPECT_EQ(done.y, -0.5f);
      continue;
    }
    ++robots;
    const auto& wanted = player(opening, roster.side(id), roster.number(id));
    EXPECT_EQ(done.x, static_cast<float>(wanted.at[0]));
    EXPECT_EQ(done.y, static_cast<float>(wanted.at[1]));
    EXPECT_EQ(done.turn, static_cast<float>(config::heading(opening, wanted)));
  }
  EXPECT_EQ(robots, 6);
  EXPECT_EQ(balls, 1);
  EXPECT_EQ(velocity.x, static_cast<double>(0.8f));
  EXPECT_EQ(velocity.y, static_cast<double>(0.6f));
}

// The ball leaves with the scene's speed: it rolls v^2 / (2 a) where nothing is in its way.
TEST(MatchFromAnOpening, BallRollsOn) {
  config::Opening opening = scene();
  opening.ball = {{-1.5, -1.5}, {0.8, 0.6}};
  opening.length = 5.0;
  Vector last;
  Observer observer;
  observer.step = [&](const Snapshot& now) { last = {now.bodies.back().x, now.bodies.back().y}; };
  const match::Setup setup = setup_of(opening);
  play(setup, statues(3), statues(3), &observer);
  const double rolled = 1.0 / (2.0 * setup.rules.ball.rolling_deceleration);
  EXPECT_NEAR(last.x, -1.5 + 0.8 * rolled, 0.01);
  EXPECT_NEAR(last.y, -1.5 + 0.6 * rolled, 0.01);
}

struct First {
  bool seen = false;
  mind::GameTold game;
  std::optional<mind::PlacedPose> placed;
};

// By side and number - 1.
std::array<std::vector<First>, 2> first_percepts(const Setup& setup) {
  std::array<std::vector<First>, 2> out;
  for (auto& side : out) side.resize(static_cast<std::size_t>(setup.rules.team_size));
  Observer observer;
  observer.decision = [&](const Decision& decision) {
    First& first = out[index(decision.side)][static_cast<std::size_t>(decision.number - 1)];
    if (!first.seen) first = {true, decision.percepts.game, decision.percepts.placed};
  };
  play(setup, statues(setup.rules.team_size), statues(setup.rules.team_size), &observer);
  return out;
}

TEST(MatchFromAnOpening, MindsKnowFromTheirFirstDecisionThatItIsPlayed) {
  for (const auto& side : first_percepts(setup_of(scene()))) {
    for (const First& first : side) {
      ASSERT_TRUE(first.seen);
      EXPECT_EQ(first.game.phase, Phase::playing);
      EXPECT_EQ(first.game.set_play, SetPlay::none);
      EXPECT_EQ(first.game.half, 1);
      EXPECT_LT(first.game.phase_time, 0.1);
      EXPECT_GT(first.game.half_time_left, 599.8);
      EXPECT_EQ(first.game.packets_left, 1200);
    }
  }
}

TEST(MatchFromAnOpening, MindsAreToldWhereTheyStandInTheirOwnFrame) {
  match::Setup setup = setup_of(scene());
  for (auto& robot : setup.robots) robot.odometry.placing_noise = robot.odometry.placing_turn_noise = 0.0;
  const auto told = first_percepts(setup);
  for (const Side side : both_sides) {
    const double sign = side == Side::home ? 1.0 : -1.0;
    for (int number = 1; number <= 3; ++number) {
      const auto& wanted = player(*setup.opening, side, number);
      const First& first = told[index(side)][static_cast<std::size_t>(number - 1)];
      ASSERT_TRUE(first.placed);
      EXPECT_NEAR(first.placed->pose.x, sign * wanted.at[0], 1e-9);
      EXPECT_NEAR(first.placed->pose.y, sign * wanted.at[1], 1e-9);
      const double heading = config::heading(*setup.opening, wanted) + (side == Side::home ? 0.0 : pi);
      EXPECT_NEAR(std::remainder(first.placed->pose.heading - heading, 2.0 * pi), 0.0, 1e-9);
    }
  }
}

// Both sides of a scene that is its own reflection find themselves in the same place.
TEST(MatchFromAnOpening, ReflectedSceneIsTheSameSeenFromEitherSide) {
  config::Opening even = scene();
  even.ball = {};
  for (std::size_t i = 0; i < even.home.size(); ++i) {
    const config::Opening::Player& home = even.home[i];
    even.away[i].at = {-home.at[0], -home.at[1]};
    even.away[i].heading.reset();
    if (home.heading) even.away[i].heading = *home.heading + pi;
  }
  match::Setup setup = setup_of(even);
  for (auto& robot : setup.robots) robot.odometry.placing_noise = robot.odometry.placing_turn_noise = 0.0;
  const auto told = first_percepts(setup);
  for (std::size_t i = 0; i < 3; ++i) {
    const mind::Pose &home = told[0][i].placed->pose, &away = told[1][i].placed->pose;
    EXPECT_NEAR(home.x, away.x, 1e-9);
    EXPECT_NEAR(home.y, away.y, 1e-9);
    EXPECT_NEAR(std::remainder(home.heading - away.heading, 2.0 * pi), 0.0, 1e-9);
  }
}

TEST(MatchFromAnOpening, EndsAfterItsLengthOrAtTheLimit) {
  match::Setup setup = setup_of(scene());
  Result result = play(setup, chasers(3), chasers(3));
  EXPECT_EQ(result.ended, Ended::limit);
  EXPECT_DOUBLE_EQ(result.simulated_seconds, 12.0);
  EXPECT_NEAR(result.metrics.playing_seconds, 12.0, 0.11) << "in play from the first moment";
  setup.limit = 20.0;
  result = play(setup, chasers(3), chasers(3));
  EXPECT_DOUBLE_EQ(result.simulated_seconds, 20.0);
}

TEST(MatchFromAnOpening, SmallerTeamUsesTheFirstRobots) {
  const auto told = first_percepts([] {
    match::Setup setup = setup_of(scene(), 2);
    for (auto& robot : setup.robots) robot.odometry.placing_noise = 0.0;
    return setup;
  }());
  EXPECT_NEAR(told[0][1].placed->pose.x, 0.7, 1e-9);
  EXPECT_NEAR(told[1][1].placed->pose.x, -2.5, 1e-9);
}

TEST(MatchFromAnOpening, RefusesWhatCannotBePlayed) {
  const auto refusal = [](const match::Setup& setup) -> std::string {
    const std::size_t size = static_cast<std::size_t>(setup.rules.team_size);
    try {
      play(setup, statues(static_cast<int>(size)), statues(static_cast<int>(size)));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(setup_of(scene(), 7)), "opening scene: home has 3 places, a team has 7 robots");
  match::Setup small = setup_of(scene());
  small.rules.field.length = 6.0;
  EXPECT_THAT(refusal(small), testing::StartsWith("opening scene: home 1 at (-4, 0.1) is off the carpet"));
}

TEST(MatchFromAnOpening, IsAFunctionOfSceneAndSeed) {
  const auto hash = [](const config::Opening& opening, std::uint64_t seed = 1) {
    return play(setup_of(opening, 3, seed), chasers(3, 10), chasers(3, 10)).hash;
  };
  const std::uint64_t base = hash(scene());
  EXPECT_EQ(hash(scene()), base);
  EXPECT_NE(hash(scene(), 2), base);
  config::Opening other = scene();
  other.home[2].at[0] += 0.01;
  EXPECT_NE(hash(other), base);
  other = scene();
  other.away[1].heading = 2.01;
  EXPECT_NE(hash(other), base);
  other = scene();
  other.ball.velocity[1] += 0.01;
  EXPECT_NE(hash(other), base);
  other = scene();
  other.length += 1.0;
  EXPECT_NE(hash(other), base);
  other = scene();
  other.summary = "for people";
  EXPECT_EQ(hash(other), base);
}

// Nothing that a robot is told or sees at its first decision is the same for two seeds, though the scene is.
TEST(MatchFromAnOpening, LuckDiffersFromTheFirstMoment) {
  const auto one = first_percepts(setup_of(scene(), 3, 1)), two = first_percepts(setup_of(scene(), 3, 2));
  for (const Side side : both_sides) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NE(one[index(side)][i].placed->pose.x, two[index(side)][i].placed->pose.x);
    }
  }
}

TEST(MatchFromAnOpening, PhysicsCanBeReplayed) {
  PhysicsLog log;
  std::vector<BodyState> last;
  Observer observer;
  observer.physics_log = &log;
  observer.step = [&](const Snapshot& now) { last.assign(now.bodies.begin(), now.bodies.end()); };
  play(setup_of(scene()), chasers(3), chasers(3), &observer);
  PhysicsWorld replay(log.field, log.ball, log.robots);
  replay.replay(log);
  const auto states = replay.states();
  ASSERT_EQ(states.size(), last.size());
  for (std::size_t i = 0; i < last.size(); ++i) {
    EXPECT_EQ(states[i].x, last[i].x);
    EXPECT_EQ(states[i].y, last[i].y);
  }
}

}  // namespace
}  // namespace regista::match
