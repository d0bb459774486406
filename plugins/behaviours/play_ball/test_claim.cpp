// SPDX-License-Identifier: MIT
// Where a rolling ball is met, against one that rolls step by step; and who goes for the ball, among robots that
// believe the same.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <regista/testkit/dice.hpp>

#include "../claim.hpp"
#include "../test_situations.hpp"

namespace {

using namespace behaviours;

TEST(Meeting, ABallThatLiesIsMetWhereItLies) {
  const Meeting there = meeting(with_ball(standing(0, 0), {1.2, 0}), {0, 0});
  EXPECT_EQ(there.place, Vector2d(1.2, 0));
  EXPECT_NEAR(there.time, 4.0, 1e-12) << "a metre at 0.25 m/s until it touches";
  EXPECT_EQ(meeting(with_ball(standing(0, 0), {0.1, 0}), {0, 0}).time, 0.0);
}

// Truth: steps of a millisecond.
TEST(Meeting, AsOfABallThatRollsStepByStep) {
  regista::testkit::Dice dice(3);
  for (int round = 0; round < 200; ++round) {
    const Vector2d ball(dice.real(-3, 3), dice.real(-2, 2)), velocity(dice.real(-1.5, 1.5), dice.real(-1.5, 1.5));
    const Vector2d own(dice.real(-3, 3), dice.real(-2, 2));
    if (velocity.norm() < 0.06) continue;
    Vector2d at = ball;
    double time = 0.0, speed = velocity.norm();
    while ((at - own).norm() - 0.2 > 0.25 * time) {
      time += 1e-3;
      if (speed > 0.0) at += velocity.normalized() * (speed * 1e-3);
      speed -= 0.32e-3;
    }
    const Meeting found = meeting(with_ball(standing(own.x(), own.y()), ball, velocity), own);
    EXPECT_GE(found.time, time - 0.01) << "round " << round;
    EXPECT_LE(found.time, time + 0.21) << "it looks every 0.2 s";
  }
}

struct ClaimTest : testing::Test {
  ClaimSettings settings{.nearest_plays = true};
  Claim claim;
  // A robot at (x, 0), a ball at the centre, and a teammate at (mate, 0).
  bool plays(double x, double mate, bool by_role, double age = 0.0) {
    const std::vector<Teammate> teammates{{{mate, 0}, age, 3}};
    return claim.update(with_ball(standing(x, 0), {0, 0}), settings, teammates, by_role);
  }
};

TEST_F(ClaimTest, WithoutItTheRoleDecides) {
  settings.nearest_plays = false;
  EXPECT_FALSE(plays(-0.3, 3, false));
  EXPECT_TRUE(plays(-3, 0.3, true));
}

// 0.1 s are 0.025 m.
TEST_F(ClaimTest, WhoIsSurelyFirstTakesTheBall) {
  EXPECT_TRUE(plays(-1, 1.03, false));
  claim.forget();
  EXPECT_FALSE(plays(-1, 1.02, false));
  EXPECT_FALSE(plays(-1, 1.05, false, 3.0)) << "the teammate may have come 0.15 s nearer";
  EXPECT_TRUE(plays(-1, 1.05, false, 1.0));
}

TEST_F(ClaimTest, ItKeepsTheBallAsLongAsItIsFirst) {
  EXPECT_TRUE(plays(-1, 1.2, false));
  EXPECT_TRUE(plays(-1, 1.01, false));
  EXPECT_FALSE(plays(-1, 0.99, false));
  EXPECT_FALSE(plays(-1, 1.02, false)) << "and takes it again only when it is surely first";
}

// 0.5 s are 0.125 m.
TEST_F(ClaimTest, TheRobotOfTheRoleLeavesTheBallToWhoIsSurelyFirst) {
  EXPECT_TRUE(plays(-1, 0.88, true));
  EXPECT_FALSE(plays(-1, 0.87, true));
  EXPECT_FALSE(plays(-1, 0.99, true)) << "and does not come back for nothing";
  EXPECT_TRUE(plays(-1, 1.01, true));
  EXPECT_TRUE(plays(-1, 0.5, true, 3.1)) << "of whom there is no news";
}

// Its penalty area is 1.65 m long.
TEST_F(ClaimTest, TheGoalkeeperCountsInItsPenaltyArea) {
  const auto plays_beside_goalkeeper = [&](double ball) {
    claim.forget();
    const std::vector<Teammate> goalkeeper{{{ball - 0.3, 0}, 0.0, 1}};
    return claim.update(with_ball(standing(ball + 1, 0), {ball, 0}), settings, goalkeeper, true);
  };
  EXPECT_FALSE(plays_beside_goalkeeper(-2.9));
  EXPECT_TRUE(plays_beside_goalkeeper(-2.8)) << "it does not come so far out";
}

TEST_F(ClaimTest, ALostBallIsNobodys) {
  Situation lost = with_ball(standing(-0.3, 0), {0, 0});
  lost.ball_trusted = false;
  EXPECT_FALSE(claim.update(lost, settings, {}, false));
  EXPECT_TRUE(claim.update(lost, settings, {}, true)) << "its role looks for it";
}

TEST_F(ClaimTest, AloneItPlays) { EXPECT_TRUE(claim.update(with_ball(standing(-3, 0), {0, 0}), settings, {}, false)); }

// Whatever the scene: where all believe the same and news are fresh, somebody goes, and never more than the robot of
// the role and one other.
TEST(Claims, SomebodyGoesAndNotEverybody) {
  regista::testkit::Dice dice(11);
  int two = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<Vector2d> places;
    for (int i = 0; i < 6; ++i) places.emplace_back(dice.real(-4, 4), dice.real(-3, 3));
    const Vector2d ball(dice.real(-4, 4), dice.real(-3, 3)), velocity(dice.real(-1, 1), dice.real(-1, 1));
    int going = 0;
    for (std::size_t own = 0; own < places.size(); ++own) {
      std::vector<Teammate> others;
      for (std::size_t i = 0; i < places.size(); ++i) {
        if (i != own) others.push_back({places[i], 0.0, static_cast<int>(i) + 2});  // 1 is the goalkeeper
      }
      Claim claim;
      const Situation scene = with_ball(standing(places[own].x(), places[own].y()), ball, velocity);
      if (claim.update(scene, {.nearest_plays = true}, others, own == 0)) ++going;
    }
    EXPECT_GE(going, 1) << "round " << round;
    EXPECT_LE(going, 2) << "round " << round;
    if (going == 2) ++two;
  }
  EXPECT_LT(two, 50) << "only where two are as good as equally near";
}

