// SPDX-License-Identifier: MIT
#include "statistics/sequential_test.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "statistics/rating.hpp"

namespace regista::statistics {
namespace {

PairOutcome drawn(std::mt19937_64& random, const std::array<int, 5>& weights) {
  int sum = 0;
  for (const int weight : weights) sum += weight;
  int left = static_cast<int>(random() % static_cast<std::uint64_t>(sum));
  std::size_t outcome = 0;
  while (left >= weights[outcome]) left -= weights[outcome++];
  return static_cast<PairOutcome>(outcome);
}

TEST(SequentialBounds, Wald) {
  const SequentialBounds bounds = sequential_bounds({0.05, 0.05});
  EXPECT_NEAR(bounds.lower, -2.944439, 1e-6);
  EXPECT_NEAR(bounds.upper, 2.944439, 1e-6);
  EXPECT_NEAR(sequential_bounds({0.01, 0.2}).lower, std::log(0.2 / 0.99), 1e-15);
  EXPECT_NEAR(sequential_bounds({0.01, 0.2}).upper, std::log(80.0), 1e-14);
}

TEST(Overshoot, OfStepsByHand) {
  Overshoot overshoot;
  EXPECT_EQ(overshoot.above(), 0.0);
  for (const double ratio : {0.5, 0.2, 0.8, -0.1, 1.0, -0.4}) overshoot.update(ratio);
  // Highest: 0.5, 0.8, 1.0; lowest: -0.1, -0.4.
  EXPECT_NEAR(overshoot.above(), (0.25 + 0.09 + 0.04) / (2.0 * 1.0), 1e-15);
  EXPECT_NEAR(overshoot.below(), (0.01 + 0.09) / (2.0 * 0.4), 1e-15);
}

TEST(Overshoot, OfEqualStepsIsHalfAStep) {
  Overshoot overshoot;
  for (int i = 1; i < 30; ++i) overshoot.update(0.1 * i);
  EXPECT_NEAR(overshoot.above(), 0.05, 1e-12);
  EXPECT_EQ(overshoot.below(), 0.0);
}

TEST(SequentialTest, TellsTheRatioOfItsCounts) {
  SequentialTest test({Model::logistic, {0, 10}, {}, false});
  std::mt19937_64 random(4);
  EXPECT_EQ(test.ratio().value, 0.0);
  for (int i = 0; i < 100; ++i) test.add(drawn(random, {1, 2, 3, 2, 1}));
  ASSERT_EQ(test.verdict(), Verdict::inconclusive);
  EXPECT_EQ(total(test.counts()), 100);
  EXPECT_EQ(test.ratio().value, log_likelihood_ratio(score_law(test.counts()), Model::logistic, {0, 10}).value);
}

TEST(SequentialTest, StopsAndStays) {
  for (const bool better : {true, false}) {
    SequentialTest test({Model::normalized, {-20, 20}, {}, true});
    std::mt19937_64 random(5);
    const std::array<int, 5> weights = better ? std::array{1, 2, 4, 4, 3} : std::array{3, 4, 4, 2, 1};
    int fed = 0;
    while (test.verdict() == Verdict::inconclusive && fed < 10000) {
      test.add(drawn(random, weights));
      ++fed;
    }
    EXPECT_EQ(test.verdict(), better ? Verdict::accept_h1 : Verdict::accept_h0);
    EXPECT_EQ(total(test.counts()), fed);
    const PairCounts stopped = test.counts();
    for (int i = 0; i < 100; ++i) test.add(better ? PairOutcome::two_losses : PairOutcome::two_wins);
    EXPECT_EQ(test.counts(), stopped);
    EXPECT_EQ(test.verdict(), better ? Verdict::accept_h1 : Verdict::accept_h0);
  }
}

TEST(SequentialTest, CorrectionStopsNoLater) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SequentialTest with({Model::normalized, {0, 40}, {}, true}), without({Model::normalized, {0, 40}, {}, false});
    std::mt19937_64 random(seed);
    for (int i = 0; i < 5000 && without.verdict() == Verdict::inconclusive; ++i) {
      const PairOutcome outcome = drawn(random, {2, 3, 4, 3, 2});
      with.add(outcome);
      without.add(outcome);
    }
    EXPECT_NE(without.verdict(), Verdict::inconclusive);
    EXPECT_NE(with.verdict(), Verdict::inconclusive);
    EXPECT_LE(total(with.counts()), total(without.counts()));
    EXPECT_GE(with.stopping().lower, with.bounds().lower);
    EXPECT_LE(with.stopping().upper, with.bounds().upper);
  }
}

// Even pairs alone: each takes as much off the ratio, so the bound less half a step is reached by arithmetic. Between
// hypotheses as far on either side they never decide.
TEST(SequentialTest, EqualTeamsAreNotStronger) {
  const double n1 = 50 / normalized_elo_scale, step = std::log(1 + 2 * n1 * n1);
  SequentialTest test({Model::normalized, {0, 50}, {}, true});
  int fed = 0;
  while (fed < 20000 && test.add(PairOutcome::even) == Verdict::inconclusive) ++fed;
  EXPECT_EQ(test.verdict(), Verdict::accept_h0);
  EXPECT_NEAR(fed, (2.944439 - step / 2) / step, 2.0);
  SequentialTest between({Model::normalized, {-50, 50}, {}, true});
  for (int i = 0; i < 5000; ++i) ASSERT_EQ(between.add(PairOutcome::even), Verdict::inconclusive);
}

TEST(SequentialTest, HopelessTeamIsRejected) {
  EXPECT_EQ(verdict_on(log_likelihood_ratio(score_law(PairCounts{{20, 0, 0, 0, 0}}), Model::normalized, {-1500, -500}),
                       sequential_bounds({})),
            Verdict::accept_h0);
  EXPECT_EQ(verdict_on(log_likelihood_ratio(score_law(PairCounts{{144, 3, 1, 0, 0}}), Model::normalized, {-1500, -500}),
                       sequential_bounds({})),
            Verdict::accept_h0);
}

}  // namespace
}  // namespace regista::statistics
