// SPDX-License-Identifier: MIT
// The headline of an experiment says what was found: an order of arms only where every difference was found.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "course.hpp"
#include "report/experiment_report.hpp"
#include "unit/study/experiment_fixture.hpp"

namespace regista::report {
namespace {

using study::ExperimentPlan;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// Minutes of overlap in 60 minutes of play, with a spread over pairs that every condition has in another order.
using Overlap = std::function<double(std::size_t condition)>;

std::string headline(const ExperimentPlan& plan, const Overlap& overlap, std::uint64_t most = ~std::uint64_t{0}) {
  study::Experiment course(plan);
  for (std::uint64_t index = 0; index < std::min(plan.matches(), most); ++index) {
    const study::Trial each = trial(plan, index);
    const double spread = static_cast<double>((each.pair * 5 + each.condition * 3) % 7) / 7.0;
    course.take(study::played(each.side, 10.0 * (overlap(each.condition) + spread), 1, 0, 0));
  }
  return experiment_headline({plan, course, [](std::uint64_t) { return std::string(); }});
}

Overlap of(std::vector<double> means) {
  return [means](std::size_t condition) { return means.at(condition); };
}

// Its independent truth: no order is claimed of two names unless a difference as large was put in.
TEST(ExperimentHeadline, AnOrderOfAllArmsWhereEveryDifferenceWasFound) {
  EXPECT_EQ(headline(study::experiment_of(3, 1, 12), of({10, 30, 20})),
            "striker.overlap_seconds, min per 60 min: arm 1 30.44 > arm 2 20.45 > arm 0 10.43. Every difference was "
            "found.");
  EXPECT_THAT(headline(study::experiment_of(2, 1, 12), of({10, 30})),
              AllOf(testing::StartsWith("arm 1 has more striker.overlap_seconds than arm 0: 30."),
                    HasSubstr(" against 10."), testing::EndsWith(" min per 60 min.")));
}

TEST(ExperimentHeadline, NoneFound) {
  EXPECT_EQ(headline(study::experiment_of(2, 1, 12), of({10, 10})),
            "No difference in striker.overlap_seconds was found between arm 0 and arm 1. There may still be a "
            "smaller difference.");
  EXPECT_EQ(headline(study::experiment_of(3, 1, 12), of({10, 10, 10})),
            "No difference in striker.overlap_seconds was found between any two of the 3 arms. There may still be a "
            "smaller difference.");
  ExperimentPlan some = study::experiment_of(4, 1, 12);
  study::compare(some, {{0, 1}, {2, 3}});
  EXPECT_EQ(headline(some, of({10, 10, 30, 30})),
            "No difference in striker.overlap_seconds was found in any of 2 comparisons. There may still be a "
            "smaller difference.");
}

TEST(ExperimentHeadline, SomeFound) {
  EXPECT_EQ(headline(study::experiment_of(3, 1, 12), of({10, 30, 10})),
            "arm 1 has more striker.overlap_seconds than arm 0 and arm 2. No difference was found between arm 0 and "
            "arm 2.");
  const std::string of_five = headline(study::experiment_of(5, 1, 12), of({10, 10, 10, 10, 30}));
  EXPECT_EQ(
      of_five,
      "arm 4 has more striker.overlap_seconds than arm 0, arm 1, arm 2 and arm 3. No difference was found in 6 of "
      "10 comparisons.");
  EXPECT_THAT(headline(study::experiment_of(6, 1, 12), of({10, 20, 30, 40, 50, 50})),
              AllOf(Not(HasSubstr(" > ")), HasSubstr("more differences were found."),
                    HasSubstr("No difference was found between arm 4 and arm 5.")));
}

// All that was compared was found, but not everything was compared.
TEST(ExperimentHeadline, WhatWasNotComparedIsNotOrdered) {
  ExperimentPlan plan = study::experiment_of(3, 1, 12);
  study::compare(plan, {{0, 1}, {0, 2}});
  EXPECT_EQ(headline(plan, of({30, 20, 10})), "arm 0 has more striker.overlap_seconds than arm 1 and arm 2.");
}

// A difference that would be found by itself, but is not as one of several.
TEST(ExperimentHeadline, TheCorrectionCounts) {
  const auto overlap = [](std::size_t condition) { return condition == 0 ? 10.35 : 10.0; };
  ExperimentPlan several = study::experiment_of(8, 1, 12);
  study::compare(several, {{0, 1}, {2, 3}, {4, 5}, {6, 7}});
  EXPECT_THAT(headline(study::experiment_of(2, 1, 12), overlap), HasSubstr("arm 0 has more"));
  EXPECT_THAT(headline(several, overlap), testing::StartsWith("No difference in striker.overlap_seconds was found"));
}

TEST(ExperimentHeadline, OneArm) {
  EXPECT_THAT(headline(study::experiment_of(1, 1, 12), of({10})),
              AllOf(testing::StartsWith("arm 0 has 10."),
                    testing::EndsWith(" striker.overlap_seconds, min per 60 min. There is no other arm to compare it "
                                      "with.")));
}

TEST(ExperimentHeadline, OfASweepTheValuesAreNamed) {
  // Conditions by value, then arm.
  EXPECT_EQ(
      headline(study::experiment_of(2, 3, 12), of({30, 10, 10, 10, 10, 30})),
      "striker.overlap_seconds of arm 1 rises with rules.messages.budget. That of arm 0 falls. arm 0 has more "
      "striker.overlap_seconds than arm 1 at 0 of rules.messages.budget. arm 1 has more "
      "striker.overlap_seconds than arm 0 at 2 of rules.messages.budget. No difference was found between arm 0 at "
      "1 and arm 1 at 1.");
  EXPECT_EQ(headline(study::experiment_of(2, 3, 12), of({30, 10, 30, 10, 30, 10})),
            "arm 0 has more striker.overlap_seconds than arm 1 at each of the 3 values of rules.messages.budget. "
            "No trend over rules.messages.budget was found.");
  EXPECT_THAT(headline(study::experiment_of(2, 3, 12), of({10, 10, 10, 10, 10, 10})),
              testing::StartsWith("No trend of striker.overlap_seconds over rules.messages.budget was found, and no "
                                  "difference in any of 3 comparisons."));
  EXPECT_THAT(headline(study::experiment_of(3, 3, 12), of({10, 10, 30, 20, 10, 25, 30, 10, 20})),
              testing::StartsWith("striker.overlap_seconds of arm 0 rises with rules.messages.budget. That of arm 2 "
                                  "falls. No trend was found for arm 1. "));
  EXPECT_THAT(headline(study::experiment_of(2, 3, 12), of({10, 10, 20, 20, 30, 30})),
              testing::StartsWith("striker.overlap_seconds of all 2 arms rises with rules.messages.budget. No "));
}

TEST(ExperimentHeadline, OfOneArmOverASweepTheFirstValueIsTheReference) {
  ExperimentPlan plan = study::experiment_of(1, 4, 12);
  EXPECT_EQ(headline(plan, of({10, 10, 20, 30})),
            "striker.overlap_seconds of arm 0 rises with rules.messages.budget. arm 0 has more striker.overlap_seconds "
            "at 2 and 3 of rules.messages.budget than at 0. No difference was "
            "found between arm 0 at 1 and arm 0 at 0.");
  EXPECT_EQ(headline(plan, of({30, 20, 10, 10})),
            "striker.overlap_seconds of arm 0 falls with rules.messages.budget. arm 0 has less striker.overlap_seconds "
            "at 1, 2 and 3 of rules.messages.budget than at 0.");
}

TEST(ExperimentHeadline, WhereThereIsNoTest) {
  EXPECT_EQ(headline(study::experiment_of(2, 1, 1), of({10, 30})),
            "There are too few pairs for a test of striker.overlap_seconds.");
  EXPECT_EQ(headline(study::experiment_of(2, 1, 12), of({10, 30}), 20),
            "Not at its end: 20 of 48 matches. Nothing is tested yet.");
  ExperimentPlan described = study::experiment_of(2, 1, 12);
  described.asked.primary.reset();
  EXPECT_EQ(headline(described, of({10, 30})), "The experiment names no primary measure, so nothing was tested.");
  EXPECT_EQ(headline(study::experiment_of(1, 1, 12), of({10})),
            "arm 0 has 10.43 striker.overlap_seconds, min per 60 min. There is no other arm to compare it with.");
  ExperimentPlan equal = study::experiment_of(2, 1, 12);
  equal.conditions[1].jobs = equal.conditions[0].jobs;
  EXPECT_EQ(headline(equal, of({10, 10})), "arm 0 and arm 1 are equal by construction.");
}

TEST(ExperimentHeadline, PairsThatCouldNotBePlayedPreventAVerdict) {
  const ExperimentPlan plan = study::experiment_of(2, 1, 12);
  study::Experiment course(plan);
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    const study::Trial each = trial(plan, index);
    if (each.pair < 4 && each.condition == 0)
      course.take(unplayed());
    else
      course.take(
          study::played(each.side, each.condition == 0 ? 100.0 : 200.0 + static_cast<double>(each.pair), 1, 0, 0));
  }
  EXPECT_EQ(experiment_headline({plan, course, [](std::uint64_t) { return std::string(); }}),
            "No verdict: 4 pairs could not be played.");
}

}  // namespace
}  // namespace regista::report
