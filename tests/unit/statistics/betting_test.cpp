// SPDX-License-Identifier: MIT
#include "statistics/anytime_valid_tests.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace regista::statistics {
namespace {

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

TEST(Capital, PublishedBets) {
  Capital capital;
  for (const double score : {1.0, 0.5, 0.75, 1.0}) capital.bet(0.5, score, 0.5);
  EXPECT_NEAR(std::exp(capital.log()), 1.7578125, 1e-12);
}

// Far beyond what a double can hold, either way, and in many small steps: the same as the sum of logarithms.
TEST(Capital, IsTheProductHoweverLargeOrSmall) {
  for (const double factor : {0.25, 1.75, 1.0 + 1e-9, 1.0 - 1e-9, 1e12}) {
    Capital capital;
    long double log = 0.0L;
    for (int i = 0; i < 100'000; ++i) {
      capital.bet(factor - 1.0, 1.0, 0.0);
      log += std::log1p(static_cast<long double>(factor) - 1.0L);
    }
    EXPECT_NEAR(capital.log(), static_cast<double>(log), 1e-9 * std::max(1.0, std::abs(static_cast<double>(log))))
        << factor;
  }
  std::mt19937_64 random(5);
  Capital capital;
  long double log = 0.0L;
  for (int i = 0; i < 1'000'000; ++i) {
    const double stake = 1.5 * (uniform(random) - 0.5), value = uniform(random);
    capital.bet(stake, value, 0.3);
    log += std::log1p(static_cast<long double>(stake * (value - 0.3)));
  }
  EXPECT_NEAR(capital.log(), static_cast<double>(log), 1e-7);
}

TEST(PlugInStake, ByHand) {
  PlugInStake stake(0.05);
  EXPECT_NEAR(stake.next(), std::sqrt(2 * std::log(40.0) / (0.25 * std::log(2.0))), 1e-12);
  stake.learn(1.0);  // mean so far (1/2 + 1) / 2
  EXPECT_NEAR(stake.next(), std::sqrt(2 * std::log(40.0) / ((0.25 + 0.0625) / 2 * 2 * std::log(3.0))), 1e-12);
}

// Values of a law with a given mean on {low, 0, high}; the exact expectation of the capital after two values is 1.
TEST(HedgedCapital, IsAFairGame) {
  const double mean = 0.3;
  const std::vector<std::pair<double, double>> law{{0.0, 0.5}, {0.2, 0.25}, {1.0, 0.25}};  // value, probability
  double above = 0.0, below = 0.0;
  for (const auto& [first, p1] : law) {
    for (const auto& [second, p2] : law) {
      PlugInStake stake(0.05);
      HedgedCapital capital;
      capital.bet(stake.next(), first, mean);
      stake.learn(first);
      capital.bet(stake.next(), second, mean);
      above += p1 * p2 * std::exp(capital.log_above());
      below += p1 * p2 * std::exp(capital.log_below());
    }
  }
  EXPECT_NEAR(above, 1.0, 1e-12);
  EXPECT_NEAR(below, 1.0, 1e-12);
}

// Goal differences of pairs: few goals, a mercy rule at ten.
double goals(std::mt19937_64& random, double advantage) {
  double difference = 0.0;
  for (int chance = 0; chance < 12; ++chance) {
    const double u = uniform(random);
    difference += u < 0.1 + advantage ? 1.0 : u > 0.9 ? -1.0 : 0.0;
  }
  return std::clamp(difference, -10.0, 10.0);
}

TEST(BettingTest, SeldomErrsHoweverOftenOneLooks) {
  int rejected = 0, missed = 0;
  for (unsigned tournament = 0; tournament < 2000; ++tournament) {
    std::mt19937_64 random(tournament);
    BettingTest test({-10, 10, 0.05}, 0.0);
    for (int i = 0; i < 400 && test.finding() == BettingTest::Finding::none; ++i) test.add(goals(random, 0.0));
    rejected += test.finding() != BettingTest::Finding::none ? 1 : 0;
  }
  EXPECT_LE(rejected, 100);  // 5 %
  for (unsigned tournament = 0; tournament < 200; ++tournament) {
    std::mt19937_64 random(tournament);
    BettingTest test({-10, 10, 0.05}, 0.0);
    for (int i = 0; i < 2000 && test.finding() == BettingTest::Finding::none; ++i) test.add(goals(random, 0.05));
    missed += test.finding() != BettingTest::Finding::above ? 1 : 0;
  }
  EXPECT_LE(missed, 2);
}

TEST(BettingTest, StaysWithWhatItFound) {
  BettingTest test({-1, 1, 0.05}, 0.0);
  for (int i = 0; i < 100; ++i) test.add(1.0);
  EXPECT_EQ(test.finding(), BettingTest::Finding::above);
  EXPECT_LT(test.p(), 0.05);
  const double p = test.p();
  for (int i = 0; i < 1000; ++i) test.add(-1.0);
  EXPECT_EQ(test.finding(), BettingTest::Finding::above);
  EXPECT_LE(test.p(), p);
}

TEST(BettingTest, EvenPairsAreNoEvidence) {
  BettingTest test({-10, 10, 0.05}, 0.0);
  for (int i = 0; i < 10000; ++i) test.add(0.0);
  EXPECT_EQ(test.finding(), BettingTest::Finding::none);
  EXPECT_EQ(test.p(), 1.0);
}

}  // namespace
}  // namespace regista::statistics
