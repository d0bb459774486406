// SPDX-License-Identifier: MIT
// Distances between targets on triangles of known sides.
#include "match/metrics_coordination.hpp"

#include <gtest/gtest.h>

namespace regista::match {
namespace {

constexpr std::uint32_t everybody = 0b111;

struct Targets : testing::Test {
  TargetMeasures measures{3};
  void sample(int times, std::uint32_t active = everybody) {
    for (int i = 0; i < times; ++i) measures.sample(active);
  }
};

TEST_F(Targets, WithoutTwoThereIsNoDistance) {
  sample(2);
  measures.decided(1, Vector{1.0, 1.0});
  sample(2);
  EXPECT_EQ(measures.result().mean_metres, std::nullopt);
  EXPECT_EQ(measures.result().least_metres, std::nullopt);
}

TEST_F(Targets, MeanOverPairsAndLeastOverSamples) {
  measures.decided(1, Vector{0.0, 0.0});
  measures.decided(2, Vector{3.0, 0.0});
  measures.decided(3, Vector{3.0, 4.0});
  sample(10);
  EXPECT_DOUBLE_EQ(*measures.result().mean_metres, 4.0) << "3, 4 and 5 m";
  EXPECT_DOUBLE_EQ(*measures.result().least_metres, 3.0);
  // Ten pairs of 5 m beside thirty of 4 m: each pair counts the same; of the least, each sample.
  sample(10, 0b101);
  EXPECT_DOUBLE_EQ(*measures.result().mean_metres, (30 * 4.0 + 10 * 5.0) / 40.0);
  EXPECT_DOUBLE_EQ(*measures.result().least_metres, 4.0);
  // Who has no task has no target.
  measures.decided(3, std::nullopt);
  sample(20);
  EXPECT_DOUBLE_EQ(*measures.result().mean_metres, (30 * 4.0 + 10 * 5.0 + 20 * 3.0) / 60.0);
  EXPECT_DOUBLE_EQ(*measures.result().least_metres, (10 * 3.0 + 10 * 5.0 + 20 * 3.0) / 40.0);
}

TEST_F(Targets, TwoOfTheSameRoleMayHaveTheSame) {
  measures.decided(1, Vector{1.0, 2.0});
  measures.decided(2, Vector{1.0, 2.0});
  sample(1);
  EXPECT_EQ(measures.result().mean_metres, 0.0);
  EXPECT_EQ(measures.result().least_metres, 0.0);
}

}  // namespace
}  // namespace regista::match
