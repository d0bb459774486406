// SPDX-License-Identifier: MIT
#include "study/experiment_course.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "experiment_fixture.hpp"

namespace regista::study {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

TEST(PairedEstimates, MeanAndIntervalAreThoseOfTheTables) {
  // Student 1908, from A. R. Cushny and A. R. Peebles, 1905: hours of sleep gained by two drugs, ten patients each;
  // difference 1.58 hours, t = 4.06, p = 0.0028, 95 % from 0.70 to 2.46.
  const std::vector<double> first{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};
  const std::vector<double> second{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
  const MeanEstimate difference = mean_of(paired_differences(first, second), 0.95);
  EXPECT_EQ(difference.pairs, 10);
  EXPECT_NEAR(difference.mean, 1.58, 1e-12);
  ASSERT_TRUE(difference.interval);
  EXPECT_NEAR(difference.interval->low, 0.7001, 1e-4);
  EXPECT_NEAR(difference.interval->high, 2.4599, 1e-4);
  EXPECT_NEAR(p_of_values(paired_differences(first, second), PairTest::paired_t)->p, 0.002833, 1e-6);
  const MeanEstimate back = mean_of(paired_differences(second, first), 0.95);
  EXPECT_DOUBLE_EQ(back.mean, -difference.mean);
  EXPECT_DOUBLE_EQ(back.interval->low, -difference.interval->high);
}

TEST(PairedEstimates, WhatIsMissingLeavesItsPairOut) {
  const std::vector<double> first{1.0, nothing, 3.0, 8.0}, second{0.5, 4.0, nothing, 5.0};
  EXPECT_EQ(mean_of(first, 0.95).pairs, 3);
  EXPECT_DOUBLE_EQ(mean_of(first, 0.95).mean, 4.0);
  EXPECT_EQ(mean_of(paired_differences(first, second), 0.95).pairs, 2);
  EXPECT_DOUBLE_EQ(mean_of(paired_differences(first, second), 0.95).mean, 1.75);
}

TEST(PairedEstimates, WithoutSpreadThereIsNoInterval) {
  EXPECT_FALSE(mean_of(std::vector<double>{2.0}, 0.95).interval);
  EXPECT_FALSE(mean_of(std::vector<double>{2.0, 2.0, 2.0}, 0.95).interval);
  EXPECT_EQ(mean_of({}, 0.95).pairs, 0);
  const std::vector<double> one{1.0}, ones{1.0, 1.0}, twos{2.0, 2.0};
  EXPECT_FALSE(p_of_values(paired_differences(one, one), PairTest::paired_t));
  EXPECT_FALSE(mean_of(paired_differences(twos, ones), 0.95).interval);
}

// Of N equal differences two of the 2^N assignments of signs have a sum as far from 0.
TEST(PairedEstimates, WithoutSpreadSignsAreCountedInsteadOfStudentsT) {
  for (const std::size_t pairs : {2u, 8u, 32u, 33u}) {
    const std::vector<double> ones(pairs, 1.0), threes(pairs, 3.0);
    const auto none = p_of_values(paired_differences(ones, ones), PairTest::paired_t);
    ASSERT_TRUE(none);
    EXPECT_EQ(none->p, 1.0);
    const auto t = p_of_values(paired_differences(threes, ones), PairTest::paired_t);
    const auto signs = p_of_values(paired_differences(threes, ones), PairTest::sign_flip);
    ASSERT_TRUE(t && signs);
    EXPECT_EQ(t->p, signs->p);
    EXPECT_EQ(t->by, signs->by);
    const auto count = static_cast<double>(pairs);
    EXPECT_EQ(t->by, PairMethod::sign_flip);
    EXPECT_NEAR(t->p / std::pow(2.0, 1.0 - count), 1.0, 1e-12);
  }
}

// Everything again by hand: minutes in 60 minutes of play over both matches of a pair, means of what is no time.
TEST(Experiment, ValuesAreThoseOfThePairs) {
  const ExperimentPlan plan = experiment_of(2, 1, 2);
  Experiment course(plan);
  struct Result {
    double overlap;
    int packets, own, other;
    double seconds;
  };
  const std::array<Result, 8> results{{{6, 100, 1, 0, 600},
                                       {12, 120, 0, 0, 300},
                                       {0, 80, 2, 3, 600},
                                       {3, 90, 0, 1, 600},
                                       {30, 110, 1, 1, 600},
                                       {0, 130, 4, 0, 600},
                                       {9, 70, 0, 0, 600},
                                       {9, 60, 1, 0, 600}}};
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    EXPECT_FALSE(course.complete());
    const Result& each = results[index];
    course.take(played(trial(plan, index).side, each.overlap, each.packets, each.own, each.other, each.seconds));
  }
  EXPECT_TRUE(course.complete());
  EXPECT_DOUBLE_EQ(course.playing_seconds(0), 2100.0);
  EXPECT_DOUBLE_EQ(course.values(0, 0)[0], 60.0 * 18.0 / 900.0);
  EXPECT_DOUBLE_EQ(course.values(0, 0)[1], 60.0 * 30.0 / 1200.0);
  EXPECT_DOUBLE_EQ(course.values(1, 0)[0], 60.0 * 3.0 / 1200.0);
  EXPECT_DOUBLE_EQ(course.values(1, 0)[1], 60.0 * 18.0 / 1200.0);
  EXPECT_DOUBLE_EQ(course.per_match(0, 0)[0], 9.0);
  EXPECT_DOUBLE_EQ(course.values(0, 1)[0], 110.0);
  EXPECT_DOUBLE_EQ(course.values(1, 2)[0], 1.0);
  EXPECT_DOUBLE_EQ(course.values(0, 3)[0], 0.75);  // a win and a draw
  EXPECT_DOUBLE_EQ(course.mean(0, 0).mean, (1.2 + 1.5) / 2.0);
  EXPECT_DOUBLE_EQ(course.difference({0, 1}, 0).mean, ((1.2 - 0.15) + (1.5 - 0.9)) / 2.0);
}

TEST(Experiment, AForfeitLeavesItsPairOut) {
  const ExperimentPlan plan = experiment_of(2, 1, 2);
  Experiment course(plan);
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    const Trial each = trial(plan, index);
    if (index == 1) {
      course.take(campaign::forfeit({static_cast<int>(each.side), "greedy", "assign", 3, 417, "hangs"}, 1.0));
    } else if (index == 6) {
      course.take(campaign::forfeit({static_cast<int>(1 - each.side), "greedy", "assign", 3, 417, "hangs"}, 1.0));
    } else {
      course.take(played(each.side, 10.0 + static_cast<double>(index), 1, 0, 0));
    }
  }
  EXPECT_TRUE(std::isnan(course.values(0, 0)[0]));
  EXPECT_TRUE(std::isnan(course.values(0, 2)[0])) << "goals of a match that was not played to its end";
  EXPECT_TRUE(std::isnan(course.values(1, 0)[1]));
  EXPECT_EQ(course.mean(0, 0).pairs, 1);
  EXPECT_EQ(course.difference({0, 1}, 0).pairs, 0);
  ASSERT_EQ(course.forfeits().listed().size(), 2u);
  EXPECT_EQ(course.forfeits().of_team(), (std::vector<std::uint64_t>{1, 0, 1}));
}

