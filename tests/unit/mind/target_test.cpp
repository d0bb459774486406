// SPDX-License-Identifier: MIT
// Every rule and every anchor by numbers computed by hand. Field 9 x 6 m, goal 1.5 m, penalty mark 1.3 m from the line.
#include "mind/coordination/coordination.hpp"

#include <gtest/gtest.h>

namespace regista::mind {
namespace {

using config::Anchor;
using config::Place;

class Target : public testing::Test {
 protected:
  void ball(double x, double y, double vx = 0.0, double vy = 0.0) {
    world.ball_state.flags = REGISTA_BALL_KNOWN;
    world.ball_state.position[0] = x;
    world.ball_state.position[1] = y;
    world.ball_state.velocity[0] = vx;
    world.ball_state.velocity[1] = vy;
  }
  Vector2d at(Anchor anchor) const { return NamedPoints(field, 0.32, world).at({anchor, {1.25, -0.5}}); }
  Vector2d target() const { return target_of(rule, NamedPoints(field, 0.32, world)); }
  static Place point(double x, double y) { return {Anchor::point, {x, y}}; }
  static void expect(const Vector2d& got, double x, double y) {
    EXPECT_NEAR(got.x(), x, 1e-12);
    EXPECT_NEAR(got.y(), y, 1e-12);
  }

