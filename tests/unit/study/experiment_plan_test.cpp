// SPDX-License-Identifier: MIT
#include "study/experiment_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "experiment_fixture.hpp"

namespace regista::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// The same seeds and scenes for every condition, each once at home and once away; whoever stops early has played all
// conditions equally often.
TEST(ExperimentPlan, EveryConditionPlaysTheSameSeedsAndScenesOnBothSides) {
  ExperimentPlan plan = experiment_of(3, 4, 5);
  plan.openings = {{"a.yaml", {"a", "1"}}, {"b.yaml", {"b", "2"}}};
  std::map<std::size_t, std::set<std::tuple<std::uint64_t, std::size_t, std::size_t>>> of_condition;
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    const Trial each = trial(plan, index);
    EXPECT_EQ(each.seed, plan.first_seed() + each.pair);
    EXPECT_EQ(each.pair, index / (2 * plan.conditions.size()));
    EXPECT_TRUE(of_condition[each.condition].emplace(each.seed, each.side, each.opening).second);
  }
  ASSERT_EQ(of_condition.size(), plan.conditions.size());
  for (const auto& [condition, played] : of_condition) EXPECT_EQ(played, of_condition[0]) << condition;
  EXPECT_EQ(of_condition[0].size(), 2 * plan.pairs);
}

TEST(ExperimentPlan, MatchesOfATrialAreThoseOfItsCondition) {
  ExperimentPlan plan = experiment_of(2, 1, 3);
  plan.openings = {{"scene.yaml", {"scene", "hash"}}};
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    const Trial each = trial(plan, index);
    const campaign::Job made = job(plan, each);
    EXPECT_EQ(made.teams[each.side], team_of(plan, plan.conditions[each.condition].arm));
    EXPECT_EQ(made.teams[1 - each.side], plan.asked.opponent);
    EXPECT_EQ(made.seed, each.seed);
    EXPECT_EQ(made.opening, "scene.yaml");
    EXPECT_EQ(made.common_inputs.back().name, "scene");
    EXPECT_EQ(fixtures(plan).at(each.number).job.teams, made.teams);
  }
}

config::Node text(const char* value) { return config::Node::scalar(value, false, {}); }

TEST(ExperimentPlan, IsReadAsItWasWritten) {
  ExperimentPlan plan = experiment_of(2, 3, 4);
  config::Experiment& asked = plan.asked;
  asked.question = "Is it?";
  asked.arms[1].set = config::Node::map({{"sender.params.reserve", {}, text("60")}}, {});
  asked.settings.set = config::Node::map({{"b.sender.params.reserve", {}, text("6")}}, {});
  asked.primary->test = PairTest::sign_flip;
  asked.confidence = 0.9;
  asked.disturbance = "d.yaml";
  asked.settings.limits.processor_seconds = 3;
  asked.settings.robot = "r.yaml";
  asked.settings.limit = 30;
  plan.openings = {{"scene.yaml", {"scene", "hash"}}};
  plan.folder = "/tmp";
  plan.plugins = {"mine"};
  plan.program = "1.2";
  plan.documents = {"team: a", "team: b", "team: c"};
  make_jobs(plan, {});
  const ExperimentPlan read = experiment_plan_from_json(to_json(plan));
  EXPECT_EQ(to_json(read), to_json(plan));
  EXPECT_THAT(differences(plan, read), ElementsAre());
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) EXPECT_EQ(read.conditions[i].jobs, plan.conditions[i].jobs);
  EXPECT_EQ(read.program, "1.2");
}

// Settings of all arms, of the arm, and of the sweep; on whichever side the arm plays.
TEST(ExperimentPlan, JobsAreAsTheyAreAskedFor) {
  ExperimentPlan plan = experiment_of(2, 2, 1);
  plan.asked.arms[1].set = config::Node::map({{"sender.params.reserve", {}, text("60")}}, {});
  plan.asked.settings.set = config::Node::map({{"opponent.sender.plugin", {}, text("x")}}, {});
  plan.asked.disturbance = "d.yaml";
  make_jobs(plan, {});
  const Condition& last = plan.conditions.at(plan.condition(1, 1));
  EXPECT_THAT(last.jobs[0].overrides,
              ElementsAre("away.sender.plugin=x", "home.sender.params.reserve=60", "rules.messages.budget=1"));
  EXPECT_THAT(last.jobs[1].overrides,
              ElementsAre("home.sender.plugin=x", "away.sender.params.reserve=60", "rules.messages.budget=1"));
  EXPECT_EQ(last.jobs[0].home_disturbance + '|' + last.jobs[0].away_disturbance, "d.yaml|");
  EXPECT_EQ(last.jobs[1].home_disturbance + '|' + last.jobs[1].away_disturbance, "|d.yaml");
  EXPECT_EQ(last.jobs[0].home_inputs.front().hash, "team 1") << "what was found stays";
}

