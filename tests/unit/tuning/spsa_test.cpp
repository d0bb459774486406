// SPDX-License-Identifier: MIT
#include "study/tuning/stochastic_search.hpp"

#include <gmock/gmock.h>

#include "landscape.hpp"

namespace regista::study {
namespace {

// Values of a tester of chess engines, published with its own tests.
TEST(Spsa, PerturbationAndStepOfATester) {
  EXPECT_NEAR(spsa_perturbation(1.6, 2), 1.431960, 5e-7);
  EXPECT_EQ(spsa_perturbation(1.6, 0), 1.6) << "k counts from 0";
  EXPECT_EQ(spsa_step(10.0, 0.5, 2.0, 3.0, 1.0), 13.0);
  EXPECT_EQ(spsa_step(10.0, 0.5, 2.0, 3.0, -1.0), 7.0);
}

TEST(Spsa, GainsAreThoseOfTheLastIteration) {
  for (const std::uint64_t iterations : {1u, 10u, 5000u}) {
    const SpsaSchedule schedule({0.07, 0.003}, iterations);
    EXPECT_NEAR(schedule.c(iterations - 1), 0.07, 1e-12);
    EXPECT_NEAR(schedule.r(iterations - 1), 0.003, 1e-12);
  }
  // By hand: N = 10, A = 1, c = 0.1 10^0.101 = 0.126183, a = 0.02 0.01 11^0.602 = 8.4712e-4; at k = 0 the gain is
  // a / 2^0.602 / c^2 = 0.0350522.
  const SpsaSchedule schedule({0.1, 0.02}, 10);
  EXPECT_NEAR(schedule.c(0), 0.126183, 1e-6);
  EXPECT_NEAR(schedule.r(0), 0.035052, 1e-5);
}

TEST(Spsa, DefaultGainsCarryAsFarWithAnyNumberOfIterations) {
  for (const std::uint64_t iterations : {100u, 500u, 20000u}) {
    const SpsaSchedule schedule(spsa_gains(iterations), iterations);
    double travel = 0.0;
    for (std::uint64_t k = 0; k < iterations; ++k) travel += schedule.r(k) * schedule.c(k);
    EXPECT_NEAR(travel, 4.8, 0.5) << iterations;
  }
}

TEST(RunningScale, IsTheRootMeanSquareWithoutTheLargest) {
  RunningScale scale;
  EXPECT_EQ(scale.scaled(0.0), 0.0);
  EXPECT_EQ(scale.scaled(-7.0), -1.0) << "nothing but itself to compare with";
  RunningScale other;
  other.scaled(-100.0);
  other.scaled(4.0);
  EXPECT_DOUBLE_EQ(other.scaled(2.0), 2.0 / std::sqrt(10.0)) << "squares 16 and 4, the largest left out";
}

// Twice the normal law without its largest twentieth has a root mean square of 1.738.
TEST(RunningScale, OfTheNormalLaw) {
  Rng draws(3, Rng::Use::spsa);
  RunningScale scale;
  for (int i = 0; i < 100000; ++i) scale.scaled(2.0 * draws.normal());
  EXPECT_NEAR(1.0 / scale.scaled(1.0), 1.738, 0.02);
}

TEST(RunningScale, AnOutlierCountsForLittleAndIsForgotten) {
  RunningScale scale;
  for (int i = 0; i < 100; ++i) scale.scaled(i % 2 == 0 ? 1.0 : -1.0);
  EXPECT_EQ(scale.scaled(-1e12), -RunningScale::most);
  EXPECT_NEAR(scale.scaled(1.0), 1.0, 0.05);
}

// The first difference of all may be the outlier: nothing is known then to compare it with.
TEST(RunningScale, AnOutlierAtTheBeginning) {
  RunningScale scale;
  scale.scaled(1e12);
  double result = 0.0;
  for (int i = 0; i < 30; ++i) result = scale.scaled(1.0);
  EXPECT_NEAR(result, 1.0, 1e-9);
}

const Point optimum = point({0.4, 0.55, 0.6});

SearchResult noisy_search(std::vector<Asked>& record, double scale, int outlier, double value) {
  SearchSettings settings;
  settings.start = point({0.8, 0.1, 0.3});
  settings.evaluations = 2000;
  int number = 0;
  return search(Algorithm::spsa, settings,
                recorded(record, [&, noisy = NoisySphere(optimum, 0.05, 3)](const Point& x) mutable {
                  const double answer = scale * noisy(x);
                  return ++number == outlier ? value : answer;
                }));
}

TEST(Spsa, TheScaleOfTheObjectiveDoesNotMatter) {
  std::vector<Asked> one, large, small;
  noisy_search(one, 1.0, 0, 0.0);
  noisy_search(large, 0x1p20, 0, 0.0);
  noisy_search(small, 0x1p-20, 0, 0.0);
  EXPECT_EQ(one, large);
  EXPECT_EQ(one, small);
}

TEST(Spsa, OneCrashDoesNotDestroyTheRun) {
  std::vector<Asked> record;
  const double without = (noisy_search(record, 1.0, 0, 0.0).recommended.front() - optimum).norm();
  EXPECT_LT(without, 0.03);
  for (const int outlier : {1, 2, 40, 1000, 1999}) {
    const Point found = noisy_search(record, 1.0, outlier, -1e9).recommended.front();
    EXPECT_LT((found - optimum).norm(), 0.06) << outlier;
  }
}

TEST(Spsa, BothPointsOfAnIterationAreAsFarFromTheirMiddle) {
  SearchSettings settings;
  settings.start = point({0.0, 1.0, 0.5});
  settings.evaluations = 400;
  std::vector<Asked> record;
  search(Algorithm::spsa, settings, recorded(record, [](const Point& x) { return -x.sum(); }));
  const SpsaSchedule schedule(spsa_gains(200), 200);
  ASSERT_EQ(record.size(), 200u);
  for (std::uint64_t k = 0; k < 200; ++k) {
    const Point difference = record[k].points[0] - record[k].points[1];
    for (const double each : difference) EXPECT_NEAR(std::abs(each), 2.0 * schedule.c(k), 1e-12);
  }
}

TEST(Spsa, RecommendsItsEstimatesAndTheStart) {
  std::vector<Asked> record;
  const SearchResult result = noisy_search(record, 1.0, 0, 0.0);
  ASSERT_EQ(result.recommended.size(), 4u);
  EXPECT_EQ(result.recommended.back(), point({0.8, 0.1, 0.3}));
}

}  // namespace
}  // namespace regista::study
