// SPDX-License-Identifier: MIT
// Utilities as steps, the order of bids, and where robots and tasks stand in a decision.
#include "bids.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <regista/frame.hpp>
#include <regista/testkit/frame_builder.hpp>

namespace {

using namespace negotiation;
using regista::testkit::FrameBuilder;
using regista::testkit::Scene;

TEST(Bids, StepsAreTheNearestAndBounded) {
  EXPECT_EQ(in_steps(0.0, 0.01, 100), 0u);
  EXPECT_EQ(in_steps(0.504, 0.01, 100), 50u);
  EXPECT_EQ(in_steps(0.506, 0.01, 100), 51u);
  EXPECT_EQ(in_steps(0.125, 0.25, 100), 1u);  // halves go up
  EXPECT_EQ(in_steps(1e12, 0.01, 100), 100u);
  EXPECT_EQ(in_steps(1e12, 1e-6, 0xffffffffu), 0xffffffffu);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> utility(0.0, 2.0);
  for (int round = 0; round < 10000; ++round) {
    const double a = utility(random), b = utility(random);
    const std::uint32_t steps = in_steps(a, 0.001, 4000);
    ASSERT_LE(std::abs(0.001 * steps - a), 0.0005 + 1e-9);
    if (a <= b) {
      ASSERT_LE(steps, in_steps(b, 0.001, 4000));
    }
  }
}

// Of any two bids of different robots just one beats the other, and who beats the winner beats the loser.
TEST(Bids, AreInOneOrderForAll) {
  EXPECT_TRUE(beats(3, 7, 2, 1));
  EXPECT_TRUE(beats(3, 1, 3, 7));
  EXPECT_FALSE(beats(3, 7, 3, 7));
  for (int k = 0; k < 1000; ++k) {
    const std::uint32_t bids[]{static_cast<std::uint32_t>(k % 10), static_cast<std::uint32_t>(k / 10 % 10),
                               static_cast<std::uint32_t>(k / 100)};
    const auto over = [&](int a, int b) { return beats(bids[a], a, bids[b], b); };
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      EXPECT_NE(over(a, b), over(b, a));
      EXPECT_TRUE(!over(a, b) || !over(b, c) || over(a, c));
    }
  }
}

TEST(Bids, RowsAndColumns) {
  FrameBuilder builder;
  builder.own(2).robot(2).robot(4).penalised().robot(5).task("supporter").task("striker");
  const Scene scene = builder.build();
  const regista::Frame frame(scene.raw());
  const auto active = frame.world().active();
  EXPECT_EQ(row_of(active, 2), 0u);
  EXPECT_EQ(row_of(active, 5), 1u);
  EXPECT_EQ(row_of(active, 4), 2u);  // it does not play
  EXPECT_EQ(row_of(active, 7), 2u);
  const auto tasks = frame.tasks();
  EXPECT_EQ(column_of(tasks, tasks[0].id), 0u);
  EXPECT_EQ(column_of(tasks, tasks[1].id), 1u);
  EXPECT_EQ(column_of(tasks, -1), 2u);
}

}  // namespace
