// SPDX-License-Identifier: MIT
// Walking around others: a point that follows way_around() keeps its distance and arrives; velocities stay within what
// the walk can do.
#include <gtest/gtest.h>

#include <random>

#include "mind/body/walking.hpp"

namespace regista::mind {
namespace {

struct Walked {
  bool arrived = false;
  double least_share = 1e9;  // of an obstacle's radius
};

Walked walk(Vector2d at, const Vector2d& to, const std::vector<Obstacle>& obstacles) {
  Walked out;
  for (int step = 0; step < 3000; ++step) {
    for (const Obstacle& each : obstacles) {
      out.least_share = std::min(out.least_share, (each.position - at).norm() / each.radius);
    }
    if ((to - at).norm() < 0.08) {
      out.arrived = true;
      return out;
    }
    const Vector2d way = way_around(at, to, obstacles) - at;
    at += way * std::min(1.0, 0.025 / std::max(way.norm(), 1e-12));  // 0.25 m/s at 10 Hz
  }
  return out;
}

TEST(WayAround, FreeWaysAreStraight) {
  const std::vector<Obstacle> obstacles{{{1.0, 0.5}, 0.42}, {{-1.0, 0.0}, 0.42}, {{5.0, 0.0}, 0.42}};
  EXPECT_EQ(way_around({0, 0}, {3.0, 0.0}, obstacles), Vector2d(3.0, 0.0));
  EXPECT_EQ(way_around({0, 0}, {0, 0}, obstacles), Vector2d(0, 0));
}

TEST(WayAround, PassesOnTheShorterSide) {
  EXPECT_LT(way_around({0, 0}, {3, 0}, std::vector<Obstacle>{{{1.0, 0.1}, 0.42}}).y(), 0.0);
  EXPECT_GT(way_around({0, 0}, {3, 0}, std::vector<Obstacle>{{{1.0, -0.1}, 0.42}}).y(), 0.0);
}

TEST(WayAround, TheNearestObstacleCounts) {
  const Obstacle near{{0.8, 0.1}, 0.42}, far{{1.1, -0.3}, 0.42};
  EXPECT_EQ(way_around({0, 0}, {3, 0}, std::vector{near, far}), way_around({0, 0}, {3, 0}, std::vector{near}));
  EXPECT_EQ(way_around({0, 0}, {3, 0}, std::vector{far, near}), way_around({0, 0}, {3, 0}, std::vector{near}));
}

constexpr double torsos = 0.30;  // m between two centres when the bodies touch

// The point aimed at is 1.1 radii beside the obstacle, so the way to it cuts the circle a little.
TEST(WayAround, AWalkAroundOneNeverTouchesAndArrives) {
  std::mt19937_64 engine(1);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
  for (int round = 0; round < 2000; ++round) {
    const double x = in(1.3, 3.0), y = in(-0.41, 0.41);
    const std::vector<Obstacle> obstacles{{{x, y}, 0.42}};
    const Walked walked = walk({0, 0}, {x + in(0.6, 2.0), 0.0}, obstacles);
    EXPECT_TRUE(walked.arrived) << "obstacle at " << x << ", " << y;
    EXPECT_GT(0.42 * walked.least_share, torsos) << "obstacle at " << x << ", " << y;
  }
}

TEST(WalkTo, StaysWithinWhatTheWalkCanDo) {
  std::mt19937_64 engine(2);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
  const config::Rules rules;
  const config::Robot robot;
  const DistributedWorldModel world(7);
  for (int round = 0; round < 2000; ++round) {
    const double x = in(-4, 4), y = in(-3, 3), heading = in(-pi, pi);
    const Pose pose{x, y, heading};
    const Body body{rules, robot, world, 1, pose, Frame2(pose), {}};
    const double reach = round % 2 == 0 ? 4.0 : 0.1;
    const double tx = x + in(-reach, reach), ty = y + in(-reach, reach), th = in(-pi, pi);
    const Walk walk = walk_to(body, {tx, ty, th}, {}, round % 3 == 0);
    const double along = walk.forward >= 0.0 ? robot.walk.forward : robot.walk.backward;
    EXPECT_LE(std::hypot(walk.forward / along, walk.sideways / robot.walk.sideways), 1.0 + 1e-9);
    EXPECT_LE(std::abs(walk.turn), robot.walk.turn);
    EXPECT_TRUE(std::isfinite(walk.forward + walk.sideways + walk.turn));
  }
}

// Whoever is near is never pushed: no speed towards one that is within the radius, and away from one that is too close.
TEST(WalkTo, NeverPushes) {
  std::mt19937_64 engine(4);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
  const config::Rules rules;
  const config::Robot robot;
  const DistributedWorldModel world(7);
  for (int round = 0; round < 2000; ++round) {
    const Pose pose{0.0, 0.0, in(-pi, pi)};
    const Body body{rules, robot, world, 1, pose, Frame2(pose), {}};
    const double distance = in(0.2, 0.6), angle = in(-pi, pi);
    const Vector2d towards(std::cos(angle), std::sin(angle));
    const std::vector<Obstacle> obstacles{{towards * distance, 0.42}};
    const double reach = round % 2 == 0 ? 3.0 : 0.05;
    const double tx = in(-reach, reach), ty = in(-reach, reach), th = in(-pi, pi);
    const Walk walk = walk_to(body, {tx, ty, th}, obstacles, round % 3 == 0);
    const double speed = body.frame.direction_to_field({walk.forward, walk.sideways}).dot(towards);
    if (distance < 0.42) {
      EXPECT_LE(speed, 1e-9) << round;
    }
    if (distance < 0.36) {
      EXPECT_LT(speed, -0.01) << round;
    }
  }
}

// The body does what it is told; it arrives at place and heading from anywhere.
TEST(WalkTo, Arrives) {
  std::mt19937_64 engine(3);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
  const config::Rules rules;
  const config::Robot robot;
  const DistributedWorldModel world(7);
  for (int round = 0; round < 200; ++round) {
    const double x = in(-4, 4), y = in(-3, 3), heading = in(-pi, pi), tx = in(-4, 4), ty = in(-3, 3), th = in(-pi, pi);
    Pose pose{x, y, heading};
    for (int step = 0; step < 600; ++step) {
      const Body body{rules, robot, world, 1, pose, Frame2(pose), {}};
      const Walk walk = walk_to(body, {tx, ty, th}, {});
      const Vector2d moved = body.frame.to_field({0.1 * walk.forward, 0.1 * walk.sideways});
      pose = {moved.x(), moved.y(), wrap(pose.heading + 0.1 * walk.turn)};
    }
    EXPECT_LT(std::hypot(pose.x - tx, pose.y - ty), 0.1) << round;
    EXPECT_LT(std::abs(wrap(pose.heading - th)), 0.11) << round;
  }
}

}  // namespace
}  // namespace regista::mind
