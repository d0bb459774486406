// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "report/experiment.hpp"
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

Told told(const ExperimentPlan& plan, const Overlap& overlap) {
  study::Experiment course(plan);
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    const study::Trial each = trial(plan, index);
    course.take(study::played(each.side, overlap(each.condition, each.pair), 1, 0, 0));
  }
  const ExperimentView view{plan, course, [](std::uint64_t) { return std::string(); }};
  return {finding_sentences(view), experiment_notes(view)};
}

double spread(std::size_t condition, std::uint64_t pair) {
  return condition == 0 ? 20.0 : 10.0 + static_cast<double>(pair * pair % 7);
}

double constant(std::size_t condition, std::uint64_t) { return condition == 0 ? 10.0 : 30.0; }

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
                                   HasSubstr("for all 2 comparisons together")));
  ExperimentPlan plan = study::experiment_of(2, 1, 3);
  const auto set = [](const char* path, const char* value) {
    return config::Node::Entry{path, {}, config::Node::scalar(value, false, {})};
  };
  plan.asked.arms[0].set = config::Node::map({set("rulesome.plugin", "x"), set("robot", "nao")}, {});
  plan.asked.arms[1].set = config::Node::map({set("robot.walk.forward", "0.2")}, {});
  EXPECT_THAT(told(plan, spread).notes, Contains(HasSubstr("at all values of robot, robot.walk.forward.")));
}

}  // namespace
}  // namespace regista::report
