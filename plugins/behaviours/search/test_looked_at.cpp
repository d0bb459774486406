// SPDX-License-Identifier: MIT
// What was looked at, on a field of 9 m by 6 m: 24 squares of 1.5 m.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

#include "../gaze.hpp"
#include "../test_situations.hpp"

namespace {

using namespace behaviours;

constexpr LookedAtSettings settings{.divides = true};

Situation at(double x, double y, double heading, double time) {
  Situation out = standing(x, y, heading);
  out.time = time;
  return out;
}

struct LookedAtTest : testing::Test {
  LookedAt looked;
  LookedAtTest() { looked.begin({}); }
  Vector2d next(const Situation& situation, const std::vector<Vector2d>& others = {}) {
    return *looked.next(situation, settings, situation.frame.origin(), others);
  }
};

TEST_F(LookedAtTest, DividesTheFieldIntoSquares) {
  ASSERT_EQ(looked.squares(), 24u);
  EXPECT_NEAR((looked.centre(0) - Vector2d(-3.75, -2.25)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((looked.centre(23) - Vector2d(3.75, 2.25)).norm(), 0.0, 1e-12);
}

// The robot sees half a turn and a little to both sides, as far as 2.5 m: what lies behind it is still to be looked at.
TEST_F(LookedAtTest, GoesWhereItHasNotLooked) {
  const Situation ahead = at(0, 0, 0, 10);
  looked.see(ahead, settings);
  EXPECT_LT(next(ahead).x(), 0.0) << "behind its back, and near";
  looked.see(at(0, 0, pi, 11), settings);
  EXPECT_GT(next(at(0, 0, pi, 12)).norm(), settings.sight) << "beyond what it sees from here";
}

TEST_F(LookedAtTest, WhatATeammateLookedAtNeedNoSecondLook) {
  const Situation situation = at(0, 0, 0, 10);
  looked.see(situation, settings);
  const Vector2d first = next(situation);
  const std::vector<Teammate> there{{first, 0.5, 3}};
  looked.hear(situation, settings, there);
  EXPECT_GT((next(situation) - first).norm(), settings.sight);
}

// A look of 29 s ago still keeps the robot away; after half a minute it counts no more.
TEST_F(LookedAtTest, ALookGrowsOld) {
  const Situation situation = at(0, 0, 0, 100);
  looked.see(at(0, 0, pi, 99), settings);  // so that the squares ahead are nearest
  const Vector2d unseen = next(situation);
  const auto next_after = [&](double age) {
    looked.begin({});
    looked.see(at(0, 0, pi, 99), settings);
    looked.hear(situation, settings, std::vector<Teammate>{{unseen, age, 3}});
    return next(situation);
  };
  EXPECT_NE(next_after(5.0), unseen);
  EXPECT_EQ(next_after(30.0), unseen);
  EXPECT_EQ(next_after(40.0), unseen);
}

TEST_F(LookedAtTest, EverybodyHasSquaresOfItsOwn) {
  const std::vector<Vector2d> places{{-2.5, 1}, {-2.5, -1}, {2.5, 1}, {2.5, -1}};
  std::map<std::pair<double, double>, std::set<std::size_t>> seen;  // square -> who went there
  for (std::size_t robot = 0; robot < places.size(); ++robot) {
    std::vector<Vector2d> others = places;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(robot));
    LookedAt own;
    own.begin({});
    for (int step = 0; step < 40; ++step) {
      const Situation situation = at(places[robot].x(), places[robot].y(), 0, step);
      const Vector2d goal = *own.next(situation, settings, places[robot], others);
      for (const Vector2d& other : others) EXPECT_LE((goal - places[robot]).norm(), (goal - other).norm() + 1e-9);
      own.see(at(goal.x(), goal.y(), 0, step), settings);
      seen[{goal.x(), goal.y()}].insert(robot);
    }
  }
  EXPECT_GE(seen.size(), 8u) << "more than one square each";
  for (const auto& [square, robots] : seen) EXPECT_EQ(robots.size(), 1u) << square.first << ' ' << square.second;
  EXPECT_FALSE(looked.next(at(0, 0, 0, 0), settings, {99, 99}, std::vector<Vector2d>{{0, 0}}));
}

// One robot that walks 0.25 m/s from square to square has looked at the whole field within two minutes.
TEST_F(LookedAtTest, SeesTheWholeFieldInTime) {
  Vector2d place(0, 0);
  double heading = 0.0;
  std::set<std::size_t> unseen;
  for (std::size_t i = 0; i < looked.squares(); ++i) unseen.insert(i);
  for (double time = 0.0; time < 120.0; time += 0.5) {
    const Situation situation = at(place.x(), place.y(), heading, time);
    looked.see(situation, settings);
    for (std::size_t i = 0; i < looked.squares(); ++i) {
      const Vector2d there = situation.frame.to_robot(looked.centre(i));
      if (there.norm() < settings.sight && there.x() > 0.0) unseen.erase(i);
    }
    const Vector2d way = next(situation) - place;
    if (way.norm() < 0.13) continue;
    heading = angle_of(way);
    place += way.normalized() * 0.125;
  }
  EXPECT_TRUE(unseen.empty()) << unseen.size() << " squares were never looked at";
}

}  // namespace
