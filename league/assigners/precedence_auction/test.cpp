// SPDX-License-Identifier: MIT
// Auctions of groups against the best that a network flow finds, and a search of all assignments for that flow.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "../distributed_auction/test_auctions.hpp"
#include "algorithm.hpp"

namespace {

using namespace auction_test;
using auction::may_not, auction::NewBid;
using precedence::OneOfEachGroup, precedence::Order;

struct Scratch {
  std::vector<OneOfEachGroup::Best> best;
  OneOfEachGroup rule(std::uint32_t epsilon, std::size_t most, Order order) { return {epsilon, most, order, &best}; }
};

std::vector<NewBid> bids(std::size_t most, Order order, const std::vector<std::int32_t>& values,
                         const std::vector<std::uint32_t>& prices, const std::vector<std::int32_t>& groups,
                         std::vector<char> mine = {}) {
  mine.resize(values.size(), 0);
  Scratch scratch;
  std::vector<NewBid> out;
  scratch.rule(2, most, order).bids({values, prices, groups, mine}, out);
  std::ranges::sort(out, {}, &NewBid::column);
  return out;
}

// Three groups; margins 20 and 15, then 30 and 4, then 18.
TEST(PrecedenceAuction, BidsByTheSecondBestAndTheBestGroupLeftOut) {
  const std::vector<std::int32_t> values{25, 15, 30, 10, 18}, groups{1, 1, 5, 5, 7};
  const std::vector<std::uint32_t> prices{5, 0, 0, 6, 0};
  auto out = bids(1, Order::sum, values, prices, groups);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out[0].column, 2u);
  EXPECT_EQ(out[0].price, 30u - 20u + 2u);  // it would turn to the first group
  out = bids(2, Order::sum, values, prices, groups);
  ASSERT_EQ(out.size(), 2u);
  EXPECT_EQ(out[0].column, 0u);
  EXPECT_EQ(out[0].price, 5u + 20u - 18u + 2u);  // to the third group rather than to the second task
  EXPECT_EQ(out[1].price, 30u - 18u + 2u);
  out = bids(3, Order::sum, values, prices, groups);
  ASSERT_EQ(out.size(), 3u);
  EXPECT_EQ(out[0].price, 5u + 20u - 15u + 2u);  // no group is left out
  EXPECT_EQ(out[1].price, 30u - 4u + 2u);
  EXPECT_EQ(out[2].price, 18u + 2u);
  out = bids(2, Order::sum, values, prices, groups, {0, 0, 1, 0, 0});
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out[0].column, 0u);

  out = bids(1, Order::first, values, prices, groups);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out[0].column, 0u);
  EXPECT_EQ(out[0].price, 5u + 20u - 15u + 2u);  // what later groups are worth does not count
  out = bids(2, Order::first, values, {25, 15, 0, 6, 0}, groups);
  ASSERT_EQ(out.size(), 2u);
  EXPECT_EQ(out[0].column, 2u);
  EXPECT_EQ(out[1].column, 4u);
}

TEST(PrecedenceAuction, BidsNothingForNothing) {
  EXPECT_TRUE(bids(2, Order::sum, {}, {}, {}).empty());
  EXPECT_TRUE(bids(2, Order::sum, {may_not, 5}, {0, 5}, {0, 1}).empty());
  EXPECT_TRUE(bids(1, Order::sum, {9, 5}, {0, 0}, {0, 1}, {0, 1}).empty());  // it holds as many as it may
  EXPECT_TRUE(bids(2, Order::sum, {9, 5}, {0, 0}, {0, 0}, {0, 1}).empty());  // one of this group
  EXPECT_TRUE(bids(2, Order::first, {9, 5}, {0, 0}, {0, 0}, {0, 1}).empty());
}

