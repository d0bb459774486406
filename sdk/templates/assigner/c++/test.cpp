// SPDX-License-Identifier: MIT
// The algorithm alone.
#include <gtest/gtest.h>

#include <vector>

#include "algorithm.hpp"

namespace {

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

TEST(BestPairFirst, LeavesWhatIsNotWorthIt) {
  const double values[2][2] = {{0.9, 0.0}, {0.0, 0.2}};
  const auto value = [&](std::size_t row, std::size_t column) { return values[row][column]; };
  std::vector<std::int32_t> choice(2, -1);
  BestPairFirst().solve(2, 2, value, 0.5, choice);
  EXPECT_EQ(choice, (std::vector<std::int32_t>{0, -1}));
}

}  // namespace
