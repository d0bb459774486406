// SPDX-License-Identifier: MIT
#include "statistics/anytime_valid_tests.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace regista::statistics {
namespace {

// The mixture over all bets by numerical integration instead of its closed form, in units in which the effect of 0.3
// standard deviations is what is looked for.
double evidence(const std::vector<double>& values, double deviation, double centre) {
  const double tau = 0.3 / deviation, step = 1e-4 * tau;
  double sum = 0.0, squares = 0.0, out = 0.0;
  for (const double each : values) {
    sum += each - centre;
    squares += (each - centre) * (each - centre);
  }
  for (double bet = -12.0 * tau; bet <= 12.0 * tau; bet += step) {
    const double density = std::exp(-0.5 * bet * bet / (tau * tau)) / (tau * std::sqrt(2.0 * M_PI));
    out += step * density * std::exp(bet * sum - 0.5 * bet * bet * squares);
  }
  return out;
}

const std::vector<double> goals{1, 0, 2, -1, 0, 1, 3, -2, 1, 0, 0, 2, 1, -1, 0, 1, 0, 2, -1, 1};

TEST(SymmetricTest, IsTheMixtureOfAllBets) {
  for (const double deviation : {0.4, 1.2, 5.0}) {
    SymmetricTest test(deviation, 0.05);
    double most = 1.0;
    std::vector<double> so_far;
    for (const double each : goals) {
      test.add(each);
      so_far.push_back(each);
      most = std::max(most, evidence(so_far, deviation, 0.0));
      EXPECT_NEAR(test.p(), 1.0 / most, 1e-6);
    }
    EXPECT_TRUE(test.above());
    EXPECT_DOUBLE_EQ(test.mean(), 0.5);
  }
}

// The interval ends where the evidence against a centre is just enough.
TEST(SymmetricTest, IntervalIsWhatIsNotRejected) {
  for (const double alpha : {0.05, 0.01}) {
    SymmetricTest test(1.2, alpha);
    for (int i = 0; i < 3; ++i) {
      for (const double each : goals) test.add(each);
    }
    std::vector<double> all;
    for (int i = 0; i < 3; ++i) all.insert(all.end(), goals.begin(), goals.end());
    const Interval interval = test.interval();
    EXPECT_NEAR(evidence(all, 1.2, interval.low), 1.0 / alpha, 1e-3 / alpha);
    EXPECT_NEAR(evidence(all, 1.2, interval.high), 1.0 / alpha, 1e-3 / alpha);
    EXPECT_LT(interval.low, 0.5);
    EXPECT_GT(interval.high, 0.5);
    EXPECT_NEAR(interval.low + interval.high, 1.0, 1e-9);  // as far to both sides of the mean
  }
}

TEST(SymmetricTest, KnowsNothingOfFewValues) {
  SymmetricTest test(1.0, 0.05);
  EXPECT_EQ(test.p(), 1.0);
  EXPECT_FALSE(test.interval().bounded());
  test.add(5.0);
  EXPECT_FALSE(test.interval().bounded());
  SymmetricTest nothing(1.0, 0.05);
  for (int i = 0; i < 100; ++i) nothing.add(0.0);
  EXPECT_EQ(nothing.p(), 1.0);
}

// However often one looks: symmetric laws of very different tails, some of them without any variance.
TEST(SymmetricTest, HoldsForSymmetricLawsHoweverOftenOneLooks) {
  constexpr int runs = 2000, values = 300;
  std::mt19937_64 random(3);
  const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
  const auto rejections = [&](auto draw) {
    int out = 0;
    for (int run = 0; run < runs; ++run) {
      SymmetricTest test(1.0, 0.05);
      for (int i = 0; i < values && test.p() > 0.05; ++i) test.add(draw());
      out += test.p() <= 0.05;
    }
    return out;
  };
  const double most = runs * 0.05 + 3.0 * std::sqrt(runs * 0.05 * 0.95);
  EXPECT_LT(rejections([&] { return uniform() < 0.5 ? -1.0 : 1.0; }), most);
  EXPECT_LT(rejections([&] { return std::tan(M_PI * (uniform() - 0.5)); }), most);  // Cauchy
  EXPECT_LT(rejections([&] { return uniform() < 0.9 ? 0.0 : uniform() < 0.5 ? -3.0 : 3.0; }), most);
  // And the other way round: it finds what it is for.
  EXPECT_GT(rejections([&] { return 0.4 + (uniform() < 0.5 ? -1.0 : 1.0); }), runs * 0.95);
}

TEST(SymmetricTest, BelowIsToldFromAbove) {
  SymmetricTest test(1.0, 0.05);
  for (int i = 0; i < 150; ++i) test.add(i % 3 == 0 ? 1.0 : -1.0);
  EXPECT_LT(test.p(), 0.05);
  EXPECT_FALSE(test.above());
}

}  // namespace
}  // namespace regista::statistics
