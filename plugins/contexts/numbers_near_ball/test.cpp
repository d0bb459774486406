// SPDX-License-Identifier: MIT
// Counts by hand and by brute force.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using numbers_near_ball::Body;
using numbers_near_ball::Near;

TEST(NumbersNearBall, TheCircleIsClosed) {
  const std::vector<Body> robots{{1, 1.0, 1.0}, {2, 4.0, 5.0}, {3, 4.0, 5.001}, {4, -4.0, 1.0}};  // 3, 4, 5
  EXPECT_EQ(Near().update({1.0, 1.0}, robots, 5.0, 1.0), 3);
  EXPECT_EQ(Near().update({1.0, 1.0}, robots, 0.0, 1.0), 1);
  EXPECT_EQ(Near().update({1.0, 1.0}, {}, 5.0, 1.0), 0);
}

// Without a margin it is a plain count, whatever was before; with one it lies between the counts of both circles; and a
// field mirrored in y counts alike.
TEST(NumbersNearBall, AgainstBruteForce) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> anywhere(-3.0, 3.0);
  std::normal_distribution<double> step(0.0, 0.2);
  Near plain, kept, mirrored;
  std::vector<Body> robots, mirror;
  for (int label = 0; label < 11; ++label) robots.push_back({label, anywhere(random), anywhere(random)});
  int more_than_plain = 0;
  for (int tick = 0; tick < 3000; ++tick) {
    mirror.clear();
    for (Body& robot : robots) {
      robot.x = 0.98 * robot.x + step(random);
      robot.y = 0.98 * robot.y + step(random);
      mirror.push_back({robot.label, robot.x, -robot.y});
    }
    const auto within = [&](double radius) {
      return static_cast<int>(std::ranges::count_if(
          robots, [&](const Body& robot) { return std::hypot(robot.x - 0.3, robot.y - 0.2) <= radius; }));
    };
    EXPECT_EQ(plain.update({0.3, 0.2}, robots, 1.5, 0.0), within(1.5));
    const int count = kept.update({0.3, 0.2}, robots, 1.5, 0.3);
    EXPECT_GE(count, within(1.5));
    EXPECT_LE(count, within(1.8));
    EXPECT_EQ(mirrored.update({0.3, -0.2}, mirror, 1.5, 0.3), count);
    more_than_plain += count > within(1.5) ? 1 : 0;
  }
  EXPECT_GT(more_than_plain, 100);
}

TEST(NumbersNearBall, EachRobotHasItsOwnMemory) {
  Near near;
  const auto update = [&](double one, double two) {
    return near.update({0.0, 0.0}, std::vector<Body>{{7, one, 0.0}, {9, two, 0.0}}, 1.5, 0.5);
  };
  EXPECT_EQ(update(1.4, 1.9), 1);
  EXPECT_EQ(update(1.9, 1.9), 1);  // 7 stays, 9 does not enter
  EXPECT_EQ(update(1.9, 1.4), 2);
  EXPECT_EQ(update(2.1, 1.9), 1);
  EXPECT_EQ(update(1.9, 1.9), 1);  // 7 has left
  near.forget();
  EXPECT_EQ(update(1.9, 1.9), 0);
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

// The difference that the contexts of one number each agree on; 99 when none holds.
int difference(const FrameBuilder& frame) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "numbers_near_ball");
  int found = 99;
  for (int value = -12; value <= 12; ++value) {
    Instance context(plugin, EnvironmentBuilder{}, Values(plugin).set("least", value).set("most", value));
    if (context.holds(frame.build().before_tasks()) == 0) continue;
    EXPECT_EQ(found, 99) << "two numbers at once";
    found = value;
  }
  return found;
}

TEST(NumbersNearBallPlugin, OwnMinusOpponents) {
  const FrameBuilder ball = FrameBuilder{}.ball(1, 1);
  EXPECT_EQ(difference(ball), 0);
  EXPECT_EQ(difference(FrameBuilder(ball).robot(1).at(1, 2).robot(5).at(1, 0).robot(6).at(3, 1)), 2);
  EXPECT_EQ(difference(FrameBuilder(ball).robot(1).at(1, 2).opponent(1, 1).opponent(2, 1).opponent(0, 1)), -2);
  EXPECT_EQ(difference(FrameBuilder(ball).robot(1).at(1, 2).no_ball()), 99);
}

TEST(NumbersNearBallPlugin, WhoDoesNotCount) {
  const FrameBuilder ball = FrameBuilder{}.ball(1, 1);
  EXPECT_EQ(difference(FrameBuilder(ball).robot(1).at(1, 1).penalised().robot(2).at(1, 1).fallen(2.0)), 0);
  EXPECT_EQ(difference(FrameBuilder(ball).opponent(1, 1).weight(0.4).opponent(1, 2).weight(0.6)), -1);
}

TEST(NumbersNearBallPlugin, TheChosenWorld) {
  const FrameBuilder frame =
      FrameBuilder{}.robot(3).at(1, 1).ball(1, 1).common([](WorldBuilder& world) { world.ball(-3, 1); });
  EXPECT_EQ(difference(frame), 1);
  EXPECT_EQ(difference(FrameBuilder(frame).knowledge(REGISTA_COMMON)), 0);
}

REGISTA_CONTEXT_CONTRACT(REGISTA_PLUGIN_FILE, "numbers_near_ball");

}  // namespace
