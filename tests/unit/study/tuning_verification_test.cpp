// SPDX-License-Identifier: MIT
// How often the verdict is wrong where there is no difference, and how soon it is found where there is one; slices.
#include "study/tuning/tuning_study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "statistics/paired_tests.hpp"
#include "study/tournament_course.hpp"
#include "tuning_fixture.hpp"

namespace regista::study {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// Mean goal difference of the two matches of a pair.
double pair_score(std::mt19937& random, double better) {
  std::poisson_distribution<int> own(1.2 + better / 2.0), other(1.2 - better / 2.0);
  double sum = 0.0;
  for (int match = 0; match < 2; ++match) {
    const int difference = own(random) - other(random);
    sum += std::clamp(difference, -10, 10);
  }
  return sum / 2.0;
}

// Scores of candidate and base team that differ by `better` goals, in three laws: goal differences, points, and a
// number whose law is lopsided.
enum class Law { goals, points, lopsided };

double score_of(Law law, std::mt19937& random, double better) {
  if (law == Law::lopsided) return std::exponential_distribution<double>()(random) + better;
  const double goals = pair_score(random, better);
  return law == Law::goals ? goals : goals > 0.0 ? 1.0 : goals < 0.0 ? 0.0 : 0.5;
}

// Under the null, looked at after every pair, whatever spread was expected.
TEST(Verification, IsSeldomWrongWhereThereIsNoDifference) {
  constexpr int rounds = 400, pairs = 120;
  const double most = rounds * (0.05 + 3.0 * std::sqrt(0.05 * 0.95 / rounds));
  for (const std::size_t candidates : {1u, 3u}) {
    for (const Law law : {Law::goals, Law::points, Law::lopsided}) {
      for (const double expected : {0.1, 1.1, 10.0}) {
        std::mt19937 random(1);
        int wrong = 0, missed = 0;
        for (int round = 0; round < rounds; ++round) {
          Verification verification(candidates, 0.95, expected);
          bool any = false, outside = false;
          for (int pair = 0; pair < pairs; ++pair) {
            std::vector<double> scores;
            for (std::size_t i = 0; i < candidates; ++i) scores.push_back(score_of(law, random, 0.0));
            verification.add(score_of(law, random, 0.0), scores);
            for (const VerifiedAs each : verification.findings()) any = any || each != VerifiedAs::undecided;
            if (pair % 10 != 9) continue;
            for (const ScoreDifference& each : verification.of()) {
              outside = outside || !each.estimate().interval.contains(0.0);
            }
          }
          wrong += any ? 1 : 0;
          missed += outside ? 1 : 0;
        }
        EXPECT_LE(wrong, most) << static_cast<int>(law) << ' ' << candidates << ' ' << expected;
        EXPECT_LE(missed, most) << static_cast<int>(law) << ' ' << candidates << ' ' << expected;
      }
    }
  }
}

TEST(Verification, FindsAClearDifferenceEitherWay) {
  constexpr int rounds = 200;
  for (const Law law : {Law::goals, Law::points, Law::lopsided}) {
    for (const double better : {1.0, -1.0}) {
      std::mt19937 random(2);
      int right = 0;
      for (int round = 0; round < rounds; ++round) {
        Verification verification(1, 0.95, law == Law::points ? 0.4 : 1.1);
        for (int pair = 0; pair < 100 && !verification.decided(); ++pair) {
          const double base = score_of(law, random, 0.0), candidate = score_of(law, random, better);
          verification.add(base, std::vector{candidate});
        }
        const VerifiedAs wanted = better > 0.0 ? VerifiedAs::better : VerifiedAs::worse;
        right += verification.findings()[0] == wanted ? 1 : 0;
        EXPECT_EQ(verification.findings()[0] == VerifiedAs::undecided, !verification.decided());
      }
      EXPECT_GE(right, rounds * 95 / 100) << static_cast<int>(law) << ' ' << better;
    }
  }
}

TEST(Verification, SeveralCandidatesAreAdjustedByHolm) {
  Verification verification(3, 0.95, 1.1);
  std::mt19937 random(3);
  for (int pair = 0; pair < 140; ++pair) {
    const double base = pair_score(random, 0.0), none = pair_score(random, 0.0), some = pair_score(random, 0.6),
                 much = pair_score(random, 1.5);
    verification.add(base, std::vector{none, some, much});
  }
  std::vector<double> p;
  for (const ScoreDifference& each : verification.of()) p.push_back(each.p());
  EXPECT_EQ(verification.adjusted(), statistics::holm(p));
  EXPECT_GT(verification.adjusted()[2], p[2]);
  EXPECT_EQ(verification.findings()[2], VerifiedAs::better);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(verification.findings()[i] == VerifiedAs::undecided, verification.adjusted()[i] > 0.05) << i;
  }
  // With others beside it, its interval is wider than alone.
  Verification alone(1, 0.95, 1.1), together(3, 0.95, 1.1);
  std::mt19937 again(4);
  for (int pair = 0; pair < 60; ++pair) {
    const double base = pair_score(again, 0.0), candidate = pair_score(again, 0.5);
    alone.add(base, std::vector{candidate});
    together.add(base, std::vector{candidate, candidate, candidate});
  }
  const auto narrow = alone.of()[0].estimate().interval, wide = together.of()[0].estimate().interval;
  EXPECT_LT(wide.low, narrow.low);
  EXPECT_GT(wide.high, narrow.high);
  EXPECT_EQ(alone.of()[0].p(), together.of()[0].p());
}

