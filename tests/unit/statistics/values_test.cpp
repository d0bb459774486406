// SPDX-License-Identifier: MIT
// Statistics of one value per pair, of several p-values, and of pairing itself.
#include <gmock/gmock.h>

#include <cmath>
#include <utility>
#include <vector>

#include "statistics/anytime_valid_tests.hpp"
#include "statistics/moments.hpp"
#include "statistics/paired_tests.hpp"

namespace regista::statistics {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

MATCHER_P(IsNear, tolerance, "") { return std::abs(std::get<0>(arg) - std::get<1>(arg)) <= tolerance; }

TEST(Moments, SurviveALargeMean) {
  const Moments moments(std::vector{1e9 + 4.0, 1e9 + 7.0, 1e9 + 13.0, 1e9 + 16.0});
  EXPECT_EQ(moments.mean(), 1e9 + 10.0);
  EXPECT_NEAR(moments.variance(), 30.0, 1e-6);
  EXPECT_EQ(Moments(std::vector{3.0}).variance(), 0.0);
}

TEST(PairedT, PublishedSample) {
  const std::vector<double> values{1, 0, 2, -1, 0, 1, 3, -2, 1, 0, 0, 2, 1, -1, 0, 1, 0, 2, -1, 1};
  const PairedT test = *paired_t(values);
  EXPECT_NEAR(test.mean, 0.5, 1e-12);
  EXPECT_NEAR(test.standard_deviation, 1.235442, 1e-6);
  EXPECT_NEAR(test.t, 1.809934, 1e-6);
  EXPECT_NEAR(test.p, 0.086153, 1e-6);
  EXPECT_NEAR(test.interval.low, -0.078204, 1e-6);
  EXPECT_NEAR(test.interval.high, 1.078204, 1e-6);
  std::vector<double> negated = values;
  for (double& each : negated) each = -each;
  EXPECT_NEAR(paired_t(negated)->t, -test.t, 1e-12);
  EXPECT_NEAR(paired_t(negated)->p, test.p, 1e-12);
}

TEST(PairedT, FromMomentsIsThatOfTheValues) {
  const std::vector<double> values{0.3, 1.1, -0.4, 2.0, 0.7};
  const PairedT direct = *paired_t(values), summed = *paired_t(Moments(values));
  EXPECT_EQ(summed.pairs, 5);
  EXPECT_NEAR(summed.t, direct.t, 1e-12);
  EXPECT_NEAR(summed.p, direct.p, 1e-12);
  EXPECT_FALSE(paired_t(Moments(std::vector{2.0, 2.0, 2.0})).has_value());
  EXPECT_FALSE(paired_t(Moments(std::vector{2.0})).has_value());
}

// The p-value and the interval are two sides of one test.
TEST(PairedT, IntervalEndsWhereTheTestDoes) {
  const std::vector<double> values{0.3, 1.1, -0.4, 2.0, 0.7};
  const PairedT test = *paired_t(values, 0.9);
  std::vector<double> moved = values;
  for (double& each : moved) each -= test.interval.low;
  EXPECT_NEAR(paired_t(moved)->p, 0.1, 1e-9);
}

TEST(PairedT, NoSpreadIsNoInformation) {
  EXPECT_FALSE(paired_t(std::vector<double>{}).has_value());
  EXPECT_FALSE(paired_t(std::vector<double>{2.0}).has_value());
  EXPECT_FALSE(paired_t(std::vector<double>{0.1, 0.1, 0.1}).has_value());
  EXPECT_FALSE(paired_t(std::vector<double>(100, 0.0)).has_value());
}

TEST(MixtureTest, PublishedSample) { EXPECT_NEAR(mixture_half_width({1000, 1.0, 0.01}, 0.05), 0.096064, 1e-6); }

// The ratio is the mean of the likelihood ratio over normally mixed means: summed numerically.
TEST(MixtureTest, HalfWidthIsTheMeanAtWhichTheMixtureRejects) {
  const double s2 = 1.7, tau2 = 0.2;
  for (const std::int64_t n : {1, 10, 400}) {
    const double mean = mixture_half_width({n, s2, tau2}, 0.02);
    double ratio = 0.0;
    for (double theta = -6.0; theta <= 6.0; theta += 1e-4) {
      const double density = std::exp(-theta * theta / (2 * tau2)) / std::sqrt(2 * M_PI * tau2);
      ratio += 1e-4 * density * std::exp(static_cast<double>(n) * (theta * mean - theta * theta / 2) / s2);
    }
    EXPECT_NEAR(ratio, 50.0, 1e-6) << n;
  }
}

TEST(MixtureTest, NoVarianceIsNoInformation) {
  EXPECT_EQ(mixture_half_width({50, 0.0, 1.0}, 0.05), HUGE_VAL);
  EXPECT_EQ(mixture_half_width({0, 1.0, 1.0}, 0.05), HUGE_VAL);
}

TEST(Multiplicity, PublishedHolm) {
  const std::vector<double> eight{.001, .008, .039, .041, .042, .06, .074, .205};
  // By hand: 8 p1, 7 p2, 6 p3, then never below the one before.
  EXPECT_THAT(holm(eight), Pointwise(IsNear(1e-12), {.008, .056, .234, .234, .234, .234, .234, .234}));
}

TEST(Multiplicity, KeepsTheOrderAndTheRange) {
  EXPECT_THAT(holm(std::vector{.5, .01, .9}),
              ElementsAre(DoubleNear(1.0, 0), DoubleNear(.03, 1e-15), DoubleNear(1.0, 0)));
  EXPECT_TRUE(holm({}).empty());
}

TEST(VarianceRatio, PublishedPairs) {
  EXPECT_NEAR(*variance_ratio({{365, 16618, 36229, 16974, 390}}, {{36027, 68692, 36433}}), 0.505, 0.0005);
  EXPECT_NEAR(*variance_ratio({{10789, 19328, 33806, 19402, 10543}}, {{65804, 56553, 65388}}), 0.946, 0.0005);
}

TEST(VarianceRatio, OfIndependentGamesIsOne) {
  // Losses, draws, wins 1 : 2 : 1; pairs are the product law.
  EXPECT_DOUBLE_EQ(*variance_ratio({{1, 4, 6, 4, 1}}, {{1, 2, 1}}), 1.0);
  EXPECT_DOUBLE_EQ(*variance_ratio({{0, 0, 9, 0, 0}}, {{9, 0, 9}}), 0.0);
  EXPECT_FALSE(variance_ratio({{0, 0, 9, 0, 0}}, {{0, 18, 0}}).has_value());
  EXPECT_FALSE(variance_ratio(PairCounts{}, GameCounts{}).has_value());
  EXPECT_FALSE(variance_ratio(Moments(), Moments()).has_value());
}

TEST(VarianceRatio, OfValues) {
  const auto ratio = [](const std::vector<std::pair<double, double>>& pairs) {
    Moments means, all;
    for (const auto& [first, second] : pairs) {
      means.add((first + second) / 2.0);
      all.add(first);
      all.add(second);
    }
    return variance_ratio(means, all);
  };
  EXPECT_NEAR(*ratio({{3, -3}, {-1, 1}, {2, -2}}), 0.0, 1e-12);
  EXPECT_FALSE(ratio({{1, 1}, {1, 1}}).has_value());
  std::vector<std::pair<double, double>> all;  // every combination of 1..6: independent, but for divisors 35 and 71
  for (int a = 1; a <= 6; ++a) {
    for (int b = 1; b <= 6; ++b) all.emplace_back(a, b);
  }
  EXPECT_NEAR(*ratio(all), (36.0 / 35.0) / (72.0 / 71.0), 1e-12);
}

}  // namespace
}  // namespace regista::statistics
