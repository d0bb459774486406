// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "report/experiment_report.hpp"
#include "report/outline.hpp"
#include "texts/json.hpp"
#include "unit/study/experiment_fixture.hpp"

namespace regista::report {
namespace {

using study::ExperimentPlan;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

using Overlap = std::function<double(std::size_t condition, std::uint64_t pair)>;

struct Told {
  std::vector<std::string> findings, notes;
};

template <class Say>
auto of_course(const ExperimentPlan& plan, const Overlap& overlap, const Say& say) {
  study::Experiment course(plan);
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    const study::Trial each = trial(plan, index);
    course.take(study::played(each.side, overlap(each.condition, each.pair), 1, 0, 0));
  }
  return say(ExperimentView{plan, course, [](std::uint64_t) { return std::string(); }});
}

Told told(const ExperimentPlan& plan, const Overlap& overlap) {
  return of_course(plan, overlap, [](const ExperimentView& view) {
    return Told{finding_sentences(view), experiment_notes(view)};
  });
}

double spread(std::size_t condition, std::uint64_t pair) {
  return condition == 0 ? 20.0 : 10.0 + static_cast<double>(pair * pair % 7);
}

double constant(std::size_t condition, std::uint64_t) { return condition == 0 ? 10.0 : 30.0; }

Outline outline(const ExperimentPlan& plan) { return of_course(plan, spread, experiment_outline); }

TEST(ExperimentSentences, AnIntervalIsSaidToHoldByItself) {
  EXPECT_THAT(told(study::experiment_of(2, 1, 8), spread).findings,
              Contains(AllOf(HasSubstr("arm 0 has"), HasSubstr("(95 % interval of this comparison alone: "),
                             HasSubstr("after Holm"), Not(HasSubstr("signs")))));
}

TEST(ExperimentSentences, WithoutSpreadTheReasonIsNamedAndSignsAreCounted) {
  const std::vector<std::string> findings = told(study::experiment_of(2, 1, 8), constant).findings;
  EXPECT_THAT(findings, Contains(AllOf(HasSubstr("without spread Student's t is not defined"),
                                       HasSubstr("p = 0.0078 (all signs, exact), p = 0.0078 after Holm"),
                                       testing::StartsWith("arm 0 has less than arm 1: "))));
  EXPECT_THAT(findings, Not(Contains(HasSubstr("too few pairs"))));
  EXPECT_THAT(told(study::experiment_of(2, 1, 1), constant).findings, Contains(HasSubstr("too few pairs for a test")));
}

TEST(ExperimentSentences, TheNormalLawIsNamedWhereSignsAreNotCounted) {
  for (const std::uint64_t pairs : {32u, 33u}) {
    ExperimentPlan plan = study::experiment_of(2, 1, pairs);
    plan.asked.primary->test = study::PairTest::sign_flip;
    EXPECT_THAT(told(plan, spread).findings,
                Contains(HasSubstr(pairs == 32 ? "(all signs, exact)" : "(all signs, by the normal law)")));
  }
}

TEST(ExperimentSentences, NotesTellOfPlayingOfTheOpponentAndOfSeveralIntervals) {
  EXPECT_THAT(told(study::experiment_of(2, 1, 3), spread).notes,
              testing::ElementsAre("Mean minutes of a match in the phase Playing: arm 0 10.0, arm 1 10.0."));
  EXPECT_THAT(told(study::experiment_of(2, 2, 3), spread).notes,
              testing::ElementsAre("Mean minutes of a match in the phase Playing: 10.0.",
                                   AllOf(HasSubstr("apply to the opponent, too"), HasSubstr("rules.messages.budget")),
                                   HasSubstr("for all 2 comparisons and 2 trends together")));
  ExperimentPlan plan = study::experiment_of(2, 1, 3);
  const auto set = [](const char* path, const char* value) {
    return config::Node::Entry{path, {}, config::Node::scalar(value, false, {})};
  };
  plan.asked.arms[0].set = config::Node::map({set("rulesome.plugin", "x"), set("robot", "nao")}, {});
  plan.asked.arms[1].set = config::Node::map({set("robot.walk.forward", "0.2")}, {});
  EXPECT_THAT(told(plan, spread).notes, Contains(HasSubstr("at all values of robot, robot.walk.forward.")));
}

// 1, 3 and 5 minutes of an hour at 0, 1 and 2, in every second pair half as much again: the line rises by 4 or 6.
TEST(ExperimentSentences, ATrendIsToldByHowFarItRises) {
  const Overlap rising = [](std::size_t condition, std::uint64_t pair) {
    return 10.0 * (1.0 + 2.0 * static_cast<double>(condition)) * (pair % 2 == 0 ? 1.0 : 1.5);
  };
  EXPECT_THAT(
      told(study::experiment_of(1, 3, 8), rising).findings,
      Contains(AllOf(testing::StartsWith("striker.overlap_seconds of arm 0 rises with rules.messages.budget: "
                                         "by 5.00 from 0 to 2 (95 % interval of this trend alone: 4.11 to 5.89), 8 "
                                         "pairs; p < "),
                     HasSubstr(" after Holm."))));
  const Overlap falling = [&](std::size_t condition, std::uint64_t pair) { return 100.0 - rising(condition, pair); };
  EXPECT_THAT(told(study::experiment_of(1, 3, 8), falling).findings,
              Contains(testing::StartsWith("striker.overlap_seconds of arm 0 falls with rules.messages.budget: by 5.00 "
                                           "from 0 to 2 (95 % interval of this trend alone: 4.11 to 5.89)")));
  const std::string text = of_course(study::experiment_of(1, 3, 8), rising,
                                     [](const ExperimentView& view) { return outline_json(experiment_outline(view)); });
  const auto json = nlohmann::ordered_json::parse(text);
  EXPECT_NEAR(json["primary"]["trends"][0]["mean"].get<double>(), 2.5, 1e-9);
  EXPECT_EQ(json["primary"]["trends"][0]["arm"], "arm 0");
  EXPECT_TRUE(json["primary"]["trends"][0]["found"].get<bool>());
  EXPECT_EQ(json["measures"][1]["trends"].size(), 1u);
}

TEST(ExperimentSentences, ATerminalShowsDifferencesOfTeamsAndThePrimaryOneAPageAll) {
  ExperimentPlan plan = study::experiment_of(2, 1, 8);
  plan.asked.question = "Which?";
  plan.measures.emplace_back("keeper.overlap_seconds");
  const Outline shown = outline(plan);
  const std::string text = outline_text(shown);
  EXPECT_THAT(text, AllOf(testing::StartsWith("Experiment: trial: 2 arms against opponent, 16 matches each\nWhich?\n"),
                          HasSubstr("\nstriker.overlap_seconds, min per 60 min   2.00  1.18 +/- 0.13\n"),
                          testing::EndsWith("\n\n" + plain(shown.headline) + "\n")));
  const std::string differences = text.substr(text.find("\nDifferences\n"));
  EXPECT_THAT(differences, AllOf(HasSubstr("\nstriker.overlap_seconds, "), HasSubstr("\npackets "),
                                 HasSubstr("single roles: --json, or the page"), Not(HasSubstr("keeper."))));
  const std::string page = outline_page(shown, "results.db", {});
  EXPECT_THAT(page.substr(page.find("<section id=\"differences\"")), HasSubstr("keeper.<wbr>overlap_<wbr>seconds"));
  EXPECT_THAT(page, HasSubstr("Not drawn, because all numbers are 0 or missing: goals, keeper.overlap_seconds."));
}

// Its tables would be long.
TEST(ExperimentSentences, ATerminalShowsNoTableOfDifferencesOfASweep) {
  const Outline shown = outline(study::experiment_of(2, 2, 8));
  EXPECT_THAT(outline_text(shown), AllOf(HasSubstr("\nMeans\n"), Not(HasSubstr("\nDifferences\n"))));
  EXPECT_THAT(outline_page(shown, "results.db", {}), HasSubstr("<section id=\"differences\""));
}

}  // namespace
}  // namespace regista::report
