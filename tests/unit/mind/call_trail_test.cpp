// SPDX-License-Identifier: MIT
// Two minds that were told the same answer the same, call for call; told something else, the first answer that differs
// is that of the plugin that uses it.
#include "plugin/call_inputs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "team.hpp"

namespace regista::mind {
namespace {

// What the plugins of a robot of this team answered in its first decision, whose percepts were changed.
plugin::CallTrail answers(const TeamPlan& plan, const std::function<void(Percepts&)>& change) {
  plugin::CallNote note;
  plugin::CallTrail trail;
  Mind mind(plan, 3, 7, {&note, 0, plugin::Inspection::always, &trail});
  Outcome outcome;
  Percepts given = percepts(1.0);
  given.placed = placed(-1.0, 1.0);
  change(given);
  mind.think(given, {}, outcome);
  return trail;
}

void nothing(Percepts&) {}

std::string first_difference(const plugin::CallTrail& one, const plugin::CallTrail& other) {
  const auto [at, there] = std::ranges::mismatch(one, other);
  if (at == one.end()) return there == other.end() ? "none" : "more";
  return std::string(at->plugin.data()) + " " + at->call.data();
}

std::string told(const config::Team& team, const std::function<void(Percepts&)>& change) {
  const auto plan = plan_of(team);
  return first_difference(answers(*plan, nothing), answers(*plan, change));
}

TEST(CallTrail, IsTheSameOfTheSame) { EXPECT_EQ(told(team(), nothing), "none"); }

TEST(CallTrail, HasTheCallsOfADecisionInTheirOrder) {
  const auto plan = plan_of(team());
  std::vector<std::string> calls;
  for (const plugin::CallAnswer& each : answers(*plan, nothing)) {
    if (calls.empty() || calls.back() != each.call.data()) calls.emplace_back(each.call.data());
  }
  // One of the terms makes an offer. What goes into a packet is asked last.
  EXPECT_EQ(calls, (std::vector<std::string>{"tracks", "holds", "place", "score", "offer", "score", "assign", "act",
                                             "decide", "tracks"}));
}

TEST(CallTrail, BeginsToDifferWhereWhatDiffersIsUsed) {
  EXPECT_EQ(told(team(), [](Percepts& given) { given.placed = placed(-1.0, 1.5); }), "still tracks");
  EXPECT_EQ(told(team(), [](Percepts& given) { given.balls.push_back({{1.0, 0.5}, 0.1, 0.1}); }), "still tracks");
  config::Team thrifty = team();
  thrifty.contexts.front().sender = use("even");
  EXPECT_EQ(told(thrifty, [](Percepts& given) { given.game.packets_left = 0; }), "even decide");
}

}  // namespace
}  // namespace regista::mind
