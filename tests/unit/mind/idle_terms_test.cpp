// SPDX-License-Identifier: MIT
// Terms that change nothing, of stubs whose effect is known: `flat` says the same of all robots; `in_order` compares
// robots task by task; `largest_first` begins with the largest number of all, and so heeds what a whole column gets.
#include "mind/coordination/unused_parts.hpp"

#include <gtest/gtest.h>

#include "team.hpp"

namespace regista::mind {
namespace {

config::UtilityTerm term(std::string name, std::string plugin, double weight, int line) {
  config::PluginUse used = use(std::move(plugin));
  used.where = {"team.yaml", line, 5};
  return {std::move(name), std::move(used), weight, {}};
}

config::Team team_of(std::vector<config::UtilityTerm> terms, const char* assigner = "in_order") {
  config::Team out = team();
  out.contexts[0].terms = std::move(terms);
  out.contexts[0].assigner = use(assigner);
  return out;
}

std::vector<bool> idle(config::Team page) { return idle_terms(*plan_of(std::move(page))); }

std::vector<config::Warning> warned(const TeamPlan& plan) {
  return idle_term_warnings(plan, idle_terms(plan), terms_without_waypoints(plan));
}

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
  const std::vector<config::Warning> found = warned(*plan);
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
  EXPECT_EQ(warned(*everywhere).size(), 1u);
  page.contexts[1].assigner = use("largest_first");
  const auto somewhere = plan_of(page);
  EXPECT_EQ(idle_terms(*somewhere), (Idle{true, false}));
  EXPECT_TRUE(warned(*somewhere).empty());
}

TEST(IdleTerms, NearnessToWaypointsNeedsAPositioner) {
  config::Team page = team_of({term("points", "near_points", 0.7, 11), term("flat", "flat", 0.3, 12),
                               term("near", "nearness", 0.3, 13), term("gossip", "gossip", 0.3, 14)},
                              "largest_first");
  page.contexts[0].positioner = {};
  const auto without = plan_of(page);
  EXPECT_EQ(terms_without_waypoints(*without), (Idle{true, false, false, false}));
  ASSERT_EQ(warned(*without).size(), 1u);
  EXPECT_EQ(to_string(warned(*without)[0]),
            "team.yaml:11:5: warning: utility.terms.points: near_points rewards nearness to waypoints, which the team "
            "has no positioner to make: it changes nothing");

  config::Team some = page;
  some.contexts.push_back(some.contexts[0]);
  some.contexts[0].name = "first";
  some.contexts[0].positioner = use("triangle");
  const auto somewhere = plan_of(some);
  EXPECT_EQ(terms_without_waypoints(*somewhere), (Idle{false, false, false, false, true, false, false, false}));
  ASSERT_EQ(warned(*somewhere).size(), 1u);
  EXPECT_EQ(to_string(warned(*somewhere)[0]),
            "team.yaml:11:5: warning: utility.terms.points: near_points rewards nearness to waypoints, which context "
            "playing has no positioner to make: it changes nothing there");

  page.contexts[0].positioner = use("triangle");
  EXPECT_EQ(terms_without_waypoints(*plan_of(page)), (Idle{false, false, false, false}));
  page.contexts[0].positioner = {};
  page.contexts[0].terms[0].weight = 0.0;
  EXPECT_EQ(terms_without_waypoints(*plan_of(page)), (Idle{false, false, false, false}));
}

// What is said of waypoints is not said again in other words.
TEST(IdleTerms, ATermIsWarnedOfOnce) {
  config::Team page = team_of({term("points", "near_points", 0.7, 11), term("near", "nearness", 0.3, 13)});
  page.contexts[0].positioner = {};
  const auto plan = plan_of(page);
  EXPECT_EQ(idle_terms(*plan), (Idle{true, false}));
  ASSERT_EQ(warned(*plan).size(), 1u);
  EXPECT_NE(warned(*plan)[0].message.find("waypoints"), std::string::npos);
}

}  // namespace
}  // namespace regista::mind
