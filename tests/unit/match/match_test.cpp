// SPDX-License-Identifier: MIT
// Whole matches: determinism, the independence of luck, invariants that hold in every step.
#include "match/match.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "match/physics_world.hpp"
#include "scripted.hpp"

namespace regista::match {
namespace {

using scripted::chasers;
using scripted::setup;
using scripted::statues;

Result short_match(std::uint64_t seed, int team_size = 7, double limit = 120.0) {
  match::Setup s = setup(seed, team_size);
  s.limit = limit;
  return play(s, chasers(team_size, 20), chasers(team_size, 20));
}

TEST(Match, SameInputsSameCourseOtherSeedOtherCourse) {
  const Result first = short_match(5);
  EXPECT_EQ(first.hash, short_match(5).hash);
  EXPECT_NE(first.hash, short_match(6).hash);
  EXPECT_EQ(first.ended, Ended::limit);
  EXPECT_DOUBLE_EQ(first.simulated_seconds, 120.0);
  EXPECT_EQ(hash_text(0x12ab), "00000000000012ab");
}

class TeamSizes : public testing::TestWithParam<int> {};

TEST_P(TeamSizes, PlayWholeMatches) {
  match::Setup s = setup(2, GetParam());
  s.rules.durations.half = 60.0;
  const Result result = play(s, chasers(GetParam()), chasers(GetParam()));
  EXPECT_EQ(result.ended, Ended::full_time);
  EXPECT_NEAR(result.simulated_seconds, 2 * (1.0 + 45.0 + 5.0 + 60.0), 0.2);
  EXPECT_GT(result.metrics.teams[0].touches + result.metrics.teams[1].touches, 0);
}
INSTANTIATE_TEST_SUITE_P(All, TeamSizes, testing::Values(1, 2, 3, 5, 7, 11, 15));

// What must hold after every physics step of a match of chasers that all run for the ball.
TEST(Match, InvariantsHoldThroughout) {
  match::Setup s = setup(3);
  const config::FieldSize& field = s.rules.field;
  const double x = field.length / 2.0 + field.border_strip, y = field.width / 2.0 + field.border_strip;
  const Roster roster{s.rules.team_size};
  std::vector<std::string> broken;
  double deepest = 0.0, away_from_border = 1e9;
  int goals = 0, kick_offs_since_goal = 1, packets_left = s.rules.messages.budget;
  bool playing = false;
  std::set<EventKind> kinds;
  Observer observer;
  observer.event = [&](double, const Event& event, const GameState&) {
    kinds.insert(event.kind);
    if (event.kind == EventKind::kick_off) ++kick_offs_since_goal;
    if (event.kind == EventKind::goal) {
      ++goals;
      if (kick_offs_since_goal == 0) broken.push_back("two goals without a kick-off");
      kick_offs_since_goal = 0;
    }
  };
  observer.step = [&](const Snapshot& now) {
    playing = playing || now.state.in_play();
    for (const BodyState& body : now.bodies) {
      for (const float value : {body.x, body.y, body.heading, body.cosine, body.sine, body.vx, body.vy, body.turn}) {
        if (!std::isfinite(value)) broken.push_back("not finite");
      }
    }
    const BodyState& ball = now.bodies.back();
    away_from_border = std::fmin(away_from_border, std::fmin(x - std::fabs(ball.x), y - std::fabs(ball.y)));
    for (int a = 0; a < roster.count(); ++a) {
      for (int b = 0; b < a; ++b) {
        const BodyState &p = now.bodies[static_cast<std::size_t>(a)], &q = now.bodies[static_cast<std::size_t>(b)];
        deepest = std::fmax(deepest, 0.30 - std::hypot(p.x - q.x, p.y - q.y));
      }
    }
    for (const Side side : both_sides) {
      if (now.state.packets_left[index(side)] < 0) broken.push_back("negative budget");
      if (now.state.score(side) < 0) broken.push_back("negative score");
    }
    if (now.state.packets_left[0] > packets_left) broken.push_back("the budget grew");
    packets_left = now.state.packets_left[0];
  };
  const Result result = play(s, chasers(7, 100, true), chasers(7, 100, true), &observer);
  EXPECT_THAT(broken, testing::IsEmpty());
  EXPECT_LE(deepest, 0.005 + 0.01) << "Box2D's slop and one centimetre";
  EXPECT_GT(away_from_border, 0.0);
  EXPECT_TRUE(playing);
  EXPECT_EQ(goals, result.score[0] + result.score[1]);
  EXPECT_EQ(result.packets[0], s.rules.messages.budget - packets_left);
  // Without these the invariants would have held of an empty field.
  EXPECT_GT(goals, 0);
  EXPECT_GT(result.metrics.in_play_seconds, 300.0);
  for (const EventKind kind : {EventKind::kick_in, EventKind::goal_kick, EventKind::penalty, EventKind::returned}) {
    EXPECT_TRUE(kinds.contains(kind)) << name(kind);
  }
}

// All that home robots saw and heard, as text, in a match of statues against `away`.
std::string luck_of_home(const Setup& s, const std::vector<mind::Think>& home, const std::vector<mind::Think>& away) {
  std::string record;
  Observer observer;
  observer.decision = [&record](const Decision& decision) {
    if (decision.side != Side::home) return;
    const auto add = [&record](double value) {
      char bytes[sizeof value];
      std::memcpy(bytes, &value, sizeof value);
      record.append(bytes, sizeof value);
    };
    if (decision.percepts.placed) add(decision.percepts.placed->pose.x);
    for (const auto& mark : decision.percepts.landmarks) add(mark.position.x());
    add(decision.percepts.whistle);
    for (const auto& packet : decision.heard) add(packet.time_heard);
  };
  play(s, home, away, &observer);
  return record;
}

// Away minds that turn on the spot, look about and send, against ones that do nothing.
TEST(Match, OtherAwayMindsLeaveTheLuckOfHomeAlone) {
  match::Setup s = setup(9);
  s.limit = 100.0;
  const auto sending = chasers(7, 20);
  std::vector<mind::Think> home = statues(7);
  home[3] = [](const mind::Percepts&, std::span<const mind::HeardPacket>, mind::Outcome& out) {
    out.send = true;
    out.packet.assign(10, 1);
  };
  std::vector<mind::Think> busy(
      7, [n = 0](const mind::Percepts&, std::span<const mind::HeardPacket>, mind::Outcome& out) mutable {
        out.command.walk.turn = 1.0;
        out.command.head_yaw = std::sin(0.1 * ++n);
        out.send = n % 7 == 0;
        out.packet.assign(20, 7);
      });
  const std::string quiet = luck_of_home(s, home, statues(7));
  EXPECT_GT(quiet.size(), 10000u);
  EXPECT_EQ(quiet, luck_of_home(s, home, busy));
}

// Whichever minds play for home, home's robots are put down with the same errors and hear the same whistles.
TEST(Match, LuckStaysWithTheSideWhenTeamsSwap) {
  match::Setup s = setup(9);
  s.limit = 52.0;  // a kick-off's whistle, and no goal's
  const auto record = [&s](const std::vector<mind::Think>& home, const std::vector<mind::Think>& away) {
    std::vector<double> luck;
    Observer observer;
    observer.decision = [&luck](const Decision& d) {
      if (d.side == Side::home && d.percepts.placed && d.time < 1.0) luck.push_back(d.percepts.placed->pose.x);
      if (d.side == Side::home && d.percepts.whistle) luck.push_back(d.number);
    };
    play(s, home, away, &observer);
    return luck;
  };
  const auto first = record(chasers(7), statues(7)), swapped = record(statues(7), chasers(7));
  EXPECT_GT(first.size(), 10u);
  EXPECT_EQ(first, swapped);
}

TEST(Match, EveryRobotDecidesAtItsRateAtItsOwnTime) {
  match::Setup s = setup(1);
  s.limit = 10.0;
  s.robots[1].decision_period = 0.2;
  std::array<std::vector<double>, 14> times;
  Observer observer;
  observer.decision = [&times](const Decision& d) {
    times[static_cast<std::size_t>(Roster{7}.id(d.side, d.number))].push_back(d.time);
  };
  play(s, statues(7), statues(7), &observer);
  std::set<double> phases;
  for (std::size_t id = 0; id < 14; ++id) {
    const double period = id < 7 ? 0.1 : 0.2;
    ASSERT_EQ(times[id].size(), static_cast<std::size_t>(std::lround(10.0 / period)));
    for (std::size_t i = 1; i < times[id].size(); ++i) ASSERT_NEAR(times[id][i] - times[id][i - 1], period, 1e-9);
    phases.insert(std::round(times[id][0] * 100.0));
  }
  EXPECT_GE(phases.size(), 5u);
}

TEST(Match, AwaySeesTheFieldFromItsOwnSide) {
  match::Setup s = setup(1);
  s.rules.durations.half = 20.0;
  std::array<std::vector<double>, 2> placed;
  Observer observer;
  observer.decision = [&placed](const Decision& d) {
    if (d.number == 1 && d.percepts.placed) placed[index(d.side)].push_back(d.percepts.placed->pose.x);
  };
  play(s, statues(7), statues(7), &observer);
  for (const auto& side : placed) {
    ASSERT_GE(side.size(), 2u);  // at the beginning of both halves
    for (const double x : side) EXPECT_LT(x, -3.0) << "always the own half";
  }
}

TEST(Match, PenalisedRobotsHearAndKnowButDoNotSee) {
  match::Setup s = setup(1, 3);
  s.limit = 110.0;
  s.rules.penalties.removal = 20.0;
  // Away 3 walks into the circle, drawn large enough to be near, before the kick-off is taken.
  std::vector<mind::Think> away = statues(3);
  away[2] = [](const mind::Percepts& p, std::span<const mind::HeardPacket>, mind::Outcome& out) {
    if (p.game.phase != mind::Phase::playing) return;
    out.command.walk = {0.25, 0.0, 0.0};
  };
  int decisions = 0, seen = 0, removed = 0, returned = 0;
  Observer observer;
  observer.decision = [&](const Decision& d) {
    if (!d.percepts.penalised) return;
    ++decisions;
    EXPECT_FALSE(d.percepts.camera);
    EXPECT_NE(d.percepts.game.own_penalised, 0u);
    seen += static_cast<int>(d.percepts.robots.size() + d.percepts.balls.size() + d.percepts.landmarks.size());
  };
  observer.event = [&](double, const Event& event, const GameState&) {
    removed += event.kind == EventKind::penalty ? 1 : 0;
    returned += event.kind == EventKind::returned ? 1 : 0;
  };
  s.rules.field.centre_circle_diameter = 5.9;
  s.robots[1].hearing.whistle_probability = 1.0;
  play(s, statues(3), away, &observer);
  EXPECT_GT(removed, 0);
  EXPECT_GT(returned, 0);
  EXPECT_GT(decisions, 150);
  EXPECT_EQ(seen, 0);
}

TEST(Match, TheBarePhysicsOfARecordingEndsInTheSameState) {
  match::Setup s = setup(4);
  s.limit = 200.0;
  PhysicsLog log;
  std::vector<BodyState> last;
  Observer observer;
  observer.physics_log = &log;
  observer.step = [&last](const Snapshot& now) { last.assign(now.bodies.begin(), now.bodies.end()); };
  const Result result = play(s, chasers(7), chasers(7), &observer);
  ASSERT_EQ(log.step_ends.size(), static_cast<std::size_t>(std::lround(result.simulated_seconds * 50.0)));
  PhysicsWorld replay(log.field, log.ball, log.robots);
  replay.replay(log);
  ASSERT_EQ(replay.states().size(), last.size());
  for (std::size_t i = 0; i < last.size(); ++i) {
    EXPECT_EQ(replay.states()[i].x, last[i].x) << i;
    EXPECT_EQ(replay.states()[i].y, last[i].y) << i;
    EXPECT_EQ(replay.states()[i].heading, last[i].heading) << i;
  }
}

TEST(Match, AnObserverChangesNothing) {
  match::Setup s = setup(8);
  s.limit = 80.0;
  PhysicsLog log;
  int seconds = 0;
  Observer observer;
  observer.physics_log = &log;
  observer.second = [&seconds](double time, const GameState&) { EXPECT_NEAR(time, ++seconds, 1e-9); };
  EXPECT_EQ(play(s, chasers(7), chasers(7), &observer).hash, play(s, chasers(7), chasers(7)).hash);
  EXPECT_EQ(seconds, 80);
}

std::string complaint(const Setup& s, const mind::Think& bad) {
  auto home = statues(s.rules.team_size);
  home[2] = bad;
  try {
    play(s, home, statues(s.rules.team_size));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Match, RefusesUnsoundOutcomesAndNamesTheRobot) {
  match::Setup s = setup(1);
  s.limit = 1.0;
  using Heard = std::span<const mind::HeardPacket>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using testing::AllOf;
  using testing::HasSubstr;
  EXPECT_THAT(complaint(s, [nan](auto&, Heard, mind::Outcome& out) { out.command.walk.turn = nan; }),
              AllOf(HasSubstr("home robot 3"), HasSubstr("walk")));
  EXPECT_THAT(complaint(s, [nan](auto&, Heard, mind::Outcome& out) { out.command.head_yaw = nan; }), HasSubstr("head"));
  EXPECT_THAT(complaint(s,
                        [](auto&, Heard, mind::Outcome& out) {
                          out.command.kick = mind::KickRequest{3, 0.0, 1.0};
                        }),
              HasSubstr("kick 3, but the profile 'nao' has 3"));
  EXPECT_THAT(complaint(s, [](auto&, Heard, mind::Outcome& out) { out.role = 0; }), HasSubstr("role 0"));
  EXPECT_THAT(complaint(s,
                        [](auto&, Heard, mind::Outcome& out) {
                          out.assignment = {-2, -1, 0};
                        }),
              HasSubstr("role 0 for robot 3, but the table of roles has 0"));
  EXPECT_THAT(complaint(s, [](auto&, Heard, mind::Outcome& out) { out.kept = {0}; }), HasSubstr("task 0"));
  s.roles[0] = {{.name = "striker"}};
  EXPECT_THAT(complaint(s, [](auto&, Heard, mind::Outcome& out) { out.kept = {0, -1}; }), HasSubstr("task -1"));
  EXPECT_THAT(complaint(s,
                        [](auto&, Heard, mind::Outcome& out) {
                          out.kept = {0, 1};
                        }),
              HasSubstr("task 1, but the table of roles has 1"));
  EXPECT_THAT(complaint(s,
                        [nan](auto&, Heard, mind::Outcome& out) {
                          out.target = mind::Target{0.0, nan};
                        }),
              HasSubstr("target"));
  EXPECT_THAT(complaint(s,
                        [](auto&, Heard, mind::Outcome& out) {
                          out.send = true;
                          out.send_reason = 99;
                        }),
              HasSubstr("99"));
}

TEST(Match, WhatAMindThrowsPassesThrough) {
  match::Setup s = setup(1);
  EXPECT_THAT(complaint(s,
                        [](const mind::Percepts& p, std::span<const mind::HeardPacket>, mind::Outcome&) {
                          if (p.time > 3.0) throw std::runtime_error("plugin says no");
                        }),
              testing::StrEq("plugin says no"));
}

TEST(Match, RefusesSetupsThatCannotBePlayed) {
  match::Setup s = setup(1);
  EXPECT_THROW(play(s, statues(6), statues(7)), std::invalid_argument);
  s.robots[0].decision_period = 0.05;
  EXPECT_THROW(play(s, statues(7), statues(7)), std::invalid_argument);
  s = setup(1, largest_team + 1);
  EXPECT_THROW(play(s, statues(largest_team + 1), statues(largest_team + 1)), std::invalid_argument);
}

// The budget is spent by a mind that never stops talking.
TEST(Match, ATalkativeTeamLosesItsGoals) {
  match::Setup s = setup(3);
  s.rules.messages.budget = 100;
  s.limit = 400.0;
  bool sanctioned = false;
  Observer observer;
  observer.event = [&sanctioned](double, const Event& event, const GameState&) {
    sanctioned = sanctioned || (event.kind == EventKind::too_many_packets && event.side == Side::home);
  };
  const Result result = play(s, chasers(7, 1), chasers(7), &observer);
  EXPECT_TRUE(sanctioned);
  EXPECT_EQ(result.score[0], 0);
  EXPECT_GT(result.packets[0], 100);
  const std::vector<int>& by_reason = result.metrics.teams[0].packets_by_reason;
  EXPECT_EQ(std::accumulate(by_reason.begin(), by_reason.end(), 0), result.packets[0]);
  EXPECT_EQ(result.packets[1], 0);
}

}  // namespace
}  // namespace regista::match