TEST(Claims, WhoLeavesTheBallStandsBehindIt) {
  const Pose place = place_behind(with_ball(standing(1, 0), {0, 0}), 1.2);
  EXPECT_NEAR(place.x, -1.2, 1e-12);
  EXPECT_NEAR(place.y, 0.0, 1e-12);
  EXPECT_NEAR(place.heading, 0.0, 1e-12);
  EXPECT_NEAR(place_behind(with_ball(standing(1, 0), {-4, 0}), 1.2).x, -4.5, 1e-12) << "no farther than the goal";
  EXPECT_TRUE(std::isfinite(place_behind(with_ball(standing(1, 0), {-4.5, 0}), 1.2).heading));
}

// What people are told: 1.2 m from the ball is 4 s, 2.2 m is 8 s.
TEST_F(ClaimTest, SaysWhyItGoesOrDoesNot) {
  EXPECT_TRUE(plays(1.2, 2.2, false));
  EXPECT_EQ(claim.verdict().kind, ClaimVerdict::takes);
  EXPECT_EQ(claim.verdict().other, 3);
  EXPECT_NEAR(claim.verdict().own, 4.0, 1e-12);
  EXPECT_NEAR(claim.verdict().others, 8.0, 1e-12);
  EXPECT_FALSE(plays(2.2, 1.2, true));
  EXPECT_EQ(claim.verdict().kind, ClaimVerdict::leaves);
  EXPECT_EQ(claim.verdict().other, 3);
  EXPECT_FALSE(plays(2.2, 1.2, false));
  EXPECT_EQ(claim.verdict().kind, ClaimVerdict::by_role);
  claim.forget();
  EXPECT_EQ(claim.verdict().kind, ClaimVerdict::by_role);
}

}  // namespace