TEST(Experiment, ComparisonsAreTestedAtTheEndAloneAndCorrected) {
  const ExperimentPlan plan = experiment_of(3, 1, 6);
  Experiment course(plan);
  const auto overlap = [](std::size_t arm, std::uint64_t pair) {
    const double noise = static_cast<double>(pair % 3);
    return arm == 0 ? 10.0 + noise : arm == 1 ? 12.5 - 1.2 * noise : 40.0 + 2.0 * noise;
  };
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    for (const Finding& each : findings(plan, course).comparisons) EXPECT_FALSE(each.p || each.found);
    const Trial each = trial(plan, index);
    course.take(played(each.side, overlap(each.condition, each.pair), 1, 0, 0));
  }
  const std::vector<Finding> found = findings(plan, course).comparisons;
  ASSERT_EQ(found.size(), 3u);
  // Holm by hand: the smallest p three times, the next twice, the largest once, never falling.
  std::vector<double> p;
  for (const Finding& each : found) p.push_back(each.p.value());
  std::vector<double> sorted = p;
  std::sort(sorted.begin(), sorted.end());
  double before = 0.0;
  for (std::size_t rank = 0; rank < 3; ++rank) {
    before = std::max(before, std::min(1.0, sorted[rank] * static_cast<double>(3 - rank)));
    const auto at = static_cast<std::size_t>(std::find(p.begin(), p.end(), sorted[rank]) - p.begin());
    EXPECT_DOUBLE_EQ(found[at].adjusted.value(), before);
    EXPECT_EQ(found[at].found, before <= 1.0 - plan.asked.confidence);
  }
  for (const Finding& each : found) EXPECT_EQ(each.found, each.comparison.second == 2);
}

// Arm 1 has 2 more than arm 0 in every pair; arm 2 has no pair with values, and is one of three comparisons all the
// same.
TEST(Experiment, EveryComparisonOfThePlanCountsForHolm) {
  const ExperimentPlan plan = experiment_of(3, 1, 6);
  Experiment course(plan);
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    const Trial each = trial(plan, index);
    if (each.condition == 2) {
      course.take(campaign::forfeit({static_cast<int>(each.side), "greedy", "assign", 3, 417, "hangs"}, 1.0));
    } else {
      course.take(played(each.side, each.condition == 0 ? 10.0 : 30.0, 1, 0, 0));
    }
  }
  for (const Finding& each : findings(plan, course).comparisons) {
    const bool both = each.comparison.first != 2 && each.comparison.second != 2;
    ASSERT_EQ(each.p.has_value(), both);
    ASSERT_EQ(each.adjusted.has_value(), both);
    if (!both) continue;
    EXPECT_EQ(each.by, PairMethod::sign_flip);
    EXPECT_DOUBLE_EQ(*each.p, 2.0 / 64.0);
    EXPECT_DOUBLE_EQ(*each.adjusted, 3.0 * 2.0 / 64.0);
    EXPECT_FALSE(each.found);
  }
  EXPECT_DOUBLE_EQ(course.playing_seconds_of_a_match(0).value(), 600.0);
  EXPECT_FALSE(course.playing_seconds_of_a_match(2));
}

}  // namespace
}  // namespace regista::study
