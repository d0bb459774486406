// SPDX-License-Identifier: MIT
// Which changes a table of wishes leads to: chains and circles by hand, and what must hold of any table.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "agreement.hpp"

namespace {

using role_exchange::Agreement, role_exchange::Holding, role_exchange::no_role;
using Table = std::vector<Holding>;
using Roles = std::vector<std::int32_t>;

// All utilities are 0 unless given: [robot][role].
Roles settled(Table table, const std::vector<std::vector<int>>& utilities = {}) {
  Agreement agreement;
  agreement.settle(table, [&](std::size_t robot, std::int32_t role) {
    return utilities.empty() ? 0 : utilities[robot][static_cast<std::size_t>(role)];
  });
  Roles out;
  for (const Holding& each : table) out.push_back(each.role);
  return out;
}

TEST(Agreement, NothingChangesWithoutTheHoldersWish) {
  EXPECT_EQ(settled({{0, 1}, {1, 1}}), (Roles{0, 1}));
  EXPECT_EQ(settled({{0, 1}, {1, 2}, {2, 2}}), (Roles{0, 1, 2}));  // the chain ends at one who stays
  EXPECT_EQ(settled({{no_role, 1}, {1, 1}}), (Roles{no_role, 1}));
}

TEST(Agreement, BothWish) { EXPECT_EQ(settled({{0, 1}, {1, 0}}), (Roles{1, 0})); }

TEST(Agreement, CirclesOfAnyLengthTurn) {
  EXPECT_EQ(settled({{0, 1}, {1, 2}, {2, 0}}), (Roles{1, 2, 0}));
  EXPECT_EQ(settled({{0, 2}, {1, 0}, {2, 1}}), (Roles{2, 0, 1}));
  EXPECT_EQ(settled({{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 0}}), (Roles{1, 2, 3, 4, 5, 6, 0}));
  EXPECT_EQ(settled({{0, 1}, {1, 0}, {2, 3}, {3, 2}, {4, 0}}), (Roles{1, 0, 3, 2, 4}));  // two at once; one waits
}

TEST(Agreement, AChainEndsInAFreeRole) {
  EXPECT_EQ(settled({{0, 1}, {1, 2}, {2, 7}}), (Roles{1, 2, 7}));
  EXPECT_EQ(settled({{no_role, 1}, {1, 2}}), (Roles{1, 2}));
}

TEST(Agreement, AChainEndsAtOneWhoWishesForNone) {
  EXPECT_EQ(settled({{0, 1}, {1, no_role}}), (Roles{1, no_role}));
  EXPECT_EQ(settled({{0, 0}, {1, no_role}}), (Roles{0, 1}));  // nobody wants it: it is kept
}

TEST(Agreement, TheLargestUtilityGetsAFreeRole) {
  EXPECT_EQ(settled({{0, 2}, {1, 2}}, {{0, 0, 5}, {0, 0, 6}}), (Roles{0, 2}));
  EXPECT_EQ(settled({{0, 2}, {1, 2}}, {{0, 0, 6}, {0, 0, 6}}), (Roles{2, 1}));  // equal: the lowest number
}

TEST(Agreement, TheLargestUtilityHoldsADoubleRole) {
  const Table table{{3, 3}, {3, 3}, {4, 3}};
  const auto utility = [](std::size_t robot, std::int32_t) { return robot == 1 ? 2 : 1; };
  EXPECT_EQ(Agreement::holder(table, 3, utility), 1u);
  EXPECT_EQ(Agreement::holder(table, 4, utility), 2u);
  EXPECT_EQ(Agreement::holder(table, 5, utility), Agreement::nobody);
}

// Random tables of robots with distinct roles.
TEST(Agreement, WhateverTheTable) {
  std::mt19937 random(5);
  Agreement agreement;
  int changes = 0;
  for (int round = 0; round < 20000; ++round) {
    const std::size_t robots = 1 + random() % 7, roles = robots + random() % 3;
    Roles deck;
    for (std::size_t k = 0; k < roles + 2; ++k) deck.push_back(k < roles ? static_cast<std::int32_t>(k) : no_role);
    std::shuffle(deck.begin(), deck.end(), random);
    Table before(robots);
    std::vector<std::vector<int>> utilities(robots, std::vector<int>(roles));
    for (std::size_t k = 0; k < robots; ++k) {
      before[k].role = deck[k];
      const auto draw = static_cast<std::int32_t>(random() % (roles + 1));
      before[k].wish = draw == static_cast<std::int32_t>(roles) ? no_role : draw;
      if (random() % 4 == 0) before[k].wish = before[k].role;
      for (int& each : utilities[k]) each = static_cast<int>(random() % 3);
    }
    const auto utility = [&](std::size_t robot, std::int32_t role) {
      return utilities[robot][static_cast<std::size_t>(role)];
    };
    Table after = before;
    agreement.settle(after, utility);
    for (std::size_t k = 0; k < robots; ++k) {
      ASSERT_EQ(after[k].wish, before[k].wish);
      if (after[k].role != before[k].role) {  // only by its own wish
        ASSERT_EQ(after[k].role, before[k].wish);
        ++changes;
      }
      if (before[k].wants_change() && before[k].wish != no_role) {
        // Who did not get what it wishes for was refused by a holder.
        ASSERT_NE(Agreement::holder(after, before[k].wish, utility), Agreement::nobody);
      }
      for (std::size_t other = 0; other < k; ++other) {
        ASSERT_TRUE(after[k].role == no_role || after[k].role != after[other].role) << "round " << round;
      }
    }
    Table again = after;
    agreement.settle(again, utility);
    for (std::size_t k = 0; k < robots; ++k) ASSERT_EQ(again[k].role, after[k].role);
  }
  EXPECT_GT(changes, 10000);
}

}  // namespace
