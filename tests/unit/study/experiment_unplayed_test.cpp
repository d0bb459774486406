// SPDX-License-Identifier: MIT
// Pairs of an experiment that could not be played: they have no values, and no finding rests on what they might have
// shown.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

#include "experiment_fixture.hpp"
#include "statistics/paired_tests.hpp"
#include "study/paired_estimates.hpp"

namespace regista::study {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

campaign::MatchResult unplayed() {
  campaign::MatchResult out;
  out.ended = "set_aside";
  out.why_set_aside = "Aborted";
  return out;
}

// Two arms whose overlap is that given, in minutes of an hour; not a number: not played, the second match of it.
struct Shown {
  std::vector<double> first, second;
};

std::vector<Finding> found(const ExperimentPlan& plan, const Shown& shown, Experiment& course) {
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    const Trial trial = study::trial(plan, index);
    const double value = (trial.condition == 0 ? shown.first : shown.second)[trial.pair];
    const bool missing = std::isnan(value) && trial.side == 1;
    course.take(missing ? unplayed() : played(trial.side, std::isnan(value) ? 50.0 : value, 10, 1, 1));
  }
  return findings(plan, course).comparisons;
}

Contrast difference(const PartlyPlayed& first, const PartlyPlayed& second) { return {{first, second}, {1.0, -1.0}}; }

std::vector<Finding> found(const ExperimentPlan& plan, const Shown& shown) {
  Experiment course(plan);
  return found(plan, shown, course);
}

TEST(ExperimentUnplayed, TheirPairsHaveNoValuesAndAreCounted) {
  const ExperimentPlan plan = experiment_of(2, 1, 6);
  Experiment course(plan);
  const Shown shown{{1, nothing, 3, 4, 5, 6}, {2, 3, 4, nothing, nothing, 7}};
  const std::vector<Finding> all = found(plan, shown, course);
  EXPECT_EQ(course.unplayed_pairs(0), 1u);
  EXPECT_EQ(course.unplayed_pairs(1), 2u);
  EXPECT_EQ(course.unplayed_pairs(), 3u);
  EXPECT_EQ(course.remarks().unplayed.count(), 3u);
  EXPECT_EQ(course.mean(0, 0).pairs, 5);
  EXPECT_EQ(course.mean(1, 0).pairs, 4);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].difference.pairs, 3);
  EXPECT_EQ(all[0].unplayed_pairs, 3u);
  EXPECT_FALSE(all[0].found);
  EXPECT_TRUE(course.forfeits().listed().empty());
}

