// SPDX-License-Identifier: MIT
// Trends over a sweep: slopes of lines fitted by hand, their place in the family of findings, and pairs that could not
// be played.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "experiment_fixture.hpp"
#include "statistics/paired_tests.hpp"
#include "study/paired_estimates.hpp"

namespace regista::study {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

campaign::MatchResult unplayed() {
  campaign::MatchResult out;
  out.ended = "set_aside";
  out.why_set_aside = "Aborted";
  return out;
}

void set_values(ExperimentPlan& plan, const std::vector<std::string>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    plan.asked.sweep->values.at(i) = config::Node::scalar(values[i], false, {});
}

// Minutes of overlap in an hour; not a number: the second match of the pair was not played.
using Overlap = std::function<double(std::size_t arm, std::size_t value, std::uint64_t pair)>;

void play(Experiment& course, const ExperimentPlan& plan, const Overlap& overlap) {
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    const Trial each = trial(plan, index);
    const Condition& condition = plan.conditions[each.condition];
    const double minutes = overlap(condition.arm, condition.value, each.pair);
    const bool missing = std::isnan(minutes) && each.side == 1;
    // 600 s of play, so that one minute of overlap is six minutes of an hour.
    course.take(missing ? unplayed() : played(each.side, std::isnan(minutes) ? 10.0 : 10.0 * minutes, 1, 0, 0));
  }
}

TEST(ExperimentTrend, SlopesAreThoseOfTheLineThatFitsBest) {
  // By hand: places 1, 2, 6 have the mean 3 and the sum of squares 4 + 1 + 9 = 14.
  EXPECT_THAT(slope_weights(std::vector<double>{1, 2, 6}),
              ElementsAre(DoubleNear(-2.0 / 14, 1e-12), DoubleNear(-1.0 / 14, 1e-12), DoubleNear(3.0 / 14, 1e-12)));
  ExperimentPlan plan = experiment_of(1, 3, 2);
  set_values(plan, {"1", "2", "6"});
  Experiment course(plan);
  // Pair 0: 2, 4, 12, on the line 2 x. Pair 1: 5, 5, 12: (-10 - 5 + 36) / 14 = 1.5.
  const std::vector<std::vector<double>> shown{{2, 5}, {4, 5}, {12, 12}};
  play(course, plan, [&](std::size_t, std::size_t value, std::uint64_t pair) { return shown[value][pair]; });
  const MeanEstimate slope = course.slope(0, 0);
  EXPECT_EQ(slope.pairs, 2);
  EXPECT_NEAR(slope.mean, 1.75, 1e-12);
  EXPECT_NEAR(slope.standard_deviation, std::sqrt(2.0) * 0.25, 1e-12);
}

TEST(ExperimentTrend, OnlyNumbersThatDifferHaveOne) {
  ExperimentPlan plan = experiment_of(2, 3, 2);
  EXPECT_TRUE(has_trends(plan));
  EXPECT_THAT(swept_numbers(plan), ElementsAre(0, 1, 2));
  set_values(plan, {"0", "0.5", "none"});
  EXPECT_FALSE(has_trends(plan));
  set_values(plan, {"3", "3", "3"});
  EXPECT_FALSE(has_trends(plan));
  EXPECT_FALSE(has_trends(experiment_of(2, 1, 2)));
  EXPECT_TRUE(has_trends(experiment_of(2, 2, 2)));
  EXPECT_FALSE(has_trends(experiment_of(1, 2, 2))) << "it would be the comparison of the two values";
}

