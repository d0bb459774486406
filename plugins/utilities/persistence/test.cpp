// SPDX-License-Identifier: MIT
// The algorithm by hand.
#include <gtest/gtest.h>

#include <vector>

#include "algorithm.hpp"

namespace {

using persistence_utility::Holder;
using persistence_utility::no_role;

TEST(Persistence, GrowsToOneWhereTheRoleIsHeldAndNowhereElse) {
  const std::vector<Holder> rows{{7, 2.5}, {no_role, 99.0}, {3, 10.0}, {5, 1e6}, {42, 3.0}, {9, -1.0}};
  const std::vector<int> tasks{3, 5, 7, 9};
  std::vector<double> out(6 * 5, 0.0), expected(6 * 5, 0.0);
  persistence_utility::score(rows, tasks, 10.0, out.data(), 5);
  expected[0 * 5 + 2] = 0.25;
  expected[2 * 5 + 0] = 1.0;
  expected[3 * 5 + 1] = 1.0;
  EXPECT_EQ(out, expected);
}

TEST(Persistence, NothingToScore) {
  double nothing = -1.0;
  persistence_utility::score({}, {}, 10.0, &nothing, 0);
  EXPECT_EQ(nothing, -1.0);
}

}  // namespace
