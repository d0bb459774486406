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

// An answer. `name`: which of the names so far, or a new one that is defined here.
std::string answer(std::uint32_t name, std::uint64_t digest, const std::string& plugin = "",
                   const std::string& call = "") {
  return raw(name) + raw(digest) + (plugin.empty() ? "" : text(plugin) + text(call));
}

std::string decision(double time, int side, int robot, const std::vector<std::string>& answers,
                     std::uint64_t outcome = 9) {
  std::string out = raw(time) + raw(std::int32_t{side}) + raw(std::int32_t{robot}) + raw(outcome) +
                    raw(static_cast<std::uint32_t>(answers.size()));
  for (const std::string& each : answers) out += each;
  return out;
}

// The first decision, which names both calls.
std::string beginning(std::uint64_t chosen = 1, std::uint64_t assigned = 2) {
  return decision(0.1, 0, 1, {answer(0, chosen, "window", "holds"), answer(1, assigned, "greedy", "assign")});
}

std::string later(double time, int side, int robot, std::uint64_t chosen, std::uint64_t assigned,
                  std::uint64_t outcome = 9) {
  return decision(time, side, robot, {answer(0, chosen), answer(1, assigned)}, outcome);
}

TEST(DecisionTrail, EqualOnesDoNotDiffer) {
  const std::string trail = beginning() + later(0.2, 1, 1, 3, 4);
  EXPECT_EQ(first_difference(trail, trail), "");
  EXPECT_EQ(first_difference("", ""), "");
}

TEST(DecisionTrail, NamesTheFirstCallThatWasAnsweredOtherwise) {
  const std::string before = beginning() + later(0.15, 1, 4, 1, 1) + later(0.2, 0, 1, 1, 1);
  const std::string after = later(0.4, 0, 1, 7, 7);
  EXPECT_EQ(first_difference(before + later(0.3, 0, 1, 5, 6) + after, before + later(0.3, 0, 1, 5, 8) + after),
            "home, robot 1, tick 2 (0.30 s): plugin greedy answered assign otherwise");
  EXPECT_EQ(first_difference(before + later(0.3, 1, 4, 5, 6) + after, before + later(0.3, 1, 4, 5, 8) + after),
            "away, robot 4, tick 1 (0.30 s): plugin greedy answered assign otherwise");
  // What follows from it does not matter.
  EXPECT_EQ(
      first_difference(before + later(0.3, 0, 1, 5, 6) + after, before + later(0.3, 0, 1, 0, 8) + later(9, 1, 9, 0, 0)),
      "home, robot 1, tick 2 (0.30 s): plugin window answered holds otherwise");
  EXPECT_EQ(first_difference(beginning(1, 2), beginning(1, 3)),
            "home, robot 1, tick 0 (0.10 s): plugin greedy answered assign otherwise");
}

TEST(DecisionTrail, WhatIsDoneWithTheHostIsItsDoersWhereOnlyOnePlayHasIt) {
  const std::string offers = decision(0.2, 0, 1, {answer(2, 5, "talker", "offer"), answer(0, 1), answer(1, 1)});
  const std::string does_not = decision(0.2, 0, 1, {answer(0, 1), answer(1, 1)});
  const std::string named = "home, robot 1, tick 1 (0.20 s): plugin talker made another offer";
  EXPECT_EQ(first_difference(beginning() + offers, beginning() + does_not), named);
  EXPECT_EQ(first_difference(beginning() + does_not, beginning() + offers), named);
}

TEST(DecisionTrail, AnotherOutcomeOfTheSameAnswers) {
  EXPECT_EQ(first_difference(beginning() + later(0.2, 0, 1, 1, 1, 9), beginning() + later(0.2, 0, 1, 1, 1, 8)),
            "home, robot 1, tick 1 (0.20 s): what it did differed, though its plugins answered the same");
}

TEST(DecisionTrail, AnotherTurn) {
  EXPECT_EQ(first_difference(beginning() + later(0.2, 0, 2, 1, 1), beginning() + later(0.2, 0, 3, 1, 1)),
            "home, robot 2, tick 0 (0.20 s): it was not its turn in the second play");
}

TEST(DecisionTrail, WhatEndsEarlier) {
  const std::string whole = beginning() + later(0.2, 0, 1, 1, 1);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_EQ(first_difference(whole, whole.substr(0, length)), "one of the plays ended earlier") << length;
  }
}

TEST(DecisionTrail, ADamagedOneIsNoCrash) {
  const std::string whole = beginning() + later(0.2, 0, 1, 1, 1);
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x7f);
    EXPECT_NE(first_difference(whole, damaged), "") << at;
  }
}

TEST(DecisionTrail, TheFileIsBegunAnew) {
  const process::FileDescriptor trail = trail_file();
  ASSERT_EQ(::write(trail.number, "a longer first play", 19), 19);
  EXPECT_EQ(process::everything_in(trail.number), "a longer first play");
  empty_trail(trail.number);
  ASSERT_EQ(::write(trail.number, "second", 6), 6);
  EXPECT_EQ(process::everything_in(trail.number), "second");
}

}  // namespace
}  // namespace regista::campaign
