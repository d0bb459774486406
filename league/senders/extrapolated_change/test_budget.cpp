// SPDX-License-Identifier: MIT
// Whole matches of a team: what is left of the budget, second by second.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "algorithm.hpp"

namespace {

using namespace extrapolated_change;

// Robots of the algorithm alone, with the budget as the plugin reads it.
struct Team {
  int robots = 7;
  Allowance allowance;
  std::vector<Sender> senders{7};
  std::vector<double> sent{std::vector<double>(7, -100.0)};
  double left = 1200.0, team_sent = -100.0, line_at_packet = 0.0, time = 0.0;
  double least_above_line = 1e9;

  // What a robot has to tell at this decision.
  using Life = std::function<void(int robot, Situation& now)>;

  // One decision of all robots, at the same moment: nobody knows of the packets of this one.
  void step(const Clock& clock, const Life& life) {
    const double known_left = left, line = allowance.line(share_left(allowance, clock));
    double spent = 0.0;
    for (int robot = 0; robot < robots; ++robot) {
      Situation now;
      now.time = time;
      now.number = robot + 1;
      now.since_own = time - sent[static_cast<std::size_t>(robot)];
      now.allowance = allowance;
      now.purse = {.left = known_left,
                   .line = line,
                   .line_before = line_at_packet,
                   .reserve = half_reserve(allowance, clock.half),
                   .half_left = clock.half_left,
                   .silent = time - team_sent,
                   .robots = robots,
                   .turn = 0.1 * ((robot + 1 + static_cast<int>(known_left)) % robots)};
      life(robot, now);
      if (!senders[static_cast<std::size_t>(robot)].decide({}, now)) continue;
      sent[static_cast<std::size_t>(robot)] = time;
      spent += 1.0;
    }
    if (spent > 0.0) {
      team_sent = time;
      line_at_packet = line;
    }
    left -= spent;
    least_above_line = std::min(least_above_line, left - line);
    time += 0.1;
  }
  // Ready and Set, in which the clock stands, then a half.
  void half(int number, const Life& life) {
    for (int tick = 0; tick < 500; ++tick) step({number, 600.0}, life);
    for (int tick = 0; tick < 6000; ++tick) step({number, 600.0 - 0.1 * tick}, life);
  }
};

TEST(Budget, AllWantToSendAlways) {
  Team team;
  const Team::Life want = [](int, Situation& now) { now.urgent_offer = true; };
  team.half(1, want);
  EXPECT_GE(team.left, 615.0);
  EXPECT_LE(team.left, 625.0);
  team.half(2, want);
  EXPECT_GE(team.left, 30.0);
  EXPECT_LE(team.left, 40.0);
  // Seven packets at most go out at once when one is left above the line. The line of the second half begins lower.
  EXPECT_GE(team.least_above_line, -30.0);
}

// Without the seconds before the kick-off, in which the clock stands, nobody falls below the line by more than the
// packets of one moment.
TEST(Budget, InPlayTheLineHolds) {
  Team team;
  const Team::Life want = [](int, Situation& now) { now.urgent_offer = true; };
  for (int tick = 0; tick < 6000; ++tick) team.step({1, 600.0 - 0.1 * tick}, want);
  EXPECT_GE(team.least_above_line, -7.0);
  EXPECT_GE(team.left, 615.0);
}

TEST(Budget, RandomWishes) {
  std::mt19937 random(5);
  for (int match = 0; match < 12; ++match) {
    Team team;
    const auto rarity = 1u + random() % 60u;
    const Team::Life life = [&](int, Situation& now) { now.urgent_offer = random() % rarity == 0; };
    team.half(1, life);
    ASSERT_GE(team.left, 615.0) << rarity;
    team.half(2, life);
    ASSERT_GE(team.left, 30.0) << rarity;
  }
}

// Whistles are sent beyond the line, down to 15.
TEST(Budget, WhistlesToo) {
  std::mt19937 random(6);
  Team team;
  const Team::Life life = [&](int, Situation& now) {
    now.urgent_offer = true;
    now.heard_whistle = static_cast<int>(now.time * 10.0 + 0.5) % 100 == 0;  // one every 10 s
  };
  team.half(1, life);
  team.half(2, life);
  EXPECT_LT(team.left, 30.0);
  EXPECT_GE(team.left, 15.0 - 6.0);  // all seven at once with 16 left
}

// Robots that walk about at random, and a ball that they see or not: what a match may be like.
TEST(Budget, RandomMotion) {
  std::mt19937 random(7);
  for (int match = 0; match < 3; ++match) {
    Team team;
    struct Robot {
      Point place, target;
      double ball_age = 0.0;
      int role = 0;
      std::optional<int> told;
    };
    std::vector<Robot> robots(7);
    std::vector<Point> mates;  // of the robot that decides
    const auto anywhere = [&] {
      return Point{-4.5 + 9.0 * static_cast<double>(random() % 1000) / 1000.0,
                   -3.0 + 6.0 * static_cast<double>(random() % 1000) / 1000.0};
    };
    const Team::Life life = [&](int k, Situation& now) {
      Robot& r = robots[static_cast<std::size_t>(k)];
      if (random() % 100 == 0) r.target = anywhere();
      if (random() % 150 == 0) r.role = static_cast<int>(random() % 7);
      if (random() % 80 == 0) r.ball_age = random() % 2 == 0 ? 0.0 : 5.0;
      const double dx = r.target.x - r.place.x, dy = r.target.y - r.place.y, way = std::hypot(dx, dy);
      if (way > 0.025) r.place = {r.place.x + 0.025 * dx / way, r.place.y + 0.025 * dy / way};
      mates.clear();
      for (const Robot& each : robots) {
        if (&each != &r) mates.push_back(each.place);
      }
      now.place = r.place;
      now.speed = way > 0.025 ? 0.25 : 0.0;
      now.knows_ball = true;
      now.ball_age = r.ball_age;
      now.role = r.role;
      if (team.sent[static_cast<std::size_t>(k)] == team.time - 0.1) r.told = r.role;
      now.told_role = r.told ? r.told : std::optional<int>(r.role);
      now.told_target = r.target;
      now.mates = mates;
    };
    team.half(1, life);
    ASSERT_GE(team.left, 615.0);
    team.half(2, life);
    ASSERT_GE(team.left, 30.0);
    ASSERT_LT(team.left, 300.0);  // it does spend
  }
}

}  // namespace
