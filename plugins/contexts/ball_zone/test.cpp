// SPDX-License-Identifier: MIT
// The box by hand, and how often a noisy ball on its edge changes the answer.
#include <gtest/gtest.h>

#include <random>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using ball_zone::Box;
using ball_zone::Memory;

constexpr Box box{-1.0, 2.0, 0.0, 3.0};

TEST(BallZone, TheBoxIsClosed) {
  for (const auto& [x, y, inside] : {std::tuple(0.0, 1.0, true),
                                     {-1.0, 0.0, true},
                                     {2.0, 3.0, true},
                                     {-1.001, 1.0, false},
                                     {2.001, 1.0, false},
                                     {0.0, -0.001, false},
                                     {0.0, 3.001, false}}) {
    EXPECT_EQ(Memory().update(box, 0.5, true, x, y), inside) << x << ' ' << y;
  }
}

TEST(BallZone, EntersAtTheBoxAndLeavesBeyondTheBand) {
  Memory memory;
  EXPECT_FALSE(memory.update(box, 0.5, true, 2.4, 1.0));
  EXPECT_TRUE(memory.update(box, 0.5, true, 2.0, 1.0));
  EXPECT_TRUE(memory.update(box, 0.5, true, 2.5, 1.0));
  EXPECT_TRUE(memory.update(box, 0.5, true, 1.0, -0.5));
  EXPECT_FALSE(memory.update(box, 0.5, true, 1.0, -0.51));
  EXPECT_FALSE(memory.update(box, 0.5, true, 1.0, -0.1));
}

TEST(BallZone, AnUnknownBallIsNowhereAndEndsTheMemory) {
  Memory memory;
  ASSERT_TRUE(memory.update(box, 0.5, true, 0.0, 1.0));
  EXPECT_FALSE(memory.update(box, 0.5, false, 0.0, 1.0));
  EXPECT_FALSE(memory.update(box, 0.5, true, 2.2, 1.0));
  ASSERT_TRUE(memory.update(box, 0.5, true, 0.0, 1.0));
  memory.forget();
  EXPECT_FALSE(memory.update(box, 0.5, true, 2.2, 1.0));
}

TEST(BallZone, AnEmptyBoxHoldsNothing) {
  Memory memory;
  for (const double x : {-1.0, 0.0, 1.0}) EXPECT_FALSE(memory.update({1.0, -1.0, -9.0, 9.0}, 5.0, true, x, 0.0));
}

// Mirrored in y, box and ball alike, every answer is the same.
TEST(BallZone, MirrorsWithTheField) {
  std::mt19937 random(4);
  std::normal_distribution<double> step(0.0, 0.4);
  Memory memory, mirrored;
  double x = 0.0, y = 1.0;
  for (int tick = 0; tick < 10000; ++tick) {
    x = 0.98 * x + step(random);
    y = 0.98 * y + step(random);
    EXPECT_EQ(memory.update(box, 0.3, true, x, y),
              mirrored.update({box.x_least, box.x_most, -box.y_most, -box.y_least}, 0.3, true, x, -y));
  }
}

// A resting ball on the edge, seen with a deviation of 0.1 m: the band of three deviations leaves next to no change.
TEST(BallZone, TheBandStopsTheFlicker) {
  const auto changes = [](double band) {
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 0.1);
    Memory memory;
    bool before = false;
    int count = 0;
    for (int tick = 0; tick < 6000; ++tick) {
      const bool inside = memory.update({0.0, 100.0, -100.0, 100.0}, band, true, noise(random), 0.0);
      count += inside != before ? 1 : 0;
      before = inside;
    }
    return count;
  };
  EXPECT_GT(changes(0.0), 2500);  // every other decision
  EXPECT_LT(changes(0.3), 40);    // 6000 x P(z > 3) = 8 departures, each with its return
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

TEST(BallZonePlugin, AttackAndDefenceOfTheChosenWorld) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "ball_zone");
  Instance attack(plugin, EnvironmentBuilder{}, Values(plugin).set("x_least", 0.5));
  Instance defence(plugin, EnvironmentBuilder{}, Values(plugin).set("x_most", -0.5));
  const FrameBuilder frame =
      FrameBuilder{}.robot(2).ball(1.0, 2.0).common([](WorldBuilder& world) { world.ball(-1.0, 2.0); });
  const Scene mine = frame.build().before_tasks();
  EXPECT_EQ(attack.holds(mine), 1);
  EXPECT_EQ(defence.holds(mine), 0);
  const Scene common = FrameBuilder(frame).knowledge(REGISTA_COMMON).build().before_tasks();
  EXPECT_EQ(attack.holds(common), 0);
  EXPECT_EQ(defence.holds(common), 1);
}

REGISTA_CONTEXT_CONTRACT(REGISTA_PLUGIN_FILE, "ball_zone");

}  // namespace