  config::FieldSize field;
  DistributedWorldModel world{7};
  config::TargetRule rule;
};

TEST_F(Target, NamedPoints) {
  ball(1.0, -2.0, 0.4, 0.0);
  expect(at(Anchor::ball), 1.0, -2.0);
  expect(at(Anchor::ball_rest), 1.25, -2.0);  // v^2 / 2a = 0.16 / 0.64
  expect(at(Anchor::own_goal), -4.5, 0.0);
  expect(at(Anchor::opponent_goal), 4.5, 0.0);
  expect(at(Anchor::own_left_post), -4.5, 0.75);
  expect(at(Anchor::own_right_post), -4.5, -0.75);
  expect(at(Anchor::centre), 0.0, 0.0);
  expect(at(Anchor::own_penalty_mark), -3.2, 0.0);
  expect(at(Anchor::opponent_penalty_mark), 3.2, 0.0);
  expect(at(Anchor::point), 1.25, -0.5);
}

TEST_F(Target, BallRestsAlongItsWayAndInsideTheField) {
  ball(0.0, 0.0, 0.6, 0.8);  // |v| = 1: 1.5625 m
  expect(at(Anchor::ball_rest), 0.9375, 1.25);
  ball(4.0, 2.5, 2.0, 2.0);
  expect(at(Anchor::ball_rest), 4.5, 3.0);
  ball(-4.0, 0.0, -3.0, 0.0);
  expect(at(Anchor::ball_rest), -4.5, 0.0);
}

TEST_F(Target, AtWithShift) {
  ball(2.0, 1.0);
  rule.at = Place{Anchor::ball, {}};
  expect(target(), 2.0, 1.0);
  rule.shift = {-1.0, 0.25};
  expect(target(), 1.0, 1.25);
}

TEST_F(Target, OnLineFromItsSecondEnd) {
  ball(-0.5, 3.0);  // 5 m from the own goal: (4, 3) / 5
  rule.on_line = config::TargetRule::OnLine{{Anchor::ball, {}}, {Anchor::own_goal, {}}, 0.5};
  expect(target(), -4.1, 0.3);
  rule.on_line->distance_from_to = 5.0;
  expect(target(), -0.5, 3.0);
  rule.on_line->distance_from_to = 6.0;  // the segment is shorter
  expect(target(), -0.5, 3.0);
  rule.on_line->distance_from_to = 0.0;
  expect(target(), -4.5, 0.0);
  ball(-4.5, 0.0);  // no segment at all
  expect(target(), -4.5, 0.0);
}

// Circle of radius 1 about (0, 0): the line from (5, 0.6) towards (-5, 0.6) enters it at (0.8, 0.6).
TEST_F(Target, OnCircleWhereTheLineEnters) {
  ball(5.0, 0.6);
  rule.on_circle = config::TargetRule::OnCircle{{Anchor::ball, {}}, point(-5.0, 0.6), {Anchor::centre, {}}, 1.0, 1.0};
  expect(target(), 0.8, 0.6);
  rule.on_circle->towards = point(3.0, 0.6);  // the line goes on beyond its second point
  expect(target(), 0.8, 0.6);
}

TEST_F(Target, OnCircleWithoutIntersectionIsTheNearestPoint) {
  ball(3.0, 4.0);
  rule.on_circle = config::TargetRule::OnCircle{{Anchor::ball, {}}, point(-5.0, 4.0), {Anchor::centre, {}}, 1.0, 1.0};
  expect(target(), 0.6, 0.8);  // passes it
  rule.on_circle->towards = point(6.0, 8.0);
  expect(target(), 0.6, 0.8);  // leads away
  ball(0.3, 0.4);
  expect(target(), 0.6, 0.8);  // from inside
  rule.on_circle->towards = {Anchor::ball, {}};
  ball(3.0, 4.0);
  expect(target(), 0.6, 0.8);  // no line at all
}

// Radius 0.8 to 1.3 while the ball is 1 to 8 m away: at 4.5 m half way, 1.05.
TEST_F(Target, CircleGrowsWithTheDistance) {
  rule.on_circle = config::TargetRule::OnCircle{{Anchor::ball, {}}, {Anchor::own_goal, {}}, {Anchor::own_goal, {}}};
  ball(0.0, 0.0);
  expect(target(), -3.45, 0.0);
  ball(4.0, 0.0);  // 8.5 m
  expect(target(), -3.2, 0.0);
  ball(-3.6, 0.0);  // 0.9 m
  expect(target(), -3.7, 0.0);
  ball(-4.5 + 0.5 * 3.0, 0.5 * 4.0);  // 2.5 m: 0.8 + 0.5 * 1.5 / 7
  const double radius = 0.8 + 0.5 * 1.5 / 7.0;
  expect(target(), -4.5 + 0.6 * radius, 0.8 * radius);
}

// The defender of the 2023 code: ball (0, 0) to the left post (-4.5, 0.75), circle about (-4.3, 0), radius r: t solves
// |t (-4.5, 0.75) - (-4.3, 0)| = r.
TEST_F(Target, DefenderOnTheLineToAPost) {
  ball(0.0, 0.0);
  rule.on_circle =
      config::TargetRule::OnCircle{{Anchor::ball, {}}, {Anchor::own_left_post, {}}, point(-4.3, 0.0), 1.0, 1.0};
  const Vector2d got = target();
  EXPECT_NEAR((got - Vector2d(-4.3, 0.0)).norm(), 1.0, 1e-12);
  EXPECT_NEAR(got.y() / got.x(), 0.75 / -4.5, 1e-12) << "on the line";
  const double a = 4.5 * 4.5 + 0.75 * 0.75, b = 4.5 * 4.3, c = 4.3 * 4.3 - 1.0;
  EXPECT_NEAR(got.x(), -4.5 * (b - std::sqrt(b * b - a * c)) / a, 1e-12) << "the first of the two";
}

// From inside the side of both counts: centre (0, 0), from (0.5, 0), towards (0, 2): (0.5, 2) / |(0.5, 2)|.
TEST_F(Target, FromInsideACircleRulesThatDifferDoNotMeet) {
  ball(0.5, 0.0);
  rule.on_circle = config::TargetRule::OnCircle{{Anchor::ball, {}}, point(0.0, 2.0), {Anchor::centre, {}}, 1.0, 1.0};
  expect(target(), 0.5 / std::sqrt(4.25), 2.0 / std::sqrt(4.25));
  rule.on_circle->towards = point(0.0, -2.0);
  expect(target(), 0.5 / std::sqrt(4.25), -2.0 / std::sqrt(4.25));
  rule.on_circle->towards = point(-0.5, 0.0);  // the sides cancel each other
  expect(target(), 1.0, 0.0);
}

TEST_F(Target, AcrossIsTheSideWhereTheBallIsNot) {
  rule.at = Place{Anchor::ball, {}};
  rule.shift = {0.7, 0.5};
  rule.lateral = 0.8;
  ball(1.0, 2.0);
  expect(target(), 1.7, -0.8);
  ball(1.0, -2.0);
  expect(target(), 1.7, 0.8);
  rule.lateral = -0.8;  // on the ball's side
  expect(target(), 1.7, -0.8);
  ball(1.0, 2.0);
  expect(target(), 1.7, 0.8);
}

TEST_F(Target, WithinClipsLast) {
  rule.at = Place{Anchor::ball, {}};
  rule.lateral = 2.8;
  rule.within = std::array<double, 4>{-4.0, 3.5, -2.5, 2.5};
  ball(4.2, -1.0);
  expect(target(), 3.5, 2.5);
  ball(-4.4, 1.0);
  expect(target(), -4.0, -2.5);
}

TEST_F(Target, WithoutBallHoldsWhileNobodyKnowsIt) {
  rule.on_circle = config::TargetRule::OnCircle{point(0, 0), {Anchor::ball, {}}, point(-3, 0), 1.0, 1.0};
  rule.without_ball = point(-3.0, 1.0);
  expect(target(), -3.0, 1.0);
  ball(-3.0, 0.0);
  expect(target(), -2.0, 0.0);
  world.ball_state.flags = 0;
  rule = {};
  rule.at = point(1.0, 1.0);
  rule.lateral = 0.5;
  expect(target(), 1.0, -0.5);  // no fallback given
  rule.without_ball = point(-2.0, 2.0);
  expect(target(), -2.0, 2.0);
}

}  // namespace
}  // namespace regista::mind
