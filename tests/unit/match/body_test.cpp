// SPDX-License-Identifier: MIT
// What becomes of commands, against the numbers of the profile.
#include "match/body.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "match/physics_world.hpp"
#include "process/sanitized.hpp"
#include "scripted.hpp"

namespace regista::match {
namespace {

config::Robot profile() {
  config::Robot robot;
  robot.kicks = scripted::three_kicks();
  return robot;
}

TEST(Walk, StaysOnTheEllipsoidOfLimits) {
  const config::Walk limits;
  const mind::Walk ahead = within_limits({9.0, 0.0, 0.0}, limits);
  EXPECT_DOUBLE_EQ(ahead.forward, 0.25);
  EXPECT_DOUBLE_EQ(within_limits({-9.0, 0.0, 0.0}, limits).forward, -0.20);
  EXPECT_DOUBLE_EQ(within_limits({0.0, -9.0, 0.0}, limits).sideways, -0.18);
  EXPECT_DOUBLE_EQ(within_limits({0.0, 0.0, 9.0}, limits).turn, limits.turn);
  const mind::Walk slow = within_limits({0.1, -0.05, 0.3}, limits);
  EXPECT_DOUBLE_EQ(slow.forward, 0.1);
  EXPECT_DOUBLE_EQ(slow.sideways, -0.05);
  EXPECT_DOUBLE_EQ(slow.turn, 0.3);
  for (double a = -1.0; a <= 1.0; a += 0.25) {
    for (double b = -1.0; b <= 1.0; b += 0.25) {
      const mind::Walk w = within_limits({a, b, 2.0 * a * b}, limits);
      const double forward = w.forward / (w.forward > 0.0 ? 0.25 : 0.20);
      EXPECT_LE(std::pow(forward, 2) + std::pow(w.sideways / 0.18, 2) + std::pow(w.turn / limits.turn, 2), 1.0 + 1e-12);
      EXPECT_NEAR(w.forward * b, w.sideways * a, 1e-12);  // same direction
    }
  }
}

TEST(Walk, ANewCommandTakesEffectAtTheNextStep) {
  const config::Robot robot = profile();
  Body body(robot, 0.32, 1, Side::home, 1);
  body.command({{0.2, 0.0, 0.0}, {}, 0.0}, 0.0, 1.0);
  EXPECT_DOUBLE_EQ(body.move(0.0, 0, 1.0).walk.forward, 0.2);
  std::uint32_t changed = 0;
  for (std::uint32_t tick = 1; tick <= 26; ++tick) {
    const double time = tick * physics_step;
    if (tick == 2) body.command({{0.1, 0.0, 0.0}, {}, 0.0}, time, 1.0);
    if (body.move(time, tick, 1.0).walk.forward == 0.1 && changed == 0) changed = tick;
  }
  EXPECT_NEAR(changed * physics_step, robot.walk.step_period, physics_step);
  EXPECT_GT(changed, 3u);
}

struct Shot {
  double time = -1.0;
  Vector velocity;
  int standing_steps = 0;
};

// A kick asked for at time 0 with the ball at `distance` at first and at `later` afterwards.
Shot kick(const config::Robot& robot, const mind::KickRequest& request, std::uint32_t begin, double distance,
          double later) {
  Body body(robot, 0.32, 1, Side::home, 1);
  mind::Command command;
  command.walk = {0.2, 0.0, 0.0};
  command.kick = request;
  body.command(command, begin * physics_step, distance);
  Shot shot;
  for (std::uint32_t tick = begin; tick < begin + 150; ++tick) {
    const Body::Motion motion = body.move(tick * physics_step, tick, later);
    if (body.kicking()) ++shot.standing_steps;
    if (body.kicking()) {
      EXPECT_EQ(motion.walk.forward, 0.0);
    }
    if (motion.ball_velocity) {
      EXPECT_LT(shot.time, 0.0) << "one kick hits once";
      shot.time = (tick - begin) * physics_step;
      shot.velocity = *motion.ball_velocity;
    }
  }
  return shot;
}

TEST(Kick, HitsAfterItsDelayAndStandsForItsDuration) {
  const config::Robot robot = profile();
  const Shot shot = kick(robot, {0, 0.0, 3.0}, 10, 0.2, 0.2);
  EXPECT_NEAR(shot.time, 0.65, physics_step);
  EXPECT_NEAR(shot.standing_steps * physics_step, 1.6, physics_step);
}

TEST(Kick, DoesNothingWithoutTheBallInReach) {
  const config::Robot robot = profile();
  const Shot never = kick(robot, {0, 0.0, 3.0}, 0, 0.23, 0.2);
  EXPECT_LT(never.time, 0.0);
  EXPECT_EQ(never.standing_steps, 0);
  const Shot missed = kick(robot, {0, 0.0, 3.0}, 0, 0.2, 0.4);  // the ball has gone meanwhile
  EXPECT_LT(missed.time, 0.0);
  EXPECT_GT(missed.standing_steps, 70);
}

class KickLaw : public testing::TestWithParam<std::pair<int, double>> {};

// Distance: triangular, so a relative standard deviation of half width / sqrt(6). Direction: normal.
TEST_P(KickLaw, HasTheProfilesMeanAndSpread) {
  const auto [kind, wanted] = GetParam();
  const config::Robot robot = profile();
  const config::Kick& law = robot.kicks[static_cast<std::size_t>(kind)];
  constexpr int count = 4000;
  double sum = 0.0, squares = 0.0, angles = 0.0, angle_squares = 0.0;
  for (int i = 0; i < count; ++i) {
    const Shot shot = kick(robot, {kind, 0.5, wanted}, static_cast<std::uint32_t>(200 * i), 0.2, 0.2);
    const double distance = squared_length(shot.velocity) / (2.0 * 0.32);
    const double angle = std::atan2(shot.velocity.y, shot.velocity.x) - 0.5;
    EXPECT_LE(std::fabs(distance / wanted - 1.0), law.distance_noise);
    sum += distance;
    squares += distance * distance;
    angles += angle;
    angle_squares += angle * angle;
  }
  const double mean = sum / count, deviation = std::sqrt(squares / count - mean * mean);
  EXPECT_NEAR(mean, wanted, 0.002 * wanted);
  EXPECT_NEAR(deviation, wanted * law.distance_noise / std::sqrt(6.0), 0.05 * wanted * law.distance_noise);
  EXPECT_NEAR(angles / count, 0.0, 0.01);
  EXPECT_NEAR(std::sqrt(angle_squares / count), law.direction_noise, 0.05 * law.direction_noise);
}
INSTANTIATE_TEST_SUITE_P(Kinds, KickLaw,
                         testing::Values(std::pair{0, 1.6}, std::pair{0, 4.5}, std::pair{1, 5.4}, std::pair{2, 0.7}));

TEST(Kick, IsClippedToItsRange) {
  config::Robot robot = profile();
  for (auto& law : robot.kicks) law.distance_noise = law.direction_noise = 0.0;
  EXPECT_NEAR(squared_length(kick(robot, {0, 0.0, 99.0}, 0, 0.2, 0.2).velocity) / 0.64, 4.5, 1e-9);
  EXPECT_NEAR(squared_length(kick(robot, {0, 0.0, 0.0}, 0, 0.2, 0.2).velocity) / 0.64, 1.6, 1e-9);
}

TEST(Fall, ComesAtItsRateAndEndsAfterGettingUp) {
  const config::Robot robot = profile();
  Body body(robot, 0.32, 1, Side::home, 1);
  constexpr std::uint32_t steps = sanitized ? 400000 : 4000000;
  double standing = 0.0, down = 0.0;
  mind::Command walk;
  walk.walk = {0.2, 0.0, 0.0};
  for (std::uint32_t tick = 0; tick < steps; ++tick) {
    const double time = tick * physics_step;
    if (body.fallen(time)) {
      down += physics_step;
      body.command(walk, time, 1.0);
      ASSERT_EQ(body.move(time, tick, 1.0).walk.forward, 0.0);
      ASSERT_LE(body.time_until_up(time), 5.0);
    } else {
      standing += physics_step;
      body.jostled(time, tick);
    }
  }
  const double expected = standing * robot.body.falls_per_contact_second;
  EXPECT_NEAR(body.falls(), expected, 5.0 * std::sqrt(expected));
  // Attempts follow a geometric law.
  const double fails = robot.body.get_up_failure, attempts = 1.0 / (1.0 - fails);
  EXPECT_NEAR(down / body.falls(), 5.0 * attempts, 4.0 * 5.0 * attempts * std::sqrt(fails / body.falls()) + 0.03);
}

TEST(Fall, ComesByItselfWhileWalkingAlone) {
  config::Robot robot = profile();
  robot.body.falls_per_walking_minute = 6.0;
  robot.body.get_up_failure = 0.0;
  double walking = 0.0;
  int falls = 0, early = 0;
  for (const std::uint64_t seed : {1u, 2u}) {
    Body body(robot, 0.32, seed, Side::away, 3);
    double since = 0.0;
    for (std::uint32_t tick = 0; tick < 2000000; ++tick) {
      const double time = tick * physics_step;
      const bool walks = tick / 500 % 2 == 0;  // 10 s of walking, 10 s of standing
      mind::Command command;
      if (walks) command.walk = {0.0, 0.0, 0.5};
      body.command(command, time, 1.0);
      const int before = body.falls();
      const bool moves = body.move(time, tick, 1.0).walk.turn != 0.0;
      if (body.falls() != before) {
        ++falls;
        early += since < 10.0 ? 1 : 0;
        since = 0.0;
      }
      if (moves) walking += physics_step, since += physics_step;
    }
  }
  const double expected = walking / 10.0, e = 1.0 - std::exp(-1.0);
  EXPECT_GT(falls, 2000);
  EXPECT_NEAR(falls, expected, 4.0 * std::sqrt(expected));
  EXPECT_NEAR(early / double(falls), e, 4.0 * std::sqrt(e * (1.0 - e) / falls)) << "as likely in each second";
}

TEST(Fall, AnAttemptToGetUpDoesNotKnowThatItWillFail) {
  config::Robot robot = profile();
  robot.body.get_up_failure = 0.5;
  robot.body.falls_per_contact_second = 10.0;
  Body body(robot, 0.32, 1, Side::home, 1);
  double longest = 0.0;
  for (std::uint32_t tick = 0, down = 0; tick < 400000; ++tick) {
    const double time = tick * physics_step;
    if (!body.fallen(time)) {
      down = 0;
      body.jostled(time, tick);
      continue;
    }
    const double lying = ++down * physics_step;
    longest = std::fmax(longest, lying);
    ASSERT_NEAR(std::remainder(body.time_until_up(time) + lying, 5.0), 0.0, 1e-6);
    ASSERT_LE(body.time_until_up(time), 5.0 + 1e-9);
    ASSERT_GT(body.time_until_up(time), 0.0);
  }
  EXPECT_GT(longest, 19.0);
}

TEST(Freeze, WhatLiesGetsUpOnlyAfterIt) {
  config::Robot robot = profile();
  robot.body.falls_per_contact_second = 50.0;
  robot.body.get_up_failure = 0.0;
  Body body(robot, 0.32, 1, Side::home, 1);
  mind::Command walk;
  walk.walk = {0.2, 0.0, 0.0};
  body.command(walk, 0.0, 1.0);
  EXPECT_GT(body.move(0.0, 0, 1.0).walk.forward, 0.0);
  body.freeze(0.02);
  EXPECT_EQ(body.move(0.02, 1, 1.0).walk.forward, 0.0);
  EXPECT_FALSE(body.fallen(0.02));
  body.jostled(1.0, 50);
  EXPECT_TRUE(body.fallen(1000.0));
  body.thaw(1000.0);
  EXPECT_NEAR(body.time_until_up(1000.0), 5.0, 1e-9);
  EXPECT_FALSE(body.fallen(1005.01));
}

}  // namespace
}  // namespace regista::match
