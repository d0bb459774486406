// SPDX-License-Identifier: MIT
// Statistics of one value per pair, of several p-values, and of pairing itself.
#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "statistics/mixture_test.hpp"
#include "statistics/moments.hpp"
#include "statistics/multiplicity.hpp"
#include "statistics/paired_t.hpp"
#include "statistics/variance_ratio.hpp"

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

TEST(MixtureTest, PublishedSample) {
  const MixtureSample sample{1000, 0.1, 1.0, 0.01};
  EXPECT_NEAR(std::exp(mixture_log_ratio(sample)), 28.403345, 1e-6);
  EXPECT_NEAR(mixture_p(sample), 0.035207, 1e-6);
  EXPECT_NEAR(mixture_half_width(sample, 0.05), 0.096064, 1e-6);
}

TEST(MixtureTest, HalfWidthIsTheMeanAtWhichItRejects) {
  for (const std::int64_t n : {1, 10, 12345}) {
    const double half_width = mixture_half_width({n, 0.0, 2.5, 0.3}, 0.02);
    EXPECT_NEAR(mixture_log_ratio({n, half_width, 2.5, 0.3}), std::log(50.0), 1e-9);
    EXPECT_NEAR(mixture_log_ratio({n, -half_width, 2.5, 0.3}), std::log(50.0), 1e-9);
  }
}

// Lambda is the mean of the likelihood ratio over normally mixed means: summed numerically.
TEST(MixtureTest, IsTheMixtureItIsCalled) {
  const double n = 40, mean = 0.3, s2 = 1.7, tau2 = 0.2;
  double sum = 0.0;
  for (double theta = -6.0; theta <= 6.0; theta += 1e-4) {
    const double density = std::exp(-theta * theta / (2 * tau2)) / std::sqrt(2 * M_PI * tau2);
    sum += 1e-4 * density * std::exp(n * (theta * mean - theta * theta / 2) / s2);
  }
  EXPECT_NEAR(std::exp(mixture_log_ratio({40, mean, s2, tau2})), sum, 1e-9 * sum);
}

TEST(MixtureTest, NoVarianceIsNoInformation) {
  EXPECT_EQ(mixture_p({50, 3.0, 0.0, 1.0}), 1.0);
  EXPECT_EQ(mixture_half_width({50, 3.0, 0.0, 1.0}, 0.05), HUGE_VAL);
  EXPECT_EQ(mixture_half_width({0, 0.0, 1.0, 1.0}, 0.05), HUGE_VAL);
}

const std::vector<double> eight{.001, .008, .039, .041, .042, .06, .074, .205};

TEST(Multiplicity, PublishedHolm) {
  // By hand: 8 p1, 7 p2, 6 p3, then never below the one before.
  EXPECT_THAT(holm(eight), Pointwise(IsNear(1e-12), {.008, .056, .234, .234, .234, .234, .234, .234}));
}

TEST(Multiplicity, PublishedBenjaminiHochberg) {
  EXPECT_THAT(benjamini_hochberg(eight),
              Pointwise(IsNear(1e-4 / 2), {.008, .032, .0672, .0672, .0672, .08, .0846, .205}));
}

TEST(Multiplicity, KeepsTheOrderAndTheRange) {
  EXPECT_THAT(holm(std::vector{.5, .01, .9}),
              ElementsAre(DoubleNear(1.0, 0), DoubleNear(.03, 1e-15), DoubleNear(1.0, 0)));
  EXPECT_THAT(benjamini_hochberg(std::vector{.9, .01}), ElementsAre(DoubleNear(.9, 0), DoubleNear(.02, 1e-15)));
  EXPECT_TRUE(holm({}).empty());
  EXPECT_TRUE(benjamini_hochberg({}).empty());
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
  const std::vector<ValuePair> opposite{{3, -3}, {-1, 1}, {2, -2}};
  EXPECT_NEAR(*variance_ratio(opposite), 0.0, 1e-12);
  const std::vector<ValuePair> equal{{1, 1}, {1, 1}};
  EXPECT_FALSE(variance_ratio(equal).has_value());
  std::vector<ValuePair> all;  // every combination of 1..6: independent, but for divisors 35 and 71
  for (int a = 1; a <= 6; ++a) {
    for (int b = 1; b <= 6; ++b) all.push_back({double(a), double(b)});
  }
  EXPECT_NEAR(*variance_ratio(all), (36.0 / 35.0) / (72.0 / 71.0), 1e-12);
}

TEST(VarianceRatio, FromMomentsIsThatOfTheValues) {
  const std::vector<ValuePair> pairs{{3, 1}, {-1, 0}, {2, -2}, {0.5, 4}};
  Moments means, all;
  for (const auto& [first, second] : pairs) {
    means.add((first + second) / 2.0);
    all.add(first);
    all.add(second);
  }
  EXPECT_NEAR(*variance_ratio(means, all), *variance_ratio(pairs), 1e-12);
  EXPECT_FALSE(variance_ratio(Moments(std::vector{1.0, 1.0}), Moments(std::vector{1.0, 1.0, 1.0, 1.0})).has_value());
}

}  // namespace
}  // namespace regista::statistics
