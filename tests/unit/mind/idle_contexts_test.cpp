// SPDX-License-Identifier: MIT
// Contexts that may never be in force, of windows of time, which hold when their parameters say so.
#include "mind/coordination/unused_parts.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "team.hpp"

namespace regista::mind {
namespace {

struct Condition {
  std::string name;
  double from, to;  // s; a match lasts 1300
  std::string plugin = "window";
};

config::Team team_of(const std::vector<Condition>& conditions) {
  config::Team out = team();
  const config::Context whole = out.contexts[0];
  out.contexts.clear();
  for (const Condition& each : conditions) {
    config::Context& context = out.contexts.emplace_back(whole);
    context.name = each.name;
    context.use = each.plugin == "window"
                      ? use("window", {{"from", fmt::format("{}", each.from)}, {"to", fmt::format("{}", each.to)}})
                      : use(each.plugin);
    context.where = {"team.yaml", static_cast<int>(out.contexts.size()), 5};
  }
  return out;
}

std::vector<std::string> warned(const std::vector<Condition>& conditions) {
  const auto plan = plan_of(team_of(conditions));
  std::vector<std::string> out;
  for (const config::Warning& each : idle_context_warnings(*plan, idle_contexts(*plan))) {
    out.push_back(to_string(each));
  }
  return out;
}

using None = std::vector<std::string>;
using One = std::vector<std::string>;

TEST(IdleContexts, ATeamWhoseContextsAllComeIntoForceIsNotWarnedOf) {
  EXPECT_EQ(warned({{"whole", 0, 1e6}}), None{});
  EXPECT_EQ(warned({{"early", 0, 200}, {"late", 1100, 1e6}, {"whole", 0, 1e6}}), None{});
  EXPECT_EQ(warned({{"first", 0, 600}, {"second", 600, 1e6}}), None{});
}

TEST(IdleContexts, OneThatHoldsInNoScene) {
  EXPECT_EQ(warned({{"never", 2, 1}, {"whole", 0, 1e6}}),
            One{"team.yaml:1:5: warning: contexts.never: window held in none of 12000 made-up scenes (score, set play, "
                "ball, robots): with these parameters it may never hold"});
}

TEST(IdleContexts, OneThatAlwaysComesSecond) {
  const auto check = [](const std::vector<Condition>& conditions, const std::string& begins, const std::string& ends) {
    const std::vector<std::string> found = warned(conditions);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].starts_with(begins)) << found[0];
    EXPECT_TRUE(found[0].ends_with(ends)) << found[0];
  };
  check({{"other", 0, 100}, {"early", 0, 700}, {"start", 100, 500}, {"whole", 0, 1e6}},
        "team.yaml:3:5: warning: contexts.start: in each of the ",
        " made-up scenes in which window held, early (team.yaml:2:5), which comes first, held too: it may never be in "
        "force");
  check({{"first", 0, 600}, {"second", 600, 1e6}, {"middle", 500, 700}},
        "team.yaml:3:5: warning: contexts.middle: in each of the ",
        " made-up scenes in which window held, one of those above it, which come first, held too: it may never be in "
        "force");
}

TEST(IdleContexts, ScenesWithoutAny) {
  const std::vector<std::string> found = warned({{"early", 0, 300}, {"late", 900, 1e6}});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].starts_with("team.yaml:2:5: warning: contexts: none holds in ")) << found[0];
  EXPECT_TRUE(found[0].ends_with(
      " of 12000 made-up scenes, and then no robot has a role: plugin: always, below late, holds at all times"))
      << found[0];
}

TEST(IdleContexts, WhatHeedsMessagesMayHoldAtAnyTime) {
  EXPECT_EQ(warned({{"told", 0, 0, "rumour"}, {"early", 0, 300}}), None{});
  EXPECT_EQ(warned({{"whole", 0, 1e6}, {"told", 0, 0, "rumour"}}), None{});
}

