// SPDX-License-Identifier: MIT
// Terms that change nothing, of stubs whose effect is known: `flat` says the same of all robots; `in_order` compares
// robots task by task; `largest_first` begins with the largest number of all, and so heeds what a whole column gets.
#include "mind/coordination/idle_terms.hpp"

#include <gtest/gtest.h>

#include "team.hpp"

namespace regista::mind {
namespace {

config::UtilityTerm term(std::string name, std::string plugin, double weight, int line) {
  config::PluginUse used = use(std::move(plugin));
  used.where = {"team.yaml", line, 5};
  return {std::move(name), std::move(used), weight, {}, {}};
}

config::Team team_of(std::vector<config::UtilityTerm> terms, const char* assigner = "in_order") {
  config::Team out = team();
  out.contexts[0].terms = std::move(terms);
  out.contexts[0].assigner = use(assigner);
  return out;
}

std::vector<bool> idle(config::Team page) { return idle_terms(*plan_of(std::move(page))); }

using Idle = std::vector<bool>;

TEST(IdleTerms, TheSameOfAllRobotsChangesNothingTaskByTask) {
  EXPECT_EQ(idle(team_of({term("near", "nearness", 0.7, 1), term("flat", "flat", 0.3, 2)})), (Idle{false, true}));
  EXPECT_EQ(idle(team_of({term("flat", "flat", 0.3, 1)})), Idle{true});
}

TEST(IdleTerms, WhereTheAssignerHeedsColumnsItMayChangeSomething) {
  EXPECT_EQ(idle(team_of({term("near", "nearness", 0.7, 1), term("flat", "flat", 0.3, 2)}, "largest_first")),
            (Idle{false, false}));
}

TEST(IdleTerms, WithoutAWeightOrWithAMailboxThereIsNoFinding) {
  EXPECT_EQ(idle(team_of({term("flat", "flat", 0.0, 1), term("gossip", "gossip", 1.0, 2)})), (Idle{false, false}));
  EXPECT_EQ(idle(team_of({})), Idle{});
}

TEST(IdleTerms, OneRobotHasNobodyToBeComparedWith) {
  config::Rules rules;
  rules.team_size = 1;
  EXPECT_EQ(idle_terms(*plan_of(team_of({term("near", "nearness", 1.0, 1), term("flat", "flat", 1.0, 2)}), rules)),
            (Idle{false, false}));
}

TEST(IdleTerms, TheSamePlanGivesTheSameAnswer) {
  const auto plan = plan_of(team_of({term("near", "nearness", 0.7, 1), term("flat", "flat", 0.3, 2)}));
  const Idle first = idle_terms(*plan);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(idle_terms(*plan), first);
}

TEST(IdleTerms, AWarningNamesTermPluginAssignerAndPlace) {
  const auto plan = plan_of(team_of({term("near", "nearness", 0.7, 11), term("beauty", "flat", 0.3, 12)}));
  const std::vector<config::Warning> found = idle_term_warnings(*plan, idle_terms(*plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(to_string(found[0]),
            "team.yaml:12:5: warning: utility.terms.beauty: flat gives all robots the same number for a task, which "
            "changes nothing that in_order decides; weight: 0 leaves it out");
}

TEST(IdleTerms, ATermThatCountsInOneContextIsNotWarnedOf) {
  config::Team page = team_of({term("flat", "flat", 0.3, 12)});
  page.contexts.push_back(page.contexts[0]);
  page.contexts[1].name = "other";
  const auto everywhere = plan_of(page);
  EXPECT_EQ(idle_terms(*everywhere), (Idle{true, true}));
  EXPECT_EQ(idle_term_warnings(*everywhere, idle_terms(*everywhere)).size(), 1u);
  page.contexts[1].assigner = use("largest_first");
  const auto somewhere = plan_of(page);
  EXPECT_EQ(idle_terms(*somewhere), (Idle{true, false}));
  EXPECT_TRUE(idle_term_warnings(*somewhere, idle_terms(*somewhere)).empty());
}

}  // namespace
}  // namespace regista::mind