TEST(ExperimentUnplayed, AFindingHoldsWithTheMostAdverseValuesAndSigns) {
  std::array<int, 3> seen{};
  for (const PairTest test : {PairTest::paired_t, PairTest::sign_flip}) {
    for (unsigned seed = 0; seed < 150; ++seed) {
      ExperimentPlan plan = experiment_of(2, 1, 16);
      plan.asked.primary->test = test;
      std::mt19937 random(seed);
      std::normal_distribution<double> noise(20.0, 1.0);
      Shown shown, without;
      std::vector<bool> lost_first, lost_second;
      const double more = std::array{0.0, 1.5, -4.0}[seed % 3];
      for (int pair = 0; pair < 16; ++pair) {
        const double a = noise(random) + more, b = noise(random);
        const bool lose_a = random() % 16 == 0 && seed % 2 == 0, lose_b = random() % 16 == 0 && seed % 2 == 0;
        shown.first.push_back(lose_a ? nothing : a);
        shown.second.push_back(lose_b ? nothing : b);
      }
      const Finding finding = found(plan, shown).front();
      // Any way to fill the holes with what has been seen, each hole by itself: not above what is said.
      double least = HUGE_VAL, most = -HUGE_VAL;
      for (const auto* side : {&shown.first, &shown.second}) {
        for (const double each : *side) {
          if (!std::isnan(each)) least = std::min(least, each), most = std::max(most, each);
        }
      }
      const bool found_without = *finding.p <= 0.05;
      bool stands = found_without;
      for (int way = 0; way < 12; ++way) {
        Shown filled = shown;
        for (auto* side : {&filled.first, &filled.second}) {
          const bool first = side == &filled.first;
          for (double& each : *side) {
            if (std::isnan(each))
              each = way == 0   ? (first ? least : most)
                     : way == 1 ? (first ? most : least)
                                : std::uniform_real_distribution(least, most)(random);
          }
        }
        const auto p = p_of_values(paired_differences(filled.first, filled.second), test);
        if (way < 2 && p->p > 0.05) stands = false;
        if (finding.found) {
          EXPECT_LE(p->p, 0.05) << seed;
        }
      }
      // And by signs, whatever the sizes: counted here by hand.
      const int sign = finding.difference.mean > 0.0 ? 1 : -1;
      std::vector<double> signs;
      for (int pair = 0; pair < 16; ++pair) {
        const auto at = static_cast<std::size_t>(pair);
        const double difference = shown.first[at] - shown.second[at];
        signs.push_back(std::isnan(difference) || difference * sign < 0.0 ? -1.0 : 1.0);
      }
      const bool any = finding.unplayed_pairs > 0;
      if (any && statistics::sign_flip_p_of_values(signs) > 0.05) stands = false;
      EXPECT_EQ(finding.found, stands) << seed;
      EXPECT_EQ(finding.prevented, found_without && !stands) << seed;
      ++seen[finding.found ? 0 : finding.prevented ? 1 : 2];
    }
  }
  for (const int each : seen) EXPECT_GT(each, 10);
}

// An arm whose worst matches cannot be played looks better than it is; the values that are left bound nothing.
TEST(ExperimentUnplayed, WhoLosesItsWorstPairsFindsNothing) {
  int tempting = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const ExperimentPlan plan = experiment_of(2, 1, 40);
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(20.0, 3.0);
    Shown shown;
    for (int pair = 0; pair < 40; ++pair) {
      const double a = noise(random), b = noise(random);
      shown.first.push_back(a > 21.0 ? nothing : a);  // much overlap is bad
      shown.second.push_back(b);
    }
    const Finding finding = found(plan, shown).front();
    if (*finding.p <= 0.05) ++tempting;
    EXPECT_FALSE(finding.found);
  }
  EXPECT_GT(tempting, 50);
}

// Ten pairs differ by one, and conditions vary by twenty: one missing pair may hold more than all of them together.
TEST(ExperimentUnplayed, AMissingPairMayHoldTheLargestDifferenceSeen) {
  std::vector<double> first, second;
  for (int i = 0; i < 10; ++i) {
    second.push_back(2.0 * i);
    first.push_back(2.0 * i + 1.0 + 0.01 * i);
  }
  first.push_back(nothing);
  second.push_back(nothing);
  std::vector<bool> unplayed(11, false);
  unplayed.back() = true;
  for (const PairTest test : {PairTest::paired_t, PairTest::sign_flip}) {
    EXPECT_LT(p_of_values(paired_differences(first, second), test)->p, 0.01);
    EXPECT_EQ(p_either_way(difference({first, unplayed}, {second, unplayed}), test), 1.0);
    EXPECT_EQ(p_either_way(difference({second, unplayed}, {first, unplayed}), test), 1.0);
  }
}

TEST(ExperimentUnplayed, ForfeitsAreMissingAsBefore) {
  const std::vector<double> first{5, 6, nothing, 8, 9, 7}, second{1, 2, 3, 2, 1, 2};
  const std::vector<bool> none(6, false);
  const auto alone = p_of_values(paired_differences(first, second), PairTest::paired_t);
  EXPECT_EQ(p_either_way(difference({first, none}, {second, none}), PairTest::paired_t), alone->p);
  EXPECT_EQ(unplayed_pairs(difference({first, none}, {second, none})), 0u);
}

}  // namespace
}  // namespace regista::study
