// SPDX-License-Identifier: MIT
// The physical world against closed forms: rolling, bouncing, walking speed, and what must never happen.
#include "match/physics_world.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace regista::match {
namespace {

const config::FieldSize field;
const config::BallSize ball_size;

PhysicsWorld arena_with(int robots) {
  const std::vector<config::Body> bodies(static_cast<std::size_t>(robots));
  PhysicsWorld arena(field, ball_size, bodies);
  for (int id = 0; id < robots; ++id) arena.place(id, {-4.0 + 0.5 * id, 2.5, 0.0});
  return arena;
}

double speed(const BodyState& body) { return std::hypot(body.vx, body.vy); }

class Rolling : public testing::TestWithParam<double> {};

// v^2 / (2 a) within 2 %, and it comes to rest.
TEST_P(Rolling, GoesAsFarAsUniformDecelerationSays) {
  PhysicsWorld arena = arena_with(0);
  arena.place_ball({-4.0, 0.0});
  arena.kick({GetParam(), 0.0});
  for (int step = 0; step < 1000; ++step) arena.step();
  const double wanted = GetParam() * GetParam() / (2.0 * ball_size.rolling_deceleration);
  EXPECT_NEAR(arena.ball().x + 4.0, wanted, 0.02 * wanted);
  EXPECT_FLOAT_EQ(arena.ball().y, 0.0f);
  EXPECT_EQ(speed(arena.ball()), 0.0);
}
INSTANTIATE_TEST_SUITE_P(Speeds, Rolling, testing::Values(0.2, 0.5, 0.8, 0.98, 1.3, 1.64, 1.8));

TEST(PhysicsWorld, BallBouncesOffAPostAndARobot) {
  PhysicsWorld arena = arena_with(1);
  arena.place_ball({3.9, 0.8});
  arena.kick({1.5, 0.0});
  while (arena.ball().vx > 0.0f) {
    ASSERT_LT(arena.ball().x, 4.45);
    arena.step();
  }
  // A post stands for ever, so the speed comes back times the restitution; 0.5 m cost 2 a s.
  const double arrives = std::sqrt(1.5 * 1.5 - 2.0 * 0.32 * 0.5);
  EXPECT_NEAR(-arena.ball().vx, 0.5 * arrives, 0.03);

  arena.place(0, {0.0, 0.0, 0.0});
  arena.place_ball({-0.5, 0.0});
  arena.kick({1.5, 0.0});
  bool touched = false;
  for (int step = 0; step < 50; ++step) {
    arena.step();
    touched = touched || arena.contacts().hardest_on_ball == 0;
  }
  EXPECT_TRUE(touched);
  EXPECT_LT(arena.ball().vx, 0.0f);
}

TEST(PhysicsWorld, GoalNetAndBorderHoldTheBall) {
  PhysicsWorld arena = arena_with(0);
  arena.place_ball({3.0, 0.2});
  arena.kick({3.0, 0.3});
  for (int step = 0; step < 300; ++step) arena.step();
  EXPECT_GT(arena.ball().x, 4.5f);
  EXPECT_LT(arena.ball().x, 5.0f);
  EXPECT_LT(std::fabs(arena.ball().y), 0.8f);

  arena.place_ball({0.0, 2.0});
  arena.kick({0.5, 4.0});
  for (int step = 0; step < 300; ++step) {
    arena.step();
    ASSERT_LT(arena.ball().y, field.width / 2.0 + field.border_strip);
  }
}

TEST(PhysicsWorld, ReportsWhoTouchesWhom) {
  PhysicsWorld arena = arena_with(3);
  arena.place(0, {0.0, 0.0, 0.0});
  arena.place(1, {0.5, 0.0, 0.0});
  arena.place(2, {0.0, 2.0, 0.0});
  arena.place_ball({2.0, 0.0});
  bool met = false;
  for (int step = 0; step < 100; ++step) {
    arena.drive(0, {0.2, 0.0}, 0.0, 0.5, 6.0);
    arena.step();
    EXPECT_EQ(arena.contacts().robots_on_robots & 4u, 0u);
    EXPECT_EQ(arena.contacts().robots_on_ball, 0u);
    met = met || arena.contacts().robots_on_robots == 3u;
  }
  EXPECT_TRUE(met);
  EXPECT_GT(arena.robot(1).x, 0.5f);  // pushed
}

TEST(PhysicsWorld, ARobotReachesItsSpeedAtItsAcceleration) {
  PhysicsWorld arena = arena_with(1);
  arena.place(0, {0.0, 0.0, 0.0});
  arena.place_ball({0.0, 2.0});
  for (int step = 0; step < 10; ++step) {  // 0.2 s at 0.5 m/s^2
    arena.drive(0, {0.25, 0.0}, 1.5, 0.5, 6.0);
    arena.step();
  }
  EXPECT_NEAR(speed(arena.robot(0)), 0.1, 1e-4);
  EXPECT_NEAR(arena.robot(0).turn, 1.2, 1e-3);
  for (int step = 0; step < 40; ++step) {
    arena.drive(0, {0.25, 0.0}, 1.5, 0.5, 6.0);
    arena.step();
  }
  EXPECT_NEAR(speed(arena.robot(0)), 0.25, 1e-5);
  EXPECT_NEAR(arena.robot(0).turn, 1.5, 1e-4);
}

TEST(PhysicsWorld, RefusesWhatIsNotFiniteAndNamesTheBody) {
  PhysicsWorld arena = arena_with(2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto message = [](auto action) -> std::string {
    try {
      action();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(message([&] { arena.drive(1, {nan, 0.0}, 0.0, 0.5, 6.0); }), testing::HasSubstr("robot id 1"));
  EXPECT_THAT(message([&] { arena.place(0, {0.0, nan, 0.0}); }), testing::HasSubstr("robot id 0"));
  EXPECT_THAT(message([&] { arena.kick({0.0, 1.0 / 0.0}); }), testing::HasSubstr("ball"));
  EXPECT_THAT(message([&] { arena.place_ball({nan, 0.0}); }), testing::HasSubstr("ball"));
}

}  // namespace
}  // namespace regista::match
