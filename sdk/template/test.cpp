// SPDX-License-Identifier: MIT
// The algorithm alone, the plugin in a scene, and the contract that every assigner keeps.
#include <gtest/gtest.h>

#include <vector>

#include <regista/testkit/contract.hpp>

#include "algorithm.hpp"

// A robot may stay idle: pairs below `at_least` are not taken.
REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "best_pair_first", {.may_idle = true});

namespace {

using namespace regista::testkit;

TEST(BestPairFirst, TakesTheHighestValueAndThenTheHighestThatIsLeft) {
  const double values[2][2] = {{0.8, 0.9}, {0.1, 0.7}};
  const auto value = [&](std::size_t row, std::size_t column) { return values[row][column]; };
  std::vector<std::int32_t> choice(2, -1);
  BestPairFirst().solve(2, 2, value, 0.0, choice);
  EXPECT_EQ(choice, (std::vector<std::int32_t>{1, 0}));
}

TEST(BestPairFirst, LeavesAForbiddenPair) {
  const auto value = [](std::size_t, std::size_t) { return BestPairFirst::forbidden; };
  std::vector<std::int32_t> choice(3, -1);
  BestPairFirst().solve(3, 2, value, 0.0, choice);
  EXPECT_EQ(choice, (std::vector<std::int32_t>{-1, -1, -1}));
}

TEST(Plugin, LeavesWhatIsNotWorthIt) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "best_pair_first");
  const Scene scene =
      FrameBuilder{}.own(2).robot(2).at(-1, 0).robot(5).at(2, 1).task("striker").task("supporter").build();
  Matrix utilities(scene.rows(), scene.columns());
  utilities(0, 0) = 0.9;
  utilities(1, 1) = 0.2;
  Instance choosy(plugin, EnvironmentBuilder{}.own(2), Values(plugin).set("at_least", 0.5));
  EXPECT_EQ(choosy.assign(scene, utilities), (std::vector<std::int32_t>{0, REGISTA_NO_TASK}));
}

}  // namespace
