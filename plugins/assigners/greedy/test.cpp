// SPDX-License-Identifier: MIT
// Cases by hand, and the definition of the greedy pairing checked on random matrices.
#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using greedy::forbidden;

std::vector<std::int32_t> assign(std::size_t rows, std::size_t columns, const std::vector<double>& values,
                                 std::vector<std::uint32_t> order = {}) {
  if (order.empty()) {
    order.resize(columns);
    std::iota(order.begin(), order.end(), 0u);
  }
  std::vector<std::int32_t> out(rows, -1);
  greedy::assign({values.data(), rows, columns, columns}, order, out);
  return out;
}

using Rows = std::vector<std::int32_t>;

TEST(Greedy, TheMoreImportantRoleChoosesFirst) {
  EXPECT_EQ(assign(2, 2, {0.9, 0.8, 0.5, 0.1}), (Rows{0, 1}));
  EXPECT_EQ(assign(2, 2, {0.9, 0.8, 0.5, 0.1}, {1, 0}), (Rows{1, 0}));
}

TEST(Greedy, TiesGoToTheLowestRobot) { EXPECT_EQ(assign(3, 3, std::vector<double>(9, 0.5)), (Rows{0, 1, 2})); }

TEST(Greedy, ForbiddenPairsAreLeftAlone) {
  EXPECT_EQ(assign(2, 2, {forbidden, forbidden, 0.0, forbidden}), (Rows{-1, 0}));
}

TEST(Greedy, MoreTasksThanRobotsAndFewer) {
  EXPECT_EQ(assign(1, 3, {0.1, 0.9, 0.5}), (Rows{0}));
  EXPECT_EQ(assign(3, 1, {0.1, 0.9, 0.5}), (Rows{-1, 0, -1}));
  EXPECT_EQ(assign(0, 3, {}), (Rows{}));
  EXPECT_EQ(assign(2, 0, {}, {}), (Rows{-1, -1}));
}

// What makes a pairing greedy: whoever would have liked column j better was taken by a more important one; a row is
// empty only if every column it may take is taken.
TEST(Greedy, DefinitionHoldsOnRandomMatrices) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> size(0, 7), small(-1, 4);
  for (int round = 0; round < 10000; ++round) {
    const auto rows = static_cast<std::size_t>(size(random)), columns = static_cast<std::size_t>(size(random));
    std::vector<double> values(rows * columns);
    for (double& value : values) {
      const int drawn = small(random);
      value = drawn < 0 ? forbidden : drawn;
    }
    std::vector<std::uint32_t> order(columns);
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<std::size_t> rank(columns);
    for (std::size_t k = 0; k < columns; ++k) rank[order[k]] = k;
    const Rows out = assign(rows, columns, values, order);
    std::vector<int> holder(columns, -1);
    for (std::size_t i = 0; i < rows; ++i) {
      if (out[i] < 0) continue;
      EXPECT_EQ(holder[static_cast<std::size_t>(out[i])], -1);
      holder[static_cast<std::size_t>(out[i])] = static_cast<int>(i);
    }
    for (std::size_t j = 0; j < columns; ++j) {
      for (std::size_t i = 0; i < rows; ++i) {
        const double value = values[i * columns + j];
        if (holder[j] == static_cast<int>(i)) {
          EXPECT_NE(value, forbidden);
          continue;
        }
        if (value == forbidden) continue;
        const bool was_taken = out[i] >= 0 && rank[static_cast<std::size_t>(out[i])] < rank[j];
        if (was_taken) continue;
        ASSERT_GE(holder[j], 0) << "column " << j << " is empty though row " << i << " was free";
        const auto winner = static_cast<std::size_t>(holder[j]);
        EXPECT_TRUE(values[winner * columns + j] > value || (values[winner * columns + j] == value && winner < i));
      }
    }
  }
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

TEST(GreedyPlugin, PriorityCountsNotTheOrderOfColumns) {
  Instance assigner(Loaded(REGISTA_PLUGIN_FILE, "greedy"), EnvironmentBuilder{}.own(2));
  const Scene scene =
      FrameBuilder{}.own(2).robot(2).robot(3).task("supporter").priority(5).task("striker").priority(1).build();
  Matrix utilities(2, 2);
  utilities(0, 0) = utilities(0, 1) = 0.9;
  utilities(1, 0) = utilities(1, 1) = 0.1;
  EXPECT_EQ(assigner.assign(scene, utilities), (Rows{1, 0}));
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "greedy");

}  // namespace