TEST(ExperimentTrend, IsOneMoreOfTheFamilyForEachArm) {
  const ExperimentPlan plan = experiment_of(2, 3, 8);
  Experiment course(plan);
  EXPECT_FALSE(findings(plan, course).trends.at(0).p) << "nothing is tested before the end";
  play(course, plan, [](std::size_t arm, std::size_t value, std::uint64_t pair) {
    const auto noise = static_cast<double>((pair * 5 + value * 3 + arm) % 7) / 7.0;
    return 10.0 + noise + (arm == 0 ? 2.0 * static_cast<double>(value) : 0.0);
  });
  const Findings all = findings(plan, course);
  ASSERT_EQ(all.comparisons.size(), 3u);
  ASSERT_EQ(all.trends.size(), 2u);
  std::vector<double> p;
  for (const Finding& each : all.comparisons) p.push_back(each.p.value());
  for (const Trend& each : all.trends) p.push_back(each.p.value());
  const std::vector<double> adjusted = statistics::holm(p);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(all.comparisons[i].adjusted.value(), adjusted[i]);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_DOUBLE_EQ(all.trends[i].adjusted.value(), adjusted[3 + i]);
  EXPECT_TRUE(all.trends[0].found);
  EXPECT_NEAR(all.trends[0].slope.mean, 2.0, 0.3);
  EXPECT_FALSE(all.trends[1].found);
}

// The arm rises by 1 a value, with a spread of pairs in which the first two values are not found to differ.
TEST(ExperimentTrend, FindsWhatValuesBesideEachOtherDoNotShow) {
  const ExperimentPlan plan = experiment_of(1, 6, 8);
  Experiment course(plan);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 1.5);
  std::vector<std::vector<double>> shown(6, std::vector<double>(8));
  for (std::size_t value = 0; value < shown.size(); ++value) {
    for (double& each : shown[value]) each = 20.0 + static_cast<double>(value) + noise(random);
  }
  play(course, plan, [&](std::size_t, std::size_t value, std::uint64_t pair) { return shown[value][pair]; });
  const Findings all = findings(plan, course);
  EXPECT_TRUE(all.trends.at(0).found);
  EXPECT_FALSE(all.comparisons.at(0).found);
}

// Without a trend put in, one is found in at most 5 of 100 experiments, give or take chance.
TEST(ExperimentTrend, KeepsItsErrorRate) {
  const std::vector<double> weights = slope_weights(std::vector<double>{0, 0.3, 0.6});
  std::mt19937 random(11);
  std::exponential_distribution<double> law(0.2);
  int found = 0;
  constexpr int rounds = 2000;
  for (int round = 0; round < rounds; ++round) {
    std::vector<std::vector<double>> values(3, std::vector<double>(12));
    for (auto& each : values) {
      for (double& value : each) value = law(random);
    }
    const std::vector<bool> none(12, false);
    const Contrast slopes{{{values[0], none}, {values[1], none}, {values[2], none}}, weights};
    if (p_either_way(slopes, PairTest::paired_t) <= 0.05) ++found;
  }
  EXPECT_LT(found, 0.065 * rounds);
  EXPECT_GT(found, 0.03 * rounds);
}

// An arm gains no finding by losing the pairs in which the measure did not rise.
TEST(ExperimentTrend, PairsThatCouldNotBePlayedDoNotMakeOne) {
  const ExperimentPlan plan = experiment_of(1, 3, 10);
  const auto shown = [](bool all_played) {
    return [all_played](std::size_t, std::size_t value, std::uint64_t pair) {
      const auto noise = static_cast<double>(pair % 3) / 3.0;
      if (value == 2 && pair >= 7) return all_played ? 10.0 - noise : std::nan("");
      return 10.0 + noise + 2.0 * static_cast<double>(value);
    };
  };
  Experiment course(plan);
  play(course, plan, shown(false));
  const Trend lost = findings(plan, course).trends.at(0);
  EXPECT_EQ(lost.unplayed_pairs, 3u);
  EXPECT_EQ(lost.slope.pairs, 7);
  EXPECT_LT(*lost.p, 0.001);
  EXPECT_TRUE(lost.prevented);
  EXPECT_FALSE(lost.found);
}

}  // namespace
}  // namespace regista::study