// With one group this is the auction of Bertsekas, bid for bid.
TEST(PrecedenceAuction, OneGroupIsThePlainAuction) {
  std::mt19937 random(3);
  for (int round = 0; round < 2000; ++round) {
    std::vector<std::int32_t> values;
    std::vector<std::uint32_t> prices;
    for (std::size_t k = 1 + below(random, 8); k > 0; --k) {
      values.push_back(below(random, 6) == 0 ? may_not : static_cast<std::int32_t>(below(random, 20)));
      prices.push_back(below(random, 12));
    }
    const std::vector<std::int32_t> groups(values.size(), 4);
    const std::vector<char> mine(values.size(), 0);
    std::vector<NewBid> plain;
    auction::OneTask{2}.bids({values, prices, groups, mine}, plain);
    for (const Order order : {Order::sum, Order::first}) {
      const auto out = bids(1 + below(random, 3), order, values, prices, groups);
      ASSERT_EQ(out.size(), plain.size());
      if (out.empty()) continue;
      EXPECT_EQ(out[0].column, plain[0].column);
      EXPECT_EQ(out[0].price, plain[0].price);
    }
  }
}

// --- The best that there is

// By trying everything.
std::int64_t best_by_search(const Problem& problem, std::size_t task, std::vector<std::vector<std::int32_t>>& taken) {
  if (task == problem.tasks) return 0;
  std::int64_t best = best_by_search(problem, task + 1, taken);
  for (std::size_t robot = 0; robot < problem.robots; ++robot) {
    auto& has = taken[robot];
    if (problem.value(robot, task) == may_not || has.size() >= problem.most) continue;
    if (std::ranges::count(has, problem.groups[task]) > 0) continue;
    has.push_back(problem.groups[task]);
    best = std::max(best, problem.value(robot, task) + best_by_search(problem, task + 1, taken));
    has.pop_back();
  }
  return best;
}

TEST(PrecedenceAuction, TheFlowFindsTheBest) {
  std::mt19937 random(17);
  for (int round = 0; round < 400; ++round) {
    const Problem problem = random_problem(random, 3, 5, 9, 2, 1 + below(random, 3), 1 + below(random, 3));
    std::vector<std::vector<std::int32_t>> taken(problem.robots);
    ASSERT_EQ(best_sum(problem), best_by_search(problem, 0, taken));
  }
}

TEST(PrecedenceAuction, IsWithinEpsilonForEachTaskOfTheBest) {
  std::mt19937 random(2011);
  std::int64_t worst = 0;
  std::size_t several = 0;
  for (unsigned number = 0; number < 10000; ++number) {
    const Problem problem =
        random_problem(random, 5, 8, 200, number % 3 == 0 ? 2 : 0, 1 + below(random, 4), 1 + below(random, 3));
    const std::uint32_t epsilon = 1 + below(random, 40);
    Scratch scratch;
    Team<OneOfEachGroup> team(problem, scratch.rule(epsilon, problem.most, Order::sum), epsilon, {}, number + 1);
    play(team);
    ASSERT_TRUE(team.agree());
    EXPECT_FALSE(team.prices_fell);
    EXPECT_EQ(team.members[0].epoch(), 0);
    const Outcome got = outcome(problem, team.members[0].table());
    const std::int64_t gap = best_sum(problem) - got.sum;
    worst = std::max(worst, gap);
    several += got.filled > problem.robots ? 1u : 0u;
    ASSERT_GE(gap, 0);
    ASSERT_LE(gap, static_cast<std::int64_t>(got.filled) * epsilon) << "problem " << number;
  }
  EXPECT_GT(worst, 40);       // epsilon does cost something
  EXPECT_GT(several, 1000u);  // robots that hold more than one task
}

