// SPDX-License-Identifier: MIT
// What is done with a map that fits, and with one that does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "../negotiation/follow_map.hpp"

namespace {

using scram::away, scram::idle, scram::no_column;
using Numbers = std::vector<std::int32_t>;
using Order = std::vector<std::uint32_t>;

Order in_sequence(std::size_t count) {
  Order order(count);
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

// Tasks by importance.
Numbers follow(const Numbers& map, const Numbers& numbers, const Numbers& ids, const auto& may) {
  const Order order = in_sequence(ids.size());
  Numbers out(numbers.size());
  scram::Follower().follow(map, {numbers, ids, order}, may, out);
  return out;
}
Numbers follow(const Numbers& map, const Numbers& numbers, const Numbers& ids) {
  return follow(map, numbers, ids, [](std::size_t, std::size_t) { return true; });
}

TEST(FollowMap, WhatFitsIsDone) {
  EXPECT_EQ(follow({7, 5, 6}, {1, 2, 3}, {5, 6, 7}), (Numbers{2, 0, 1}));
  EXPECT_EQ(follow({7, away, 6}, {1, 3}, {5, 6, 7}), (Numbers{2, 1}));
  EXPECT_EQ(follow({idle, 5, 6}, {1, 2, 3}, {5, 6}), (Numbers{no_column, 0, 1}));
  EXPECT_EQ(follow({}, {}, {}), (Numbers{}));
}

TEST(FollowMap, RobotsWithoutATaskTakeTheMostImportantOpenOnes) {
  EXPECT_EQ(follow({idle, 6, idle}, {1, 2, 3}, {5, 6, 7}), (Numbers{0, 1, 2}));
  EXPECT_EQ(follow({idle, 6, idle}, {1, 2, 3}, {6, 7}), (Numbers{1, 0, no_column}));
  // Robot 1 has left, and what it had is open; robot 2 is new.
  EXPECT_EQ(follow({5, away, 6}, {2, 3}, {5, 6}), (Numbers{0, 1}));
}

TEST(FollowMap, WhoHasAnUnknownTaskComesLast) {
  EXPECT_EQ(follow({9, idle, 6}, {1, 2, 3}, {5, 6, 7}), (Numbers{2, 0, 1}));
  EXPECT_EQ(follow({9, idle, 6}, {1, 2, 3}, {5, 6}), (Numbers{no_column, 0, 1}));
}

TEST(FollowMap, WhoMustNotDoItsTaskLooksForAnother) {
  const auto not_first_to_first = [](std::size_t row, std::size_t column) { return row != 0 || column != 0; };
  EXPECT_EQ(follow({5, 6}, {1, 2}, {5, 6, 7}, not_first_to_first), (Numbers{2, 1}));
  EXPECT_EQ(follow({5, idle}, {1, 2}, {5, 6}, not_first_to_first), (Numbers{1, 0}));
}

// By the head of the file, rule by rule, for all that can come.
TEST(FollowMap, NoTaskTwiceNothingForbiddenNobodyWithoutNeed) {
  std::mt19937 random(4);
  int fitting = 0, recovered = 0;
  for (int round = 0; round < 10000; ++round) {
    const std::size_t team = 1 + random() % 11, roles = 1 + random() % 15;
    Numbers pool(roles), numbers, map(team, idle);
    std::iota(pool.begin(), pool.end(), 0);
    std::shuffle(pool.begin(), pool.end(), random);
    const bool fits = round % 4 == 0;
    for (std::size_t robot = 0; robot < team; ++robot) {
      if (robot < roles && random() % 5 != 0) map[robot] = pool[robot];
      if (fits || random() % 5 != 0) numbers.push_back(static_cast<std::int32_t>(robot + 1));
      if (!fits && random() % 8 == 0) map[robot] = away;
    }
    Numbers ids;
    for (const std::int32_t id : pool) {
      const bool wanted = std::find(map.begin(), map.end(), id) != map.end();
      if (fits ? wanted : random() % 4 != 0) ids.push_back(id);
    }
    Order order = in_sequence(ids.size());
    std::shuffle(order.begin(), order.end(), random);
    std::vector<bool> forbidden(numbers.size() * ids.size());
    for (std::size_t pair = 0; pair < forbidden.size(); ++pair) forbidden[pair] = !fits && random() % 10 == 0;
    const auto may = [&](std::size_t row, std::size_t column) { return !forbidden[row * ids.size() + column]; };
    Numbers out(numbers.size());
    scram::Follower().follow(map, {numbers, ids, order}, may, out);
    const auto taken = [&](std::size_t column) {
      return std::count(out.begin(), out.end(), static_cast<std::int32_t>(column));
    };
    for (std::size_t row = 0; row < out.size(); ++row) {
      const std::int32_t given = map[static_cast<std::size_t>(numbers[row] - 1)];
      const auto known = std::find(ids.begin(), ids.end(), given);
      const auto column = static_cast<std::size_t>(known - ids.begin());
      if (known != ids.end() && may(row, column)) {
        ASSERT_EQ(out[row], static_cast<std::int32_t>(column));
        ++fitting;
      } else if (out[row] == no_column) {
        for (std::size_t open = 0; open < ids.size(); ++open) ASSERT_TRUE(taken(open) > 0 || !may(row, open));
      } else {
        ASSERT_TRUE(may(row, static_cast<std::size_t>(out[row])));
        ++recovered;
      }
      if (fits) {
        ASSERT_EQ(out[row] == no_column, given == idle);
      }
    }
    for (std::size_t column = 0; column < ids.size(); ++column) ASSERT_LE(taken(column), 1);
  }
  EXPECT_GT(fitting, 10000);
  EXPECT_GT(recovered, 5000);
}

// One robot knows a task less than the others. Whoever made the map: no task is done twice, and nobody stands idle
// while there is a task that it knows and nobody does.
TEST(FollowMap, ARobotThatKnowsLessIsInNobodysWay) {
  std::mt19937 random(5);
  int not_done = 0;
  for (int round = 0; round < 10000; ++round) {
    const std::size_t n = 2 + random() % 9;
    Numbers numbers(n), ids(n), map(n);
    std::iota(numbers.begin(), numbers.end(), 1);
    std::iota(ids.begin(), ids.end(), 0);
    map = ids;
    std::shuffle(map.begin(), map.end(), random);
    const std::int32_t unknown = static_cast<std::int32_t>(random() % n);
    const std::size_t knows_less = random() % n;
    if (round % 2 == 0) std::replace(map.begin(), map.end(), unknown, idle);  // its own map
    Numbers fewer = ids;
    std::erase(fewer, unknown);
    const Numbers whole = follow(map, numbers, ids), part = follow(map, numbers, fewer);
    std::vector<int> done(n, 0);
    for (std::size_t row = 0; row < n; ++row) {
      const std::int32_t column = row == knows_less ? part[row] : whole[row];
      if (column == no_column) continue;
      ++done[static_cast<std::size_t>(row == knows_less ? fewer[static_cast<std::size_t>(column)] : column)];
    }
    for (std::size_t task = 0; task < n; ++task) {
      ASSERT_LE(done[task], 1);
      if (done[task] == 0) {
        ASSERT_EQ(static_cast<std::int32_t>(task), unknown);
        ++not_done;
      }
    }
  }
  EXPECT_GT(not_done, 500);  // the price: the robot that is to do it does not know it
}

TEST(Maps, MembersAndTasksTellWhatAMapIsFor) {
  EXPECT_TRUE(scram::has_members(Numbers{0, away, idle}, Numbers{1, 3}));
  EXPECT_FALSE(scram::has_members(Numbers{0, away, idle}, Numbers{1, 2, 3}));
  EXPECT_FALSE(scram::has_members(Numbers{0, 1, idle}, Numbers{1, 3}));
  EXPECT_FALSE(scram::has_members(Numbers{0, away, idle}, Numbers{1}));
  EXPECT_TRUE(scram::has_members(Numbers{away}, Numbers{}));
  const Numbers numbers{1, 2, 3, 4}, ids{2, 5, 7};
  const Order order{0, 1, 2};
  const scram::Here here{numbers, ids, order};
  EXPECT_TRUE(scram::is_about(Numbers{7, 5, 2, idle}, here));
  EXPECT_TRUE(scram::is_about(Numbers{7, 5, 3, 4}, here));
  EXPECT_FALSE(scram::is_about(Numbers{7, 6, 3, idle}, here));
  EXPECT_FALSE(scram::is_about(Numbers{idle, idle, away, idle}, here));
}

}  // namespace
