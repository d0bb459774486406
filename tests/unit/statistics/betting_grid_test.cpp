// SPDX-License-Identifier: MIT
// Against a BettingTest for each mean of the grid.
#include "statistics/anytime_valid_tests.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace regista::statistics {
namespace {

using Finding = BettingTest::Finding;

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

// Half goal differences of pairs, with a mean of `advantage` or close to it.
double goals(std::mt19937_64& random, double advantage) {
  double difference = 0.0;
  for (int chance = 0; chance < 12; ++chance) {
    const double u = uniform(random);
    difference += u < 0.1 + advantage / 6.0 ? 0.5 : u > 0.9 ? -0.5 : 0.0;
  }
  return difference;
}

TEST(BettingGrid, KnowsNothingBeforeTheFirstValue) {
  const BettingGrid grid({-10, 10, 0.05}, 4000);
  EXPECT_EQ(grid.interval().low, -10.0);
  EXPECT_EQ(grid.interval().high, 10.0);
  EXPECT_EQ(grid.finding(0.0), Finding::none);
}

// A test of its own for each mean, none of which is ever left out, gives the very same interval.
TEST(BettingGrid, IsTheRunningIntersectionOfTests) {
  constexpr int steps = 200;
  constexpr double step = 20.0 / steps;
  for (const double advantage : {-0.6, 0.0, 0.3, 2.0}) {
    std::mt19937_64 random(11);
    BettingGrid grid({-10, 10, 0.05}, steps);
    std::vector<BettingTest> tests;
    for (int i = 1; i < steps; ++i) tests.emplace_back(BettingDesign{-10, 10, 0.05}, -10 + i * step);
    for (int i = 1; i <= 400; ++i) {
      const double value = goals(random, advantage);
      grid.add(value);
      Interval exact{-10, 10};
      for (int k = 1; k < steps; ++k) {
        BettingTest& test = tests[static_cast<std::size_t>(k - 1)];
        test.add(value);
        const double mean = -10 + k * step;
        if (test.finding() == Finding::above) exact.low = std::max(exact.low, mean);
        if (test.finding() == Finding::below) exact.high = std::min(exact.high, mean);
      }
      ASSERT_NEAR(grid.interval().low, exact.low, 1e-12) << i;
      ASSERT_NEAR(grid.interval().high, exact.high, 1e-12) << i;
    }
  }
}

TEST(BettingGrid, FindsWhatTheTestOfOneMeanFinds) {
  int found = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937_64 random(seed);
    const double advantage = seed % 4 == 0 ? 0.0 : seed % 2 == 0 ? 0.8 : -0.8;
    BettingGrid grid({-10, 10, 0.05}, 200);
    BettingTest at_zero({-10, 10, 0.05}, 0.0), at_one({-10, 10, 0.05}, 1.0);
    for (int i = 0; i < 300; ++i) {
      const double value = goals(random, advantage);
      grid.add(value);
      at_zero.add(value);
      at_one.add(value);
      ASSERT_EQ(grid.finding(0.0), at_zero.finding()) << seed << ": " << i;
      ASSERT_EQ(grid.finding(1.0), at_one.finding()) << seed << ": " << i;
    }
    found += at_zero.finding() != Finding::none ? 1 : 0;
  }
  EXPECT_GT(found, 20);
  EXPECT_LT(found, 40);
}

// What was found stays, though the values that come later speak against it.
TEST(BettingGrid, StaysWithWhatItFound) {
  BettingGrid grid({-1, 1, 0.05}, 100);
  for (int i = 0; i < 60; ++i) grid.add(1.0);
  ASSERT_EQ(grid.finding(0.0), Finding::above);
  const double low = grid.interval().low;
  for (int i = 0; i < 2000; ++i) grid.add(-1.0);
  EXPECT_EQ(grid.finding(0.0), Finding::above);
  EXPECT_GE(grid.interval().low, low);
  EXPECT_LE(grid.interval().low, grid.interval().high);
}

TEST(BettingGrid, SeldomErrsHoweverOftenOneLooks) {
  int rejected = 0, excluded = 0;
  constexpr int tournaments = 1000;
  for (unsigned tournament = 0; tournament < tournaments; ++tournament) {
    std::mt19937_64 random(tournament);
    BettingGrid grid({-10, 10, 0.05}, 40);
    bool always = true;
    for (int i = 0; i < 300; ++i) {
      grid.add(goals(random, 0.0));
      always = always && grid.interval().contains(0.0);
    }
    rejected += grid.finding(0.0) != Finding::none ? 1 : 0;
    excluded += always ? 0 : 1;
  }
  EXPECT_LE(rejected, tournaments / 20);
  EXPECT_LE(excluded, rejected);
}

TEST(BettingGrid, FindsWhatThereIs) {
  int missed = 0;
  for (unsigned tournament = 0; tournament < 200; ++tournament) {
    std::mt19937_64 random(tournament);
    BettingGrid grid({-10, 10, 0.05}, 40);
    for (int i = 0; i < 1000 && grid.finding(0.0) == Finding::none; ++i) grid.add(goals(random, -0.4));
    missed += grid.finding(0.0) != Finding::below ? 1 : 0;
  }
  EXPECT_LE(missed, 2);
}

TEST(BettingGrid, ValuesAtTheEndsOfTheRange) {
  for (const double value : {-10.0, 10.0}) {
    BettingGrid grid({-10, 10, 0.05}, 400);
    for (int i = 0; i < 2000; ++i) grid.add(value);
    const Interval interval = grid.interval();
    EXPECT_TRUE(interval.contains(value));
    EXPECT_LT(interval.high - interval.low, 0.2);
    EXPECT_GE(interval.low, -10.0);
    EXPECT_LE(interval.high, 10.0);
    EXPECT_EQ(grid.finding(0.0), value > 0.0 ? Finding::above : Finding::below);
  }
}

TEST(BettingGrid, ASurpriseAtTheEndOfTheRangeIsSurvived) {
  for (const double value : {-10.0, 10.0}) {
    BettingGrid grid({-10, 10, 0.05}, 400);
    for (int i = 0; i < 2000; ++i) grid.add(value);
    for (int i = 0; i < 2000; ++i) grid.add(-value);
    const Interval interval = grid.interval();
    EXPECT_TRUE(std::isfinite(interval.low) && std::isfinite(interval.high));
    EXPECT_LE(interval.low, interval.high);
  }
}

TEST(BettingGrid, Mirrors) {
  std::mt19937_64 random(8);
  BettingGrid one({-10, 10, 0.05}, 400), other({-10, 10, 0.05}, 400);
  for (int i = 0; i < 500; ++i) {
    const double value = goals(random, 0.5);
    one.add(value);
    other.add(-value);
  }
  EXPECT_NEAR(one.interval().low, -other.interval().high, 0.05 + 1e-9);
  EXPECT_NEAR(one.interval().high, -other.interval().low, 0.05 + 1e-9);
}

}  // namespace
}  // namespace regista::statistics