// A robot that may have a task of each group plays one assignment problem for each.
TEST(PrecedenceAuction, WithRoomForAllGroupsEachIsAProblemOfItsOwn) {
  std::mt19937 random(41);
  for (unsigned number = 0; number < 1000; ++number) {
    const std::size_t groups = 1 + below(random, 3);
    const Problem problem = random_problem(random, 5, 7, 100, 1, groups, groups);
    const std::uint32_t epsilon = 1 + below(random, 10);
    Scratch scratch;
    Team<OneOfEachGroup> team(problem, scratch.rule(epsilon, problem.most, Order::sum), epsilon, {}, number + 1);
    play(team);
    for (std::int32_t group = 0; group < static_cast<std::int32_t>(groups); ++group) {
      Problem alone = problem;
      alone.most = 1;
      for (std::size_t k = 0; k < alone.values.size(); ++k) {
        if (problem.groups[k % problem.tasks] != group) alone.values[k] = may_not;
      }
      const Outcome got = outcome(problem, team.members[0].table(), group);
      const std::int64_t gap = best_sum(alone) - got.sum;
      ASSERT_GE(gap, 0);
      ASSERT_LE(gap, static_cast<std::int64_t>(got.filled) * epsilon);
    }
  }
}

// The first group is played as if there were no other, by all; the next one by those that still have room; and so on.
// Returns for how many groups somebody had no room left.
std::size_t each_group_is_within(const Problem& problem, std::span<const Bid> table, std::uint32_t epsilon) {
  std::size_t left = 0;
  std::vector<std::size_t> held(problem.robots, 0);
  for (std::int32_t group = 0; group <= std::ranges::max(problem.groups); ++group) {
    std::vector<char> has_room;
    for (const std::size_t each : held) has_room.push_back(each < problem.most ? 1 : 0);
    left += std::ranges::count(has_room, 0) > 0 && std::ranges::count(problem.groups, group) > 0 ? 1u : 0u;
    Problem alone = problem;
    alone.most = 1;
    for (std::size_t k = 0; k < alone.values.size(); ++k) {
      if (problem.groups[k % problem.tasks] != group) alone.values[k] = may_not;
    }
    const Outcome got = outcome(problem, table, group);
    const std::int64_t gap = best_sum(alone, has_room) - got.sum;
    EXPECT_GE(gap, 0);
    EXPECT_LE(gap, static_cast<std::int64_t>(got.filled) * epsilon);
    for (std::size_t task = 0; task < problem.tasks; ++task) {
      const std::int32_t bidder = table[task].bidder;
      if (problem.groups[task] == group && bidder != 0) ++held[static_cast<std::size_t>(bidder - 1)];
    }
  }
  return left;
}

TEST(PrecedenceAuction, EarlierGroupsChooseFirst) {
  std::mt19937 random(73);
  std::size_t left = 0;
  for (unsigned number = 0; number < 3000; ++number) {
    const std::size_t groups = 1 + below(random, 4);
    const Problem problem = random_problem(random, 6, 8, 100, number % 2 == 0 ? 2 : 0, groups, 1 + below(random, 2));
    const std::uint32_t epsilon = 1 + below(random, 20);
    Scratch scratch;
    Team<OneOfEachGroup> team(problem, scratch.rule(epsilon, problem.most, Order::first), epsilon, {}, number + 1);
    play(team);
    ASSERT_TRUE(team.agree());
    EXPECT_FALSE(team.prices_fell);
    EXPECT_EQ(team.members[0].epoch(), 0);
    left += each_group_is_within(problem, team.members[0].table(), epsilon);
    ASSERT_FALSE(testing::Test::HasFailure()) << "problem " << number;
  }
  EXPECT_GT(left, 1000u);
}

// The bound is the one of distributed_auction/test_network.cpp, here with all robots in reach of each other (D = 1).
TEST(PrecedenceAuction, RestsWithinTheBoundOverALossyRadio) {
  std::mt19937 random(99);
  for (unsigned number = 0; number < 600; ++number) {
    const Problem problem = random_problem(random, 6, 8, 100, 1, 1 + below(random, 3), 1 + below(random, 3));
    const std::uint32_t epsilon = 3 + below(random, 20);
    Radio radio;
    radio.loss = below(random, 81);
    radio.longest_gap = 1 + below(random, 8);
    radio.delay = below(random, 3);
    radio.repeats = 20;
    const Order order = number % 2 == 0 ? Order::sum : Order::first;
    Scratch scratch;
    Team<OneOfEachGroup> team(problem, scratch.rule(epsilon, problem.most, order), epsilon, radio, number);
    const std::size_t spread = radio.longest_gap + radio.delay;
    const std::size_t last_change = play(team, spread);
    ASSERT_TRUE(team.agree());
    EXPECT_LE(team.bids, problem.robots * problem.tasks * (100 / epsilon + 1));
    EXPECT_LE(last_change, (team.bids + 1) * spread);
    EXPECT_FALSE(team.prices_fell);
    if (order == Order::first) {
      each_group_is_within(problem, team.members[0].table(), epsilon);
    } else {
      const Outcome got = outcome(problem, team.members[0].table());
      ASSERT_LE(best_sum(problem) - got.sum, static_cast<std::int64_t>(got.filled) * epsilon);
    }
    ASSERT_FALSE(testing::Test::HasFailure()) << "problem " << number;
  }
}

