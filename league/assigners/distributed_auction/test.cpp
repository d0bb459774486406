// SPDX-License-Identifier: MIT
// The auction against the best assignment, by hand and on random problems; the table of bids and its bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <plugins/assigners/shortest_paths.hpp>

#include "algorithm.hpp"
#include "price_table.hpp"
#include "test_auctions.hpp"

namespace {

using namespace auction;
using namespace auction_test;

// --- By hand

// Bids of a robot with these values at these prices.
std::vector<NewBid> bids(const OneTask& rule, const std::vector<std::int32_t>& values,
                         const std::vector<std::uint32_t>& prices, std::vector<char> mine = {}) {
  mine.resize(values.size(), 0);
  const std::vector<std::int32_t> groups(values.size(), 0);
  std::vector<NewBid> out;
  rule.bids({values, prices, groups, mine}, out);
  return out;
}

// [[10, 9], [9, 0]] with epsilon 1/4, in steps of a quarter: the first robot bids 1.25, the second 9.25, and the first
// takes the other task for 8.5.
TEST(DistributedAuction, TwoRobotsAndTwoTasks) {
  const OneTask rule{1};
  const std::vector<std::int32_t> first{40, 36}, second{36, 0};
  std::vector<std::uint32_t> prices{0, 0};
  auto bid = bids(rule, first, prices);
  ASSERT_EQ(bid.size(), 1u);
  EXPECT_EQ(bid[0].column, 0u);
  EXPECT_EQ(0.25 * bid[0].price, 1.25);
  prices[0] = bid[0].price;
  bid = bids(rule, second, prices);
  ASSERT_EQ(bid.size(), 1u);
  EXPECT_EQ(bid[0].column, 0u);
  EXPECT_EQ(0.25 * bid[0].price, 9.25);
  prices[0] = bid[0].price;
  bid = bids(rule, first, prices);
  ASSERT_EQ(bid.size(), 1u);
  EXPECT_EQ(bid[0].column, 1u);
  EXPECT_EQ(0.25 * bid[0].price, 8.5);

  Problem problem;
  problem.robots = problem.tasks = 2;
  problem.values = {40, 36, 36, 0};
  problem.groups = {0, 0};
  problem.largest = 40;
  Team<OneTask> team(problem, rule, 1, {}, 1);
  for (const std::size_t robot : {0u, 1u, 0u, 1u, 0u}) team.turn(robot);
  EXPECT_TRUE(team.agree());
  EXPECT_EQ(team.bids, 3u);
  EXPECT_EQ(outcome(problem, team.members[0].table()).sum, 4 * 18);
  EXPECT_EQ(team.members[0].table()[0], (Bid{37, 2}));
  EXPECT_EQ(team.members[0].table()[1], (Bid{34, 1}));
}

TEST(DistributedAuction, BidsNothingForNothing) {
  const OneTask rule{5};
  EXPECT_TRUE(bids(rule, {}, {}).empty());
  EXPECT_TRUE(bids(rule, {may_not, may_not}, {0, 0}).empty());
  EXPECT_TRUE(bids(rule, {10, 8}, {10, 9}).empty());         // margins of 0 and below
  EXPECT_TRUE(bids(rule, {10, 8}, {0, 0}, {1, 0}).empty());  // it holds one
  const auto alone = bids(rule, {10, 8}, {0, 9});            // having none is worth 0: more than the second margin
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_EQ(alone[0].price, 15u);
  const auto tie = bids(rule, {7, 7}, {0, 0});
  ASSERT_EQ(tie.size(), 1u);
  EXPECT_EQ(tie[0].column, 0u);
  EXPECT_EQ(tie[0].price, 5u);
}

// --- Against the best assignment

// By shortest augmenting paths: "no task" is as many more columns as there are robots, of value 0.
std::int64_t best_of(const Problem& problem) {
  const std::size_t columns = problem.tasks + problem.robots;
  std::vector<double> costs(problem.robots * columns, 0.0);
  for (std::size_t i = 0; i < problem.robots; ++i) {
    for (std::size_t j = 0; j < problem.tasks; ++j) {
      const bool may = problem.value(i, j) != may_not;
      costs[i * columns + j] = may ? -static_cast<double>(problem.value(i, j)) : assignment::infinity;
    }
  }
  assignment::ShortestPaths<double> solver;
  solver.reserve(problem.robots, columns);
  EXPECT_TRUE(solver.solve({costs.data(), problem.robots, columns}));
  double sum = 0.0;
  for (std::size_t i = 0; i < problem.robots; ++i) {
    sum -= costs[i * columns + static_cast<std::size_t>(solver.object_of[i])];
  }
  return std::llround(sum);
}

TEST(DistributedAuction, IsWithinEpsilonForEachTaskOfTheBest) {
  std::mt19937 random(79);
  std::int64_t worst = 0;
  for (unsigned problem_number = 0; problem_number < 10000; ++problem_number) {
    const Problem problem = random_problem(random, 7, 9, 200, problem_number % 3 == 0 ? 3 : 0);
    const std::uint32_t epsilon = 1 + below(random, 40);
    Team<OneTask> team(problem, {epsilon}, epsilon, {}, problem_number + 1);
    play(team);
    ASSERT_TRUE(team.agree());
    EXPECT_FALSE(team.prices_fell);
    EXPECT_EQ(team.members[0].epoch(), 0);
    const Outcome got = outcome(problem, team.members[0].table());
    const std::int64_t best = best_of(problem), gap = best - got.sum;
    worst = std::max(worst, gap);
    ASSERT_GE(gap, 0);
    ASSERT_LE(gap, static_cast<std::int64_t>(got.filled) * epsilon) << "problem " << problem_number;
    ASSERT_LE(team.bids, problem.robots * problem.tasks * (200 / epsilon + 1));
    if (problem_number % 20 == 0) {  // the two ways to find it
      ASSERT_EQ(best, best_sum(problem));
    }
  }
  EXPECT_GT(worst, 40);  // epsilon does cost something
}

// "Exact for integers with epsilon < 1/n": values are multiples of a number above that of the tasks, and epsilon is 1.
TEST(DistributedAuction, IsExactWhereEpsilonIsSmall) {
  std::mt19937 random(8);
  for (unsigned problem_number = 0; problem_number < 2000; ++problem_number) {
    Problem problem = random_problem(random, 7, 7, 9, 1);
    for (std::int32_t& value : problem.values) value = value == may_not ? may_not : 8 * value;
    problem.largest = 72;
    Team<OneTask> team(problem, {1}, 1, {}, problem_number + 1);
    play(team);
    ASSERT_EQ(outcome(problem, team.members[0].table()).sum, best_of(problem));
  }
}

// Nobody idles while a task that it could do stays open: with values above 0, whatever is forbidden.
TEST(DistributedAuction, NoTaskStaysOpenForWhoCouldDoIt) {
  std::mt19937 random(12);
  for (unsigned problem_number = 0; problem_number < 2000; ++problem_number) {
    Problem problem = random_problem(random, 7, 7, 50, 5);
    for (std::int32_t& value : problem.values) value += value == may_not ? 0 : 1;
    problem.largest = 51;
    Team<OneTask> team(problem, {1 + below(random, 30)}, 30, {}, problem_number + 1);
    play(team);
    const auto table = team.members[0].table();
    for (std::size_t robot = 0; robot < problem.robots; ++robot) {
      const auto has = [&](Bid bid) { return bid.bidder == static_cast<std::int32_t>(robot + 1); };
      if (std::ranges::any_of(table, has)) continue;
      for (std::size_t task = 0; task < problem.tasks; ++task) {
        EXPECT_TRUE(table[task].bidder != nobody || problem.value(robot, task) == may_not);
      }
    }
  }
}

// With other numbers the robots get the same tasks, as long as no two prices are equal.
TEST(DistributedAuction, NumbersOfRobotsDoNotMatter) {
  std::mt19937 random(31);
  for (int round = 0; round < 300; ++round) {
    const Problem problem = random_problem(random, 6, 6, 1000000, 0);
    std::vector<std::size_t> number(problem.robots);  // new number of each robot
    for (std::size_t k = 0; k < number.size(); ++k) number[k] = k;
    std::shuffle(number.begin(), number.end(), random);
    Problem other = problem;
    for (std::size_t i = 0; i < problem.robots; ++i) {
      for (std::size_t j = 0; j < problem.tasks; ++j) {
        other.values[number[i] * problem.tasks + j] = problem.value(i, j);
      }
    }
    const std::uint32_t epsilon = 100000;
    Team<OneTask> team(problem, {epsilon}, epsilon, {}, 1), renumbered(other, {epsilon}, epsilon, {}, 1);
    for (int turn = 0; turn < 300; ++turn) {
      const std::size_t robot = random() % problem.robots;
      team.turn(robot);
      renumbered.turn(number[robot]);
    }
    ASSERT_TRUE(team.agree());
    for (std::size_t j = 0; j < problem.tasks; ++j) {
      const Bid a = team.members[0].table()[j], b = renumbered.members[0].table()[j];
      ASSERT_EQ(a.price, b.price);
      const auto expected =
          a.bidder == nobody ? nobody : static_cast<std::int32_t>(number[static_cast<std::size_t>(a.bidder - 1)] + 1);
      ASSERT_EQ(expected, b.bidder);
    }
  }
}

// --- The table

TEST(DistributedAuction, TheOrderOfWhatIsHeardDoesNotMatter) {
  std::mt19937 random(5);
  for (int round = 0; round < 2000; ++round) {
    std::vector<Bid> heard(1 + random() % 8);
    for (Bid& bid : heard) bid = {1 + below(random, 4), static_cast<std::int32_t>(below(random, 4))};
    Bid once, again;
    for (const Bid bid : heard) merge(once, bid);
    std::vector<Bid> others = heard;
    for (const Bid bid : heard) {
      if (random() % 2 == 0) others.push_back(bid);
    }
    std::shuffle(others.begin(), others.end(), random);
    for (const Bid bid : others) {
      const Bid before = again;
      const bool changed = merge(again, bid);
      EXPECT_EQ(changed, again != before);
      EXPECT_FALSE(is_above(before, again));
      EXPECT_FALSE(merge(again, bid));
    }
    ASSERT_EQ(once, again);
    for (const Bid bid : heard) EXPECT_FALSE(is_above(bid, once));
  }
  EXPECT_TRUE(is_above({2, 5}, {1, 1}));
  EXPECT_TRUE(is_above({2, 3}, {2, 5}));       // the lower number
  EXPECT_TRUE(is_above({2, nobody}, {2, 1}));  // given up
}

TEST(DistributedAuction, MessagesSayWhatWasWritten) {
  std::mt19937 random(6);
  std::size_t refused = 0;
  for (int round = 0; round < 3000; ++round) {
    const bool has_done = round % 2 == 0;
    const auto team_size = static_cast<std::int32_t>(1 + random() % 22);
    const std::size_t tasks = 1 + random() % 64;
    const Format format = Format::fitting(team_size, tasks, 1 + below(random, 100000), has_done, 60);
    std::vector<Told> told;
    for (std::size_t task = 0; task < tasks && told.size() < format.most_told; ++task) {
      if (random() % 2 == 0) continue;
      told.push_back({task,
                      {1 + static_cast<std::uint32_t>(random() % format.highest_price),
                       static_cast<std::int32_t>(random() % (static_cast<unsigned>(team_size) + 1))},
                      has_done && random() % 2 == 0});
    }
    std::vector<std::uint8_t> bytes;
    const auto epoch = static_cast<std::uint8_t>(random());
    write_message(format, epoch, told, bytes);
    EXPECT_LE(bytes.size(), 60u);
    EXPECT_EQ(bytes.size(), format.bytes(told.size()));
    std::uint8_t heard_epoch = 0;
    std::vector<Told> heard;
    ASSERT_TRUE(read_message(format, bytes, heard_epoch, heard));
    EXPECT_EQ(heard_epoch, epoch);
    ASSERT_EQ(heard.size(), told.size());
    for (std::size_t k = 0; k < told.size(); ++k) {
      EXPECT_EQ(heard[k].task, told[k].task);
      EXPECT_EQ(heard[k].bid, told[k].bid);
      EXPECT_EQ(heard[k].done, told[k].done);
    }
    // Whatever else comes is read or refused, and what is read is sound.
    std::vector<std::uint8_t> noise(random() % 70);
    for (std::uint8_t& byte : noise) byte = static_cast<std::uint8_t>(random());
    if (!read_message(format, noise, heard_epoch, heard)) {
      ++refused;
      continue;
    }
    for (const Told& each : heard) {
      EXPECT_LT(each.task, tasks);
      EXPECT_LE(each.bid.bidder, team_size);
      EXPECT_GE(each.bid.price, 1u);
      EXPECT_LE(each.bid.price, format.highest_price);
    }
  }
  EXPECT_GT(refused, 1000u);
  EXPECT_FALSE(is_above(Bid{}, Bid{}));
}

}  // namespace