// The context of a set play: which of them, the last phase and whose, as numbers of the ABI; -1: of both teams.
struct OfSetPlay {
  int set_play, last_phase, own_kick = -1;
};

std::vector<std::string> warned_of_set_plays(const std::vector<OfSetPlay>& contexts) {
  config::Team page = team_of(std::vector<Condition>(contexts.size() + 1, {"whole", 0, 1e6}));
  for (std::size_t i = 0; i < contexts.size(); ++i) {
    page.contexts[i].use = use("in_set_play", {{"set_play", fmt::format("{}", contexts[i].set_play)},
                                               {"last_phase", fmt::format("{}", contexts[i].last_phase)},
                                               {"own_kick", fmt::format("{}", contexts[i].own_kick)}});
  }
  const auto plan = plan_of(page);
  std::vector<std::string> out;
  for (const config::Warning& each : idle_context_warnings(*plan, idle_contexts(*plan))) out.push_back(each.message);
  return out;
}

std::string none_is_for(const std::string& what) {
  return "contexts: none is for a " + what + ", though one is for another set play: robots act as in open play";
}

TEST(SetPlays, OneWithoutAContextIsNamedWithItsPhases) {
  constexpr int any = 0, set = REGISTA_PHASE_SET, playing = REGISTA_PHASE_PLAYING;
  EXPECT_EQ(warned_of_set_plays({{any, playing}}), None{});
  EXPECT_EQ(warned_of_set_plays({{REGISTA_SET_PLAY_KICK_OFF, set}}), One{none_is_for("penalty kick in Ready and Set")});
  EXPECT_EQ(warned_of_set_plays({{REGISTA_SET_PLAY_PENALTY_KICK, playing}}),
            (std::vector{none_is_for("kick-off in Ready and Set"), none_is_for("kick-in in Playing"),
                         none_is_for("goal kick in Playing"), none_is_for("corner kick in Playing"),
                         none_is_for("pushing free kick in Playing")}));
}

TEST(SetPlays, OneOfWhichOnlyOneSideHasAContextIsNamedWithTheOther) {
  constexpr int set = REGISTA_PHASE_SET, kick_off = REGISTA_SET_PLAY_KICK_OFF, penalty = REGISTA_SET_PLAY_PENALTY_KICK;
  EXPECT_EQ(warned_of_set_plays({{kick_off, set}, {penalty, set, 1}}),
            One{none_is_for("penalty kick of the opponent in Ready and Set")});
  EXPECT_EQ(warned_of_set_plays({{kick_off, set}, {penalty, REGISTA_PHASE_READY, 1}, {penalty, set, 0}}),
            One{none_is_for("penalty kick of this team in Set")});
  EXPECT_EQ(warned_of_set_plays({{kick_off, set, 0}, {penalty, set, 0}}),
            (std::vector{none_is_for("kick-off of this team in Ready and Set"),
                         none_is_for("penalty kick of this team in Ready and Set")}));
  EXPECT_EQ(warned_of_set_plays({{kick_off, set, 0}, {kick_off, set, 1}, {penalty, set, 0}, {penalty, set, 1}}),
            None{});
}

TEST(SetPlays, ATeamWithoutContextsOfSetPlaysIsNotWarnedOf) { EXPECT_EQ(warned_of_set_plays({}), None{}); }

TEST(IdleContexts, TheSamePlanGivesTheSameAnswer) {
  const auto plan = plan_of(team_of({{"early", 0, 300}, {"late", 200, 700}}));
  const ContextFindings first = idle_contexts(*plan), again = idle_contexts(*plan);
  EXPECT_EQ(first.scenes, 12000);
  EXPECT_EQ(first.without, again.without);
  EXPECT_EQ(first.contexts[0].in_force + first.contexts[1].in_force + first.without, first.scenes);
  EXPECT_GT(first.contexts[1].held, first.contexts[1].in_force);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(first.contexts[i].held, again.contexts[i].held);
}

}  // namespace
}  // namespace regista::mind
