// SPDX-License-Identifier: MIT
// Two minds that were told the same decide the same; told something else, the first step that differs is the one that
// uses it.
#include "match/decision_digest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "team.hpp"

namespace regista::mind {
namespace {

using match::DecisionDigest;

// The digest of the first decision of a robot of this team, whose percepts were changed.
DecisionDigest digest(const TeamPlan& plan, const std::function<void(Percepts&)>& change) {
  Mind mind(plan, 3, 7);
  Outcome outcome;
  Percepts given = percepts(1.0);
  given.placed = placed(-1.0, 1.0);
  change(given);
  mind.think(given, {}, outcome);
  return match::digest_of(mind, outcome);
}

std::string first_difference(const DecisionDigest& one, const DecisionDigest& other) {
  const auto at = std::ranges::mismatch(one, other).in1;
  return at == one.end() ? "none" : std::string(match::step_name(static_cast<std::size_t>(at - one.begin())));
}

std::string told(const config::Team& team, const std::function<void(Percepts&)>& change) {
  const auto plan = plan_of(team);
  return first_difference(digest(*plan, [](Percepts&) {}), digest(*plan, change));
}

TEST(DecisionDigest, IsTheSameOfTheSame) {
  EXPECT_EQ(told(team(), [](Percepts&) {}), "none");
}

TEST(DecisionDigest, BeginsToDifferWhereWhatDiffersIsUsed) {
  EXPECT_EQ(told(team(), [](Percepts& given) { given.placed = placed(-1.0, 1.5); }), "the own pose");
  EXPECT_EQ(told(team(), [](Percepts& given) { given.balls.push_back({{1.0, 0.5}, 0.1, 0.1}); }), "the ball");
  EXPECT_EQ(told(team(),
                 [](Percepts& given) {
                   given.robots.push_back({{1.0, 0.5}, 0.1, 0.1, false});
                 }),
            "the opponents");
  config::Team thrifty = team();
  thrifty.contexts.front().sender = use("even");
  EXPECT_EQ(told(thrifty, [](Percepts& given) { given.game.packets_left = 0; }), "the packet");
}

// Teams that differ in one plugin alone, which answers otherwise.
TEST(DecisionDigest, TellsWhichPluginsMayHaveAnsweredOtherwise) {
  const auto usual = plan_of(team());
  const auto between = [&](const std::function<void(config::Team&)>& change) {
    config::Team other = team();
    change(other);
    const auto plan = plan_of(other);
    const auto nothing = [](Percepts&) {};
    return first_difference(digest(*usual, nothing), digest(*plan, nothing));
  };
  EXPECT_EQ(between([](config::Team& team) { team.contexts.front().positioner = {}; }), "the points");
  EXPECT_EQ(between([](config::Team& team) { team.contexts.front().terms.front().weight = 0.5; }), "the utilities");

  EXPECT_EQ(match::plugins_of_step(*usual, 0), "still");
  EXPECT_EQ(match::plugins_of_step(*usual, 4), "window");
  EXPECT_EQ(match::plugins_of_step(*usual, 5), "triangle");
  EXPECT_EQ(match::plugins_of_step(*usual, 7), "nearness, gossip");
  EXPECT_EQ(match::plugins_of_step(*usual, 8), "in_order");
  EXPECT_EQ(match::plugins_of_step(*usual, 9), "walks");
  EXPECT_EQ(match::plugins_of_step(*usual, 10), "steady");
}

}  // namespace
}  // namespace regista::mind