TEST(Verification, PairsThatMissAScoreAreLeftOutForThatCandidate) {
  Verification verification(2, 0.95, 1.1);
  verification.add(1.0, std::vector{2.0, missing});
  verification.add(missing, std::vector{2.0, 3.0});
  verification.add(0.0, std::vector{1.0, 3.0});
  EXPECT_EQ(verification.pairs(), 3u);
  EXPECT_EQ(verification.of()[0].difference().count(), 2);
  EXPECT_EQ(verification.of()[1].difference().count(), 1);
  EXPECT_EQ(verification.of()[0].difference().mean(), 1.0);
  EXPECT_EQ(verification.of()[1].difference().mean(), 3.0);
}

TEST(Verification, NoCandidatesNeedNothing) {
  const Verification verification(0, 0.95, 1.1);
  EXPECT_TRUE(verification.decided());
  EXPECT_TRUE(verification.adjusted().empty());
}

// --- Slices -------------------------------------------------------------------------------------------------------

TEST(Slices, ValuesAreSpreadDifferentAndNotTheTunedOne) {
  TuningPlan plan = tuning_of(2, 1);
  plan.asked.slices.points = 5;
  EXPECT_EQ(slice_values(plan, {0.3, 0.5}, 0), (std::vector{0.0, 0.25, 0.5, 0.75, 1.0}));
  EXPECT_EQ(slice_values(plan, {0.3, 0.5}, 1), (std::vector{0.0, 0.25, 0.75, 1.0}));
  plan.parameters[0] = {"p0", 1.0, 0.0, 2.0, true, false, "", ""};
  EXPECT_EQ(slice_values(plan, {1.0, 0.5}, 0), (std::vector{0.0, 2.0}));
  plan.parameters[0] = {"p0", 1.0, 0.01, 100.0, false, true, "", ""};
  EXPECT_EQ(slice_values(plan, {3.0, 0.5}, 0), (std::vector{0.01, 0.1, 1.0, 10.0, 100.0}));
  plan.asked.slices.points = 1;
  EXPECT_EQ(slice_values(plan, {0.3, 0.25}, 1), (std::vector{0.5}));
}

// Scores of five points and the tuned one, on the same pairs: the effect is a parabola so high.
Slice slice_with(double effect, std::mt19937& random, std::size_t pairs) {
  const std::vector<double> values{0.0, 0.25, 0.5, 0.75, 1.0};
  std::normal_distribution<double> normal;
  std::vector<double> blocks(pairs), tuned;
  for (double& each : blocks) each = 2.0 * normal(random);
  std::vector<std::vector<double>> scores(values.size());
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      scores[i].push_back(blocks[pair] + effect * (1.0 - 4.0 * (values[i] - 0.5) * (values[i] - 0.5)) + normal(random));
    }
    tuned.push_back(blocks[pair] + effect * (1.0 - 4.0 * 0.01) + normal(random));
  }
  return slice_of(3, 0.6, values, scores, tuned, 0.95);
}