// --- Looking again

struct View {
  std::vector<std::int32_t> values, groups;
  std::vector<std::uint32_t> prices;
  std::vector<char> mine;
  auction::Market market() const { return {values, prices, groups, mine}; }
};

TEST(PrecedenceAuction, GivesUpWhatIsNoLongerBest) {
  Scratch scratch;
  const View view{{20, 26, 40, 30}, {0, 0, 1, 2}, {10, 10, 10, 35}, {1, 0, 0, 0}};
  const OneOfEachGroup sum = scratch.rule(2, 1, Order::sum), first = scratch.rule(2, 1, Order::first);
  EXPECT_TRUE(sum.is_no_longer_best(view.market(), 0));
  View less = view;
  less.values[1] = 22;                                   // no more than epsilon better
  EXPECT_TRUE(sum.is_no_longer_best(less.market(), 0));  // for the second group
  EXPECT_FALSE(first.is_no_longer_best(less.market(), 0));
  EXPECT_FALSE(scratch.rule(2, 2, Order::sum).is_no_longer_best(less.market(), 0));  // it may have both
  less.mine = {0, 0, 0, 1};
  EXPECT_TRUE(first.is_no_longer_best(less.market(), 3));  // for the first group
  less.prices = {20, 22, 40, 35};
  EXPECT_FALSE(first.is_no_longer_best(less.market(), 3));
  EXPECT_FALSE(sum.is_no_longer_best(less.market(), 3));  // for none nothing is given up
}

TEST(PrecedenceAuction, OfTooManyTasksTheWorstAreGivenUp) {
  Scratch scratch;
  const View view{{20, 30, 15, 40}, {0, 0, 1, 2}, {1, 1, 1, 1}, {1, 1, 1, 1}};
  const auto too_many = [&](std::size_t most, Order order) {
    std::vector<int> out;
    for (std::size_t column = 0; column < 4; ++column) {
      if (scratch.rule(2, most, order).is_one_too_many(view.market(), column)) out.push_back(static_cast<int>(column));
    }
    return out;
  };
  EXPECT_EQ(too_many(3, Order::sum), (std::vector<int>{0}));
  EXPECT_EQ(too_many(2, Order::sum), (std::vector<int>{0, 2}));
  EXPECT_EQ(too_many(1, Order::sum), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(too_many(3, Order::first), (std::vector<int>{0}));
  EXPECT_EQ(too_many(2, Order::first), (std::vector<int>{0, 3}));
}

TEST(PrecedenceAuction, MissesWhatNobodyHoldsInAnEarlierGroup) {
  Scratch scratch;
  const View view{{20, 30}, {0, 1}, {25, 10}, {0, 1}};
  EXPECT_TRUE(scratch.rule(2, 1, Order::first).misses(view.market(), 0, 7));
  EXPECT_FALSE(scratch.rule(2, 1, Order::sum).misses(view.market(), 0, 7));
  EXPECT_TRUE(scratch.rule(2, 2, Order::sum).misses(view.market(), 0, 7));  // it may have both
  View later = view;
  later.groups = {2, 1};
  EXPECT_FALSE(scratch.rule(2, 1, Order::first).misses(later.market(), 0, 7));
}

}  // namespace