TEST(ExperimentPlan, WhatIsNoPlanIsRefused) {
  const std::string sound = to_json(experiment_of(2, 1, 2));
  EXPECT_THROW(experiment_plan_from_json(""), std::invalid_argument);
  EXPECT_THROW(experiment_plan_from_json("[]"), std::invalid_argument);
  EXPECT_THROW(experiment_plan_from_json(R"({"study": "tournament", "version": 1})"), std::invalid_argument);
  const auto with = [&](const std::string& what, const std::string& instead) {
    std::string text = sound;
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), instead);
  };
  EXPECT_NO_THROW(experiment_plan_from_json(with(R"("pairs":2)", R"("pairs":3)")));
  for (const auto& [what, instead] : {std::pair{R"("pairs":2)", R"("pairs":0)"},
                                      {R"("pairs":2)", R"("pairs":18446744073709551615)"},
                                      {R"(confidence: 0.95)", R"(confidence: 1.5)"},
                                      {R"(measure: \"striker)", R"(measures: \"striker)"},
                                      {R"("measures":[)", R"("measures":[],"more":[)"},
                                      {R"("version":2)", R"("version":3)"}}) {
    EXPECT_THROW(experiment_plan_from_json(with(what, instead)), std::invalid_argument) << instead;
  }
  ExperimentPlan fewer = experiment_of(2, 1, 2);
  fewer.conditions.pop_back();
  EXPECT_THROW(experiment_plan_from_json(to_json(fewer)), std::invalid_argument);
}

TEST(ExperimentPlan, EveryDifferenceIsNamed) {
  const ExperimentPlan plan = experiment_of(2, 1, 2);
  const auto changed = [&](auto change) {
    ExperimentPlan now = plan;
    change(now);
    return differences(plan, now);
  };
  EXPECT_THAT(changed([](auto& now) { now.asked.matches = 6; }), ElementsAre("matches: was 4, now 6"));
  EXPECT_THAT(changed([](auto& now) { now.asked.seed = 8; }), ElementsAre("seed: was 7, now 8"));
  EXPECT_THAT(changed([](auto& now) { now.asked.arms[1].name = "other"; }), ElementsAre(HasSubstr("arms.1.name: was")));
  EXPECT_THAT(changed([](auto& now) { now.asked.primary->test = PairTest::sign_flip; }),
              ElementsAre("primary.test: was paired_t, now sign_flip"));
  EXPECT_THAT(changed([](auto& now) { now.asked.confidence = 0.9; }), ElementsAre("confidence: was 0.95, now 0.9"));
  EXPECT_THAT(changed([](auto& now) { now.measures.pop_back(); }), ElementsAre(HasSubstr("the measures: was")));
  EXPECT_THAT(changed([](auto& now) {
                for (const std::size_t side : {0u, 1u}) {
                  auto& job = now.conditions[1].jobs[side];
                  (side == 0 ? job.home_inputs : job.away_inputs)[0].hash = "new";
                }
              }),
              ElementsAre("arm 1: team has changed"));
  EXPECT_THAT(changed([](auto& now) {
                now.openings = {{"s.yaml", {"opening s", "1"}}};
              }),
              ElementsAre(HasSubstr("opening s")));
}

TEST(ExperimentPlan, IsGoneOnWithAfterTheClockStoppedIt) {
  ExperimentPlan plan = experiment_of(2, 1, 50);
  plan.ended_after = 8;
  const ExperimentPlan back = experiment_plan_from_json(to_json(plan));
  EXPECT_EQ(back.ended_after, 8u);
  EXPECT_EQ(back.pairs_to_its_end(), 8u);
  const ExperimentPlan on = without_end(back);
  EXPECT_EQ(on.pairs_to_its_end(), 50u);
  EXPECT_EQ(on.pairs_before, "8");
  const ExperimentPlan more = with_pairs(on, 70);
  EXPECT_EQ(more.pairs, 70u);
  EXPECT_EQ(more.asked.matches, 140);
  EXPECT_EQ(experiment_plan_from_json(to_json(more)).pairs_before, "8, 50");
  EXPECT_THROW(with_pairs(more, 60), std::invalid_argument);
  plan.ended_after = 51;
  EXPECT_THROW(experiment_plan_from_json(to_json(plan)), std::invalid_argument);
}

TEST(ExperimentPlan, EqualConditionsAreKnown) {
  ExperimentPlan plan = experiment_of(2, 1, 2);
  EXPECT_FALSE(equal_conditions(plan, {0, 1}));
  EXPECT_TRUE(equal_conditions(plan, {1, 1}));
  plan.conditions[1].jobs = plan.conditions[0].jobs;
  EXPECT_TRUE(equal_conditions(plan, {0, 1}));
}

}  // namespace
}  // namespace regista::study