TEST(Slices, NoiseIsOfNoImportanceAndEffectsAreInTheirOrder) {
  std::mt19937 random(5);
  constexpr int rounds = 1000;
  int silent = 0, found = 0, in_order = 0;
  double mean = 0.0;
  for (int round = 0; round < rounds; ++round) {
    const Slice none = slice_with(0.0, random, 12), some = slice_with(1.0, random, 12),
                much = slice_with(3.0, random, 12);
    silent += none.importance == 0.0 ? 1 : 0;
    found += *none.p <= 0.05 ? 1 : 0;
    in_order += none.importance < some.importance && some.importance < much.importance ? 1 : 0;
    mean += much.importance / rounds;
  }
  EXPECT_GT(silent, rounds / 2);
  EXPECT_NEAR(found, 0.05 * rounds, 4.0 * std::sqrt(0.05 * 0.95 * rounds));
  EXPECT_GT(in_order, rounds * 85 / 100);
  // Deviation of 0, 0.75, 1, 0.75, 0 and 0.96 times 3.
  EXPECT_NEAR(mean, 3.0 * 0.4596, 0.03);
}

TEST(Slices, PointsAreInOrderWithTheTunedOneAmongThem) {
  std::mt19937 random(6);
  const Slice slice = slice_with(1.0, random, 8);
  EXPECT_EQ(slice.parameter, 3u);
  ASSERT_EQ(slice.points.size(), 6u);
  for (std::size_t i = 1; i < slice.points.size(); ++i) EXPECT_LT(slice.points[i - 1].value, slice.points[i].value);
  EXPECT_EQ(slice.points[3].value, 0.6);
  EXPECT_EQ(slice.points[3].difference.pairs, 0);
  for (const SlicePoint& each : slice.points) {
    if (each.value == 0.6) continue;
    EXPECT_NEAR(each.difference.mean, each.score.mean - slice.points[3].score.mean, 1e-12);
  }
}

TEST(Slices, WhatIsMissingIsLeftOut) {
  const std::vector<std::vector<double>> scores{{1.0, missing, 2.0}};
  const Slice slice = slice_of(0, 0.5, std::vector{0.0}, scores, {1.0, 5.0, 1.0}, 0.95);
  EXPECT_EQ(slice.points[0].score.pairs, 2);
  EXPECT_EQ(slice.points[0].difference.mean, 0.5);
  EXPECT_FALSE(slice_of(0, 0.5, std::vector{0.0}, std::vector<std::vector<double>>{{1.0}}, {2.0}, 0.95).p);
}

// --- MetricDifference ---------------------------------------------------------------------------------------------

TEST(MetricDifference, SignsAndMoments) {
  MetricDifference difference(0.05);
  difference.add(1.0, 3.0);
  difference.add(2.0, 2.0);
  difference.add(5.0, 1.0);
  difference.add(4.0, 1.0);
  EXPECT_EQ(difference.signs(), (std::array<std::uint64_t, 3>{1, 1, 2}));
  EXPECT_DOUBLE_EQ(difference.first().mean(), 3.0);
  EXPECT_DOUBLE_EQ(difference.second().mean(), 1.75);
  EXPECT_DOUBLE_EQ(difference.difference().mean(), 1.25);
}

TEST(MetricDifference, WithoutSpreadItsIntervalIsEverything) {
  MetricDifference difference(0.05);
  EXPECT_FALSE(difference.estimate().interval.bounded());
  difference.add(2.0, 1.0);
  difference.add(3.0, 2.0);
  EXPECT_EQ(difference.estimate().interval.low, -std::numeric_limits<double>::infinity());
}

// Of a law with heavy tails the signs still hold their level; the interval narrows as pairs come.
TEST(MetricDifference, HoldsForAnyLaw) {
  std::mt19937 random(7);
  std::cauchy_distribution<double> cauchy;
  constexpr int rounds = 400;
  int wrong = 0;
  for (int round = 0; round < rounds; ++round) {
    MetricDifference difference(0.05);
    for (int pair = 0; pair < 150; ++pair) {
      const double first = cauchy(random), second = cauchy(random);
      difference.add(first, second);
    }
    wrong += difference.test().finding() != statistics::BettingTest::Finding::none ? 1 : 0;
  }
  EXPECT_LE(wrong, rounds * (0.05 + 3.0 * std::sqrt(0.05 * 0.95 / rounds)));
}

