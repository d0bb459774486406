// SPDX-License-Identifier: MIT
// Counts and what they say about strength, against numbers that the tests of fastchess and fishtest publish.
#include "statistics/rating.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "statistics/moments.hpp"

namespace regista::statistics {
namespace {

GameCounts games(Count losses, Count draws, Count wins) { return {{losses, draws, wins}}; }

TEST(Counts, PairsAreTheSumOfTheirGames) {
  using enum GameOutcome;
  EXPECT_EQ(pair_outcome(loss, loss), PairOutcome::two_losses);
  EXPECT_EQ(pair_outcome(loss, draw), PairOutcome::loss_and_draw);
  EXPECT_EQ(pair_outcome(draw, loss), PairOutcome::loss_and_draw);
  EXPECT_EQ(pair_outcome(loss, win), PairOutcome::even);
  EXPECT_EQ(pair_outcome(win, loss), PairOutcome::even);
  EXPECT_EQ(pair_outcome(draw, draw), PairOutcome::even);
  EXPECT_EQ(pair_outcome(win, draw), PairOutcome::win_and_draw);
  EXPECT_EQ(pair_outcome(win, win), PairOutcome::two_wins);
  PairCounts counts;
  counts.add(PairOutcome::even);
  counts.add(PairOutcome::two_wins);
  EXPECT_EQ(counts, (PairCounts{{0, 0, 1, 0, 1}}));
  EXPECT_EQ(swapped(counts), (PairCounts{{1, 0, 1, 0, 0}}));
  EXPECT_EQ(total(counts), 2);
}

TEST(ScoreLaw, MomentsOfCountsWithoutZeros) {
  const ScoreLaw law = score_law(PairCounts{{1, 2, 3, 2, 2}});
  EXPECT_DOUBLE_EQ(law.units, 10.0);
  EXPECT_DOUBLE_EQ(law.mean, (0.5 + 1.5 + 1.5 + 2.0) / 10.0);
  EXPECT_NEAR(law.variance, (2 * 0.0625 + 3 * 0.25 + 2 * 0.5625 + 2.0) / 10.0 - 0.55 * 0.55, 1e-15);
  EXPECT_EQ(law.variation, Variation::some);
}

TEST(ScoreLaw, OutcomesNeverSeenCountAThousandth) {
  const ScoreLaw law = score_law(games(0, 0, 4));
  EXPECT_DOUBLE_EQ(law.units, 4.002);
  EXPECT_DOUBLE_EQ(law.probabilities[0], 0.001 / 4.002);
  EXPECT_GT(law.variance, 0.0);
  EXPECT_EQ(law.variation, Variation::one_sided);
  EXPECT_EQ(score_law(games(0, 7, 0)).variation, Variation::none);
  EXPECT_EQ(score_law(PairCounts{{0, 0, 7, 0, 0}}).variation, Variation::none);
  EXPECT_EQ(score_law(PairCounts{{0, 7, 0, 0, 0}}).variation, Variation::one_sided);
}

// Published margins take the spread as known. With its uncertainty they grow by E. Mertens's formula, and for Student's
// law in the place of the normal one.
double uncertain_spread(const ScoreLaw& law) {
  const double sd = std::sqrt(law.variance), effect = (law.mean - 0.5) / sd;
  double skewness = 0.0, kurtosis = 0.0;
  for (std::size_t i = 0; i < law.outcomes; ++i) {
    const double z = (law.scores[i] - law.mean) / sd;
    skewness += law.probabilities[i] * z * z * z;
    kurtosis += law.probabilities[i] * z * z * z * z;
  }
  const double variance = 1.0 - effect * skewness + effect * effect * (kurtosis - 1.0) / 4.0;
  return std::sqrt(variance * law.units / (law.units - 1.0)) * student_t_quantile(0.975, law.units - 1.0) / 1.959964;
}

// Published margins of Elo take the spread as known and divide by the number of units. Student's law and the variance
// of a sample make them wider.
double by_student(const ScoreLaw& law) {
  return std::sqrt(law.units / (law.units - 1.0)) * student_t_quantile(0.975, law.units - 1.0) / 1.959964;
}

TEST(Rating, PublishedGames) {
  const ScoreLaw law = score_law(games(96, 111, 136));
  EXPECT_NEAR(elo(law).value, 40.70, 0.005);
  EXPECT_NEAR(elo(law).margin() / by_student(law), 30.43, 0.01);
  EXPECT_NEAR(normalized_elo(law).value, 49.77, 0.005);
  EXPECT_NEAR(normalized_elo(law).margin() / uncertain_spread(law), 36.77, 0.005);
  EXPECT_NEAR(*likelihood_of_superiority(law), 0.9960, 0.001);
  const ScoreLaw weaker = score_law(games(89, 123, 76));
  EXPECT_NEAR(normalized_elo(weaker).value, -20.76, 0.005);
  EXPECT_NEAR(normalized_elo(weaker).margin() / uncertain_spread(weaker), 40.13, 0.005);
  EXPECT_NEAR(*likelihood_of_superiority(weaker), 0.1553, 0.001);
}

TEST(Rating, PublishedPairs) {
  const ScoreLaw law = score_law(PairCounts{{34, 54, 63, 64, 75}});
  EXPECT_NEAR(elo(law).value, 55.58, 0.005);
  EXPECT_NEAR(elo(law).margin() / by_student(law), 27.65, 0.01);
  EXPECT_NEAR(normalized_elo(law).value, 57.94, 0.005);
  EXPECT_NEAR(normalized_elo(law).margin() / uncertain_spread(law), 28.28, 0.005);
  EXPECT_NEAR(*likelihood_of_superiority(law), 1.0, 0.0001);
  const ScoreLaw weaker = score_law(PairCounts{{332, 433, 498, 333, 334}});
  EXPECT_NEAR(elo(weaker).value, -8.64, 0.005);
  EXPECT_NEAR(elo(weaker).margin() / by_student(weaker), 10.33, 0.01);
  EXPECT_NEAR(normalized_elo(weaker).value, -9.17, 0.005);
  EXPECT_NEAR(normalized_elo(weaker).margin() / uncertain_spread(weaker), 10.96, 0.005);
  EXPECT_NEAR(*likelihood_of_superiority(weaker), 0.0505, 0.0001);
}

TEST(Rating, PublishedPairsInFullPrecision) {
  const ScoreLaw law = score_law(PairCounts{{10789, 19328, 33806, 19402, 10543}});
  EXPECT_NEAR(elo(law).value, -0.7735773359165423, 1e-9);
  EXPECT_NEAR(elo(law).margin() / by_student(law), 1.2775798957280218, 1e-6);
  EXPECT_NEAR(*likelihood_of_superiority(law), 0.1176588580327751, 1e-5);
  EXPECT_NEAR(normalized_elo(law).value, -0.9516290044726476, 1e-9);
}

// A share p of pairs won and drawn beside even ones: the effect is sqrt(p / (1 - p)), whose standard deviation is
// 1 / (2 (1 - p) sqrt(pairs)).
TEST(Rating, NormalizedEloOfTwoOutcomes) {
  const ScoreLaw law = score_law(PairCounts{{0, 0, 30000, 10000, 0}});
  const double scale = normalized_elo_scale / std::sqrt(2.0);
  EXPECT_NEAR(normalized_elo(law).value, scale * std::sqrt(1.0 / 3.0), 1e-3);
  EXPECT_NEAR(normalized_elo(law).margin(), scale * 1.959964 / (1.5 * 200.0), 1e-3);
}

TEST(Rating, NormalizedEloHasNoIntervalOfFewUnevenPairs) {
  const auto few = [](const PairCounts& counts) {
    const ScoreLaw law = score_law(counts);
    EXPECT_EQ(normalized_elo(law).interval.bounded(), few_for_spread(law) == FewForSpread::no);
    EXPECT_EQ(few_for_spread(law), few_for_spread(score_law(swapped(counts))));
    return few_for_spread(law);
  };
  EXPECT_EQ(few({{1, 1, 300, 4, 3}}), FewForSpread::uneven);
  EXPECT_EQ(few({{1, 1, 300, 4, 4}}), FewForSpread::no);
  EXPECT_EQ(few({{0, 0, 0, 7, 13}}), FewForSpread::won);
  EXPECT_EQ(few({{0, 0, 1, 7, 13}}), FewForSpread::no);
  EXPECT_EQ(few({{0, 1, 0, 7, 13}}), FewForSpread::no);
  EXPECT_EQ(few_for_spread(score_law(games(0, 0, 30))), FewForSpread::won);
  EXPECT_EQ(few_for_spread(score_law(games(3, 50, 6))), FewForSpread::uneven);
  EXPECT_EQ(few_for_spread(score_law(games(0, 1, 30))), FewForSpread::no);
}

TEST(Rating, EloAndScoreAreInverse) {
  for (const double rating : {-1500.0, -10.0, 0.0, 3.5, 400.0}) {
    EXPECT_NEAR(elo_of_score(score_of_elo(rating)), rating, 1e-9);
  }
  EXPECT_NEAR(score_of_elo(400.0), 10.0 / 11.0, 1e-15);
  EXPECT_EQ(elo_of_score(0.0), -HUGE_VAL);
  EXPECT_EQ(elo_of_score(1.0), HUGE_VAL);
  EXPECT_DOUBLE_EQ(normalized_elo_scale, 800.0 / std::log(10.0));
}

TEST(Rating, SwappingTheTeamsNegates) {
  const PairCounts counts{{34, 54, 63, 64, 75}};
  const ScoreLaw one = score_law(counts), other = score_law(swapped(counts));
  EXPECT_NEAR(elo(one).value, -elo(other).value, 1e-10);
  EXPECT_NEAR(elo(one).interval.low, -elo(other).interval.high, 1e-10);
  EXPECT_NEAR(normalized_elo(one).value, -normalized_elo(other).value, 1e-10);
  EXPECT_NEAR(*likelihood_of_superiority(one), 1.0 - *likelihood_of_superiority(other), 1e-14);
}

TEST(Rating, WithoutSpreadNothingIsCertain) {
  const ScoreLaw even = score_law(PairCounts{{0, 0, 500, 0, 0}});
  EXPECT_NEAR(elo(even).value, 0.0, 1e-12);
  EXPECT_NEAR(normalized_elo(even).value, 0.0, 1e-9);
  EXPECT_FALSE(likelihood_of_superiority(even));
  EXPECT_FALSE(elo(even).interval.bounded());
  EXPECT_FALSE(normalized_elo(even).interval.bounded());
}

// Less evidence must not give more certainty: four pairs say nothing but, where all are won, a bound.
TEST(Rating, FewPairsHaveNoInterval) {
  for (const PairCounts& few :
       {PairCounts{{0, 0, 0, 3, 1}}, PairCounts{{0, 0, 0, 1, 3}}, PairCounts{{1, 2, 90, 3, 3}}}) {
    const ScoreLaw law = score_law(few);
    EXPECT_FALSE(likelihood_of_superiority(law));
    EXPECT_TRUE(elo(law).interval.unbounded());
    EXPECT_EQ(score_interval(law).low, 0.0);
    EXPECT_EQ(score_interval(law).high, 1.0);
  }
  EXPECT_TRUE(elo(score_law(PairCounts{{1, 2, 90, 3, 4}})).interval.bounded());
}

// Of n pairs won: a team that wins a pair with the probability m wins all with m^n.
TEST(Rating, AllWonIsAtLeast) {
  for (const Count pairs : {1, 4, 11, 200}) {
    const ScoreLaw won = score_law(PairCounts{{0, 0, 0, 0, pairs}}), lost = score_law(PairCounts{{pairs, 0, 0, 0, 0}});
    const Interval share = score_interval(won);
    EXPECT_NEAR(std::pow(share.low, static_cast<double>(pairs)), 0.025, 1e-12);
    EXPECT_EQ(share.high, 1.0);
    EXPECT_NEAR(score_interval(lost).high, 1.0 - share.low, 1e-15);
    EXPECT_EQ(elo(won).value, HUGE_VAL);
    EXPECT_NEAR(elo(won).interval.low, elo_of_score(share.low), 1e-9);
    EXPECT_EQ(elo(won).interval.high, HUGE_VAL);
    EXPECT_FALSE(likelihood_of_superiority(won));
  }
  EXPECT_NEAR(score_interval(score_law(PairCounts{{0, 0, 0, 12, 0}})).low, 0.75 * std::pow(0.025, 1.0 / 12.0), 1e-12);
}

// Student's interval would reach beyond 1; 18 successes of 20 have this bound in the tables of Clopper and Pearson.
TEST(Rating, BeyondTheScaleOneBoundIsLeft) {
  const Interval share = score_interval(score_law(PairCounts{{0, 0, 0, 2, 18}}));
  EXPECT_NEAR(share.low, 0.6830, 0.0001);
  EXPECT_EQ(share.high, 1.0);
  EXPECT_NEAR(score_interval(score_law(PairCounts{{18, 2, 0, 0, 0}})).high, 0.3170, 0.0001);
}

TEST(Rating, PairRatio) {
  EXPECT_DOUBLE_EQ(*pair_ratio({{34, 54, 63, 64, 75}}), 139.0 / 88.0);
  EXPECT_FALSE(pair_ratio({{0, 0, 3, 2, 0}}).has_value());
}

// Tables of the distributions, as every book of statistics prints them.
TEST(Distributions, TabledValues) {
  EXPECT_NEAR(student_t_quantile(0.975, 10), 2.2281388519649385, 1e-9);
  EXPECT_NEAR(student_t_outside(-2.2281388519649385, 10), 0.05, 1e-10);
  // One degree of freedom is Cauchy's law.
  EXPECT_NEAR(student_t_outside(1.0, 1), 0.5, 1e-12);
}

}  // namespace
}  // namespace regista::statistics
