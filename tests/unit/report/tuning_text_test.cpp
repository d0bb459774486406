// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "report/tuning_report.hpp"
#include "tuning_course.hpp"

namespace regista::report {
namespace {

using study::TuningStage;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TuningStage stage_of(const campaign::Job& job) { return static_cast<TuningStage>(job.seed >> 50); }
bool is_of_base(const study::TuningPlan& plan, const campaign::Job& job) {
  return override_of(job, plan.parameters[0].path) == 5.0 && override_of(job, plan.parameters[1].path) == 1.0;
}

TEST(TuningText, AClearWin) {
  const TunedCourse course(tuning_plan());
  ASSERT_TRUE(course.record.verified());
  const std::string text = text_of(course.view());
  EXPECT_THAT(
      text,
      AllOf(HasSubstr("Tuning: weights: 2 parameters of base.yaml, goal_difference as large as possible\n"),
            HasSubstr("Do other weights score more?\n"),
            HasSubstr("\nThe tuned team is better than the base team on held-out seeds.\n"),
            HasSubstr("Finalist 1: better than the base team on held-out seeds; goal_difference "),
            HasSubstr("(anytime-valid 95 % interval), "), HasSubstr("The tuned team is in tuned.yaml.\n"),
            HasSubstr("Opponents, with their weights: fixed_rate (75 %), spqr (25 %)."),
            HasSubstr("weights.distance      5  0 to 10 m  linear"), HasSubstr("weights.bearing       1  0.1 to 10"),
            HasSubstr("the larger the better"), HasSubstr("budget used up"), Not(HasSubstr("Not at its end"))));
  EXPECT_THAT(text, Not(HasSubstr("Forfeits")));
  // What came out comes last.
  EXPECT_GT(text.find("\nThe tuned team is better"), text.find("\nFinalists\n"));
  EXPECT_GT(text.find("\nFinalist 1: "), text.find("\nThe tuned team is better"));
}

// Tuned values and importance are one table; without a tuned team there is importance all the same.
TEST(TuningText, ValuesStandBesideTheirImportance) {
  const TunedCourse course(tuning_plan());
  EXPECT_THAT(text_of(course.view()),
              AllOf(HasSubstr("\nTuned values and importance\nOf finalist 1.\n\nParameter  "),
                    testing::ContainsRegex("\nweights.bearing  +1  +[0-9.]+  0.1 to 10  +[0-9.]+  p [<=]")));
  study::TuningPlan plan = tuning_plan();
  plan.asked.search.algorithm = "sbplx";
  plan.pairs = 4;
  const TunedCourse nothing(
      plan, [](double distance, double bearing) { return 1.0 - std::abs(distance - 5.0) - std::abs(bearing - 1.0); });
  ASSERT_FALSE(nothing.record.tuned());
  ASSERT_FALSE(nothing.record.slices.empty());
  EXPECT_THAT(text_of(nothing.view()),
              AllOf(testing::ContainsRegex("\nweights.bearing  +1  +-  0.1 to 10  +[0-9.]+  p [<=]"),
                    HasSubstr("Each parameter varied alone around finalist 1, "), Not(HasSubstr("Of finalist"))));
}

// What the values of a point were is a mean of points that SPSA played, so the search did not play it; sbplx plays its
// own.
TEST(TuningText, WhatTheSearchPromisedStandsBesideWhatCameOfIt) {
  EXPECT_THAT(text_of(TunedCourse(tuning_plan()).view()), HasSubstr("it is the mean of points that the search played"));
  study::TuningPlan plan = tuning_plan();
  plan.asked.search.algorithm = "sbplx";
  plan.pairs = 2;
  const TunedCourse course(plan);
  const CandidateVerdict of = candidate_verdicts(course.view()).at(0);
  ASSERT_TRUE(of.seen && of.value && of.optimism);
  EXPECT_DOUBLE_EQ(*of.optimism, of.seen->mean - of.value->mean);
  EXPECT_THAT(text_of(course.view()),
              HasSubstr(*of.optimism > 0.0 ? "the search was too optimistic by" : "the search was not too optimistic"));
}

// All weights play equally well, each with luck of its own.
TEST(TuningText, ATie) {
  study::TuningPlan plan = tuning_plan();
  plan.asked.seed = 5;
  const TunedCourse course(plan, [&](campaign::Job job) {
    const std::uint64_t seed = job.seed;
    for (const char c : job.overrides[0] + job.overrides[1]) job.seed = 31 * job.seed + static_cast<unsigned char>(c);
    return decided_by(plan, job, [seed](double, double) { return 0.1 * static_cast<double>(seed % 3); });
  });
  ASSERT_FALSE(course.record.verified());
  ASSERT_FALSE(course.record.candidates.empty());
  EXPECT_THAT(
      text_of(course.view()),
      AllOf(HasSubstr("\nNo difference between the tuned team and the base team was found in 200 pairs. There "
                      "may still be a smaller difference.\n"),
            HasSubstr("but there may still be a smaller difference"), HasSubstr("although it was not found better"),
            HasSubstr("no more than chance"), Not(HasSubstr("team is better"))));
}

// In the verification the order of all points is turned round: what was chosen is worse there, and the search too
// optimistic.
TEST(TuningText, ALoss) {
  study::TuningPlan plan = tuning_plan();
  plan.asked.search.algorithm = "sbplx";
  const auto turned = [&plan](const campaign::Job& job) {
    return decided_by(plan, job, [&](double a, double b) {
      return stage_of(job) == TuningStage::verification ? -peak(a, b) : peak(a, b);
    });
  };
  const TunedCourse course(plan, turned);
  EXPECT_THAT(text_of(course.view()),
              AllOf(HasSubstr("\nWhat the search found is worse than the base team on held-out seeds.\n"),
                    HasSubstr("Finalist 1: worse than the base team"), HasSubstr("the search was too optimistic by"),
                    HasSubstr("although it was not found better"), Not(HasSubstr("is better"))));
}

TEST(TuningText, NothingBetterThanTheBaseTeam) {
  study::TuningPlan plan = tuning_plan();
  plan.asked.search.algorithm = "sbplx";
  plan.pairs = 4;
  const TunedCourse course(
      plan, [](double distance, double bearing) { return 1.0 - std::abs(distance - 5.0) - std::abs(bearing - 1.0); });
  ASSERT_TRUE(course.record.candidates.empty());
  const std::string text = text_of(course.view());
  EXPECT_THAT(text, AllOf(HasSubstr("\nThe search found nothing better than the base team.\n"),
                          HasSubstr("the base team came first"), Not(HasSubstr("Of finalist"))));
}

TEST(TuningText, HeadToHeadThereIsTheDifferenceAlone) {
  study::TuningPlan plan = tuning_plan();
  plan.asked.verification.against = config::Tuning::Against::base;
  plan.asked.search.algorithm = "sbplx";
  const TunedCourse course(plan);
  EXPECT_THAT(text_of(course.view()), AllOf(HasSubstr("goal_difference less the base team's in the same matches +"),
                                            HasSubstr("the selection gave"), HasSubstr("playing each other")));
  EXPECT_FALSE(candidate_verdicts(course.view()).at(0).value.has_value());
}

TEST(TuningText, WhoForfeitsAMatchOfTheVerificationIsNotTakenForBetter) {
  const study::TuningPlan plan = tuning_plan();
  bool broken = false;
  const TunedCourse course(plan, [&](const campaign::Job& job) {
    campaign::MatchResult decided = decided_by(plan, job, peak);
    if (stage_of(job) == TuningStage::verification && !is_of_base(plan, job) && !broken) {
      broken = true;
      return campaign::forfeit({0, "greedy", "assign", 3, 417, "Segmentation\nfault"}, 1.0);
    }
    return decided;
  });
  ASSERT_FALSE(course.record.verified());
  EXPECT_THAT(text_of(course.view()), AllOf(HasSubstr("not found better: it forfeited a match of the verification"),
                                            HasSubstr("not found better, because it forfeited"),
                                            HasSubstr("  1 match forfeited by the team that is tuned: plugin greedy, "
                                                      "assign: Segmentation\\nfault; first in match ")));
}

TEST(TuningText, ForfeitsOfOthersAreTheirs) {
  study::TuningPlan plan = tuning_plan();
  plan.asked.search.algorithm = "sbplx";
  plan.pairs = 3;
  const TunedCourse course(plan, [&](const campaign::Job& job) {
    const bool of_spqr = job.home_inputs.front().hash == "document of spqr" && job.seed % 7 == 0;
    return of_spqr ? campaign::forfeit({0, "slow", "decide", 1, 2, "no answer"}, 1.0) : decided_by(plan, job, peak);
  });
  EXPECT_THAT(text_of(course.view()),
              AllOf(HasSubstr("matches forfeited by spqr: plugin slow, decide: no answer"), HasSubstr("are left out")));
}

// Minutes of overlap in 60 minutes: less is better, and is told as less.
TEST(TuningText, AMinimisedObjectiveHasTheUsersSign) {
  study::TuningPlan plan = tuning_plan();
  plan.objective = {{{"striker.overlap_seconds", 1.0}}, true};
  const TunedCourse course(plan);
  ASSERT_TRUE(course.record.verified());
  const CandidateVerdict of = candidate_verdicts(course.view()).at(0);
  EXPECT_GT(of.value->mean, 0.0);
  EXPECT_LT(of.value->mean, of.base->mean);
  EXPECT_NEAR(of.difference.value, of.value->mean - of.base->mean, 1e-9);
  EXPECT_LE(of.difference.interval.low, of.difference.interval.high);
  EXPECT_LT(of.value->interval->low, of.value->interval->high);
  EXPECT_THAT(text_of(course.view()),
              AllOf(HasSubstr("striker.overlap_seconds as small as possible"),
                    HasSubstr("striker.overlap_seconds (min per 60 min), the smaller the better"),
                    HasSubstr("difference -1."), HasSubstr("The tuned team is better")));
}

// Less overlap, or more goals: by its interval the verified difference lies on the side that was asked for.
TEST(TunedFile, ItsHeadHasTheDifferenceInItsInterval) {
  for (const bool minimise : {false, true}) {
    study::TuningPlan plan = tuning_plan();
    if (minimise) plan.objective = {{{"striker.overlap_seconds", 1.0}}, true};
    const TunedCourse course(plan);
    ASSERT_TRUE(course.record.verified());
    const std::string text = tuned_file_text("tuned.yaml", course.plan, course.record, "0.2", "none");
    EXPECT_THAT(text, HasSubstr("VERIFIED better than the base team"));
    const std::size_t bracket = text.find(" [");
    ASSERT_NE(bracket, std::string::npos) << text;
    double low = 0.0, high = 0.0;
    ASSERT_EQ(std::sscanf(text.c_str() + bracket, " [%lf, %lf] at 95 %%", &low, &high), 2) << text;
    const double value = std::strtod(text.c_str() + text.rfind(' ', bracket - 1), nullptr);
    EXPECT_LT(low, value) << text;
    EXPECT_LT(value, high) << text;
    EXPECT_TRUE(minimise ? high < 0.0 : low > 0.0) << text;
  }
}

TEST(TuningText, ValuesAtTheEndOfTheirRangeAreMarked) {
  const TunedCourse course(tuning_plan(), [](double distance, double) { return 0.4 * distance; });
  ASSERT_EQ(tuned_values(course.view()).at(0).at, RangeEnd::upper);
  EXPECT_THAT(text_of(course.view()), HasSubstr("0 to 10 m  at the upper end"));
}

TEST(TuningText, ABareNumberHasNoUnit) {
  study::Parameter parameter = tuning_plan().parameters[0];
  EXPECT_EQ(range_text(parameter), "0 to 10 m");
  parameter.unit = "1";
  EXPECT_EQ(range_text(parameter), "0 to 10");
  parameter.most = 0.0;
  EXPECT_EQ(range_text(parameter), "fixed at 0");
}

TEST(TuningText, WithoutPairsOfTheVerificationNothingIsSaid) {
  study::TuningPlan plan = tuning_plan();
  plan.verification_pairs = 0;
  EXPECT_THAT(text_of(TunedCourse(plan).view()),
              AllOf(HasSubstr("\nNothing was verified, so nothing can be said.\n"), HasSubstr("Nothing is verified.")));
}

TEST(TuningText, AnOpponentThatIsTheBaseTeamIsNoted) {
  study::TuningPlan plan = tuning_plan();
  plan.opponents[1].jobs = plan.base.jobs;
  EXPECT_THAT(plain(setup_sentences(plan).front()), HasSubstr("; spqr is the base team itself."));
}

// Stopped by Ctrl-C at any place: everything can be told, is told the same way twice, and says that it is not its end.
TEST(TuningText, StoppedAnywhere) {
  study::TuningPlan plan = tuning_plan();
  plan.asked.verification.candidates = 2;
  const std::uint64_t all = TunedCourse(plan).played;
  std::array<bool, 4> seen{};
  for (std::uint64_t most = 0; most < all; most += most < 8 ? 1 : 23) {
    const TunedCourse course(plan, peak, most);
    ASSERT_TRUE(course.record.stage.has_value());
    seen[static_cast<std::size_t>(*course.record.stage)] = true;
    const std::string text = text_of(course.view());
    EXPECT_THAT(text, HasSubstr("Not at its end: "));
    EXPECT_EQ(text, text_of(course.view()));
    EXPECT_FALSE(outline_json(tuning_outline(course.view())).empty());
    const std::string standing = tuning_standing(course.view());
    const auto lines = std::ranges::count(standing, '\n');
    EXPECT_GE(lines, 2);
    EXPECT_LE(lines, 6);
  }
  for (const bool each : seen) EXPECT_TRUE(each);
}

TEST(TuningStanding, ShowsWhereItIs) {
  const study::TuningPlan plan = tuning_plan();
  study::TuningRecord record(plan);
  std::string standings;
  const Decide decide = [&](const campaign::Job& job) {
    standings += tuning_standing({plan, record, ""});
    return decided_by(plan, job, peak);
  };
  std::uint64_t played = 0;
  tune(plan, played_by(decide, played), {}, record);
  standings += tuning_standing({plan, record, ""});
  EXPECT_THAT(standings,
              AllOf(HasSubstr("search, evaluation 0 of at most 60; matches asked for: 4 of at most 2424\n"),
                    HasSubstr("search, evaluation 1 of at most 60; matches asked for: 12 of at most 2424\n"),
                    HasSubstr("(optimistic), the base team "), HasSubstr("on the selection, not played in the search"),
                    HasSubstr("verification, pair 3 of at most 200"), HasSubstr(", undecided\n"),
                    HasSubstr(", better\n"), HasSubstr("all is done")));
}

TEST(TuningText, NamesOfFilesAreShownAsTheyCanBeSeen) {
  TunedCourse course(tuning_plan());
  course.plan.asked.name = course.plan.asked.team = course.plan.asked.question = course.plan.opponents[0].label =
      course.file = "a\nb\x1b[31m\u202e\xff";
  course.plan.parameters[0].path = course.plan.parameters[0].unit = "p\nq\x1b";
  for (const std::string& text : {text_of(course.view()), tuning_standing(course.view())}) {
    EXPECT_THAT(text, AllOf(Not(HasSubstr("\x1b")), Not(HasSubstr("\u202e")), Not(HasSubstr("a\nb")),
                            Not(HasSubstr("p\nq")), HasSubstr("a\\nb")));
  }
}

}  // namespace
}  // namespace regista::report