// --- Pairs that could not be played --------------------------------------------------------------------------------

// By brute force: decided is what comes out without them and with all of them counted for either, by the same test.
TEST(Verification, WithPairsThatCouldNotBePlayedIsWhatAllWaysToCountThemSay) {
  constexpr double widest = 20.0;
  std::array<int, 4> seen{};
  for (const bool betting : {false, true}) {
    const std::optional<double> bet = betting ? std::optional(widest) : std::nullopt;
    for (unsigned round = 0; round < 200; ++round) {
      std::mt19937 random(round);
      std::array<Verification, 3> filled{Verification(1, 0.95, 1.1, bet, widest),
                                         Verification(1, 0.95, 1.1, bet, widest),
                                         Verification(1, 0.95, 1.1, bet, widest)};
      Verification all(1, 0.95, 1.1, bet, widest);
      const double better = std::array{-1.5, 0.0, 1.5, 4.0}[round % 4];
      const unsigned one_in = std::array{0u, 50u, 8u}[round % 3];
      for (int pair = 0; pair < 120; ++pair) {
        const double base = pair_score(random, 0.0), candidate = pair_score(random, better);
        const bool unplayed = one_in > 0 && random() % one_in == 0;
        all.add(base, std::vector{unplayed ? std::nan("") : candidate}, {unplayed});
        if (!unplayed) filled[0].add(base, std::vector{candidate});
        filled[1].add(unplayed ? 0.0 : base, std::vector{unplayed ? -widest : candidate});
        filled[2].add(unplayed ? 0.0 : base, std::vector{unplayed ? widest : candidate});
      }
      const VerifiedAs without = filled[0].findings()[0], lost = filled[1].findings()[0], won = filled[2].findings()[0];
      const VerifiedAs wanted = without == lost && without == won  ? without
                                : without == VerifiedAs::undecided ? VerifiedAs::undecided
                                                                   : VerifiedAs::prevented;
      EXPECT_EQ(all.findings()[0], wanted) << round;
      EXPECT_EQ(all.of()[0].difference().count(), filled[0].of()[0].difference().count());
      EXPECT_EQ(all.of()[0].estimate().value, filled[0].of()[0].estimate().value);
      ++seen[static_cast<std::size_t>(all.findings()[0])];
    }
  }
  for (const int each : seen) EXPECT_GT(each, 5);
}

// A candidate whose lost pairs cannot be played.
TEST(Verification, NobodyIsBetterByPairsThatCouldNotBePlayed) {
  for (const bool bounded : {false, true}) {
    int tempting = 0;
    for (unsigned round = 0; round < 100; ++round) {
      std::mt19937 random(round);
      const std::optional<double> bound = bounded ? std::optional(20.0) : std::nullopt;
      Verification honest(1, 0.95, 1.1), sly(1, 0.95, 1.1, {}, bound);
      for (int pair = 0; pair < 200; ++pair) {
        const double base = pair_score(random, 0.0), candidate = pair_score(random, -0.5);
        const bool unplayed = candidate < base;
        if (!unplayed) honest.add(base, std::vector{candidate});
        sly.add(base, std::vector{unplayed ? std::nan("") : candidate}, {unplayed});
      }
      if (honest.findings()[0] == VerifiedAs::better) ++tempting;
      EXPECT_NE(sly.findings()[0], VerifiedAs::better);
      EXPECT_GT(sly.unplayed_pairs(), 0u);
    }
    EXPECT_GT(tempting, 90);
  }
}

// What has no bound could have been anything.
TEST(Verification, WithoutABoundOnePairIsEnoughToPreventIt) {
  std::mt19937 random(5);
  Verification verification(2, 0.95, 1.1);
  for (int pair = 0; pair < 200; ++pair) {
    const double base = pair_score(random, 0.0);
    verification.add(base, std::vector{pair_score(random, 3.0), pair_score(random, 3.0)}, {pair == 7, false});
  }
  EXPECT_EQ(verification.findings()[0], VerifiedAs::prevented);
  EXPECT_EQ(verification.findings()[1], VerifiedAs::better);
  EXPECT_TRUE(verification.decided());
  EXPECT_EQ(verification.unplayed_pairs(), 1u);
}

}  // namespace
}  // namespace regista::study
