// SPDX-License-Identifier: MIT
#include "report/match_remarks.hpp"

#include <gtest/gtest.h>

#include "unit/study/experiment_fixture.hpp"
#include "unit/study/tournament_fixture.hpp"

namespace regista::report {
namespace {

TEST(PairsText, SaysThatPairsAreTooFew) {
  using study::plan_of;
  EXPECT_EQ(too_few_pairs(plan_of(2, 5)), "5 pairs cannot give a verdict: at least 6 are needed");
  EXPECT_EQ(too_few_pairs(plan_of(2, 6)), "");
  EXPECT_EQ(too_few_pairs(plan_of(3, 6)), "6 pairs cannot give a verdict: at least 7 are needed with 3 pairings");
  EXPECT_EQ(too_few_pairs(plan_of(2, 1, study::ValueTest{"goals"})), "");
  study::TournamentPlan stopped = plan_of(2, 100);
  stopped.ended_after = 1;
  EXPECT_EQ(too_few_pairs(stopped), "1 pair cannot give a verdict: at least 6 are needed");

  study::ExperimentPlan plan = study::experiment_of(3, 1, 6);
  EXPECT_EQ(too_few_pairs(plan), "");  // Student's t needs two
  plan.asked.primary->test = study::PairTest::sign_flip;
  EXPECT_EQ(too_few_pairs(plan), "6 pairs cannot give a verdict: at least 7 are needed with 3 comparisons");
  plan.asked.primary.reset();
  EXPECT_EQ(too_few_pairs(plan), "");
}

TEST(PairsText, SaysWhereTheClockStoppedIt) {
  study::TournamentPlan plan = study::plan_of(2, 100);
  EXPECT_EQ(stopped_sentence(plan), "");
  EXPECT_EQ(number_of_pairs(plan), "100 pairs");
  plan.ended_after = 37;
  EXPECT_EQ(
      stopped_sentence(plan),
      "The clock stopped it after 37 of 100 pairs, a number that counts as fixed beforehand, unless the clock was set "
      "anew after a look.");
  EXPECT_EQ(number_of_pairs(plan), "37 pairs, where the clock stopped it (100 were planned)");
  // As many as fit were asked for.
  plan.asked.pairs = static_cast<int>(study::most_pairs);
  EXPECT_EQ(number_of_pairs(plan), "37 pairs, where the clock stopped it");
  plan.ended_after = 1;
  EXPECT_EQ(stopped_sentence(plan),
            "The clock stopped it after 1 pair, a number that counts as fixed beforehand, unless the clock was set "
            "anew after "
            "a look.");
  plan.ended_after.reset();
  EXPECT_EQ(number_of_pairs(plan), "pairs until the clock ends the study");
  plan.asked.pairs.reset();
  plan.asked.test = study::plan_of(2, 1, study::ValueTest{"goals"}).asked.test;
  EXPECT_EQ(number_of_pairs(plan), "pairs until the test ends the study");
  // Where results may have decided the number, nothing says that it counts as fixed.
  plan.ended_after = 37;
  EXPECT_EQ(stopped_sentence(plan), "The clock stopped it after 37 pairs.");
  plan.asked.test.reset();
  plan.asked.pairs = 100;
  plan.pairs_before = "12";
  EXPECT_EQ(stopped_sentence(plan), "The clock stopped it after 37 of 100 pairs.");
  study::ExperimentPlan experiment = study::experiment_of(2, 1, 100);
  experiment.ended_after = 37;
  experiment.pairs_before = "12";
  EXPECT_EQ(stopped_sentence(experiment), "The clock stopped it after 37 of 100 pairs.");
}

}  // namespace
}  // namespace regista::report
