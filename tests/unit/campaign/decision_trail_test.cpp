// SPDX-License-Identifier: MIT
// Trails as a worker writes them, made here byte by byte, so that reader and writer cannot agree on a mistake.
#include "campaign/decision_trail.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <string>
#include <vector>

namespace regista::campaign {
namespace {

template <class T>
std::string raw(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string text(const std::string& value) { return raw(static_cast<std::uint32_t>(value.size())) + value; }

// The head: for either side a list with the plugins of each step.
std::string head(const std::string& home = "greedy", const std::string& away = "hungarian") {
  std::string out;
  for (const std::string& side : {home, away}) {
    out += raw(static_cast<std::uint32_t>(match::decision_steps));
    for (std::size_t step = 0; step < match::decision_steps; ++step) out += text(step == 8 ? side : "");
  }
  return out;
}

// changed: the step whose digest is another one; -1 for none.
std::string decision(double time, int side, int robot, int changed = -1) {
  std::string out = raw(time) + raw(std::int32_t{side}) + raw(std::int32_t{robot});
  for (int step = 0; step < static_cast<int>(match::decision_steps); ++step) {
    out += raw(static_cast<std::uint64_t>(1000 * robot + step + (step == changed ? 7 : 0)));
  }
  return out;
}

TEST(DecisionTrail, EqualOnesDoNotDiffer) {
  const std::string trail = head() + decision(0.1, 0, 1) + decision(0.2, 1, 1);
  EXPECT_EQ(first_difference(trail, trail), "");
  EXPECT_EQ(first_difference("", ""), "");
}

TEST(DecisionTrail, NamesTheFirstStepThatDiffers) {
  const std::string before = head() + decision(0.1, 0, 1) + decision(0.15, 1, 4) + decision(0.2, 0, 1);
  const std::string after = decision(0.4, 0, 1);
  EXPECT_EQ(first_difference(before + decision(0.3, 0, 1) + after, before + decision(0.3, 0, 1, 8) + after),
            "home, robot 1, tick 2 (0.30 s): the assignment first differed, computed by greedy");
  EXPECT_EQ(first_difference(before + decision(0.3, 1, 4) + after, before + decision(0.3, 1, 4, 8) + after),
            "away, robot 4, tick 1 (0.30 s): the assignment first differed, computed by hungarian");
  // Whatever differs later does not matter.
  EXPECT_EQ(first_difference(before + decision(0.3, 0, 1) + after, before + decision(0.3, 0, 1, 0) + decision(9, 1, 9)),
            "home, robot 1, tick 2 (0.30 s): the own pose first differed");
}

TEST(DecisionTrail, OtherPlugins) {
  EXPECT_EQ(first_difference(head("greedy") + decision(0.1, 0, 1), head("regret") + decision(0.1, 0, 1)),
            "the teams differ");
}

TEST(DecisionTrail, AnotherTurn) {
  EXPECT_EQ(first_difference(head() + decision(0.1, 0, 1), head() + decision(0.1, 0, 2)),
            "home, robot 1, tick 0 (0.10 s): it was not its turn in the second play");
}

TEST(DecisionTrail, WhatEndsEarlier) {
  const std::string whole = head() + decision(0.1, 0, 1) + decision(0.2, 0, 1);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_EQ(first_difference(whole, whole.substr(0, length)), "one of the plays ended earlier") << length;
  }
}

TEST(DecisionTrail, TheFileIsBegunAnew) {
  const TrailFile file;
  ASSERT_EQ(::write(file.descriptor(), "first play", 10), 10);
  EXPECT_EQ(file.content(), "first play");
  TrailFile again;
  ASSERT_EQ(::write(again.descriptor(), "a longer first play", 19), 19);
  again.clear();
  ASSERT_EQ(::write(again.descriptor(), "second", 6), 6);
  EXPECT_EQ(again.content(), "second");
}

}  // namespace
}  // namespace regista::campaign
