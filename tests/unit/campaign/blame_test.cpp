// SPDX-License-Identifier: MIT
#include "campaign/blame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace regista::campaign {
namespace {

constexpr int home = 0, away = 1;

Failure failure_of(int side) { return {side, "greedy", "assign", 3, 7, "Segmentation fault"}; }

Attempt shared_died() { return {false, false, false, {}, "Segmentation fault"}; }
Attempt shared_killed() { return {false, false, true, {}, "Killed"}; }
Attempt alone_died(int side) { return {true, false, false, failure_of(side), "Segmentation fault"}; }
Attempt alone_killed(int side) { return {true, false, true, failure_of(side), "Killed"}; }
Attempt match_itself_died() { return {true, false, false, {}, "Segmentation fault"}; }
Attempt shared_played() { return {false, true, false, {}, {}}; }
Attempt alone_played() { return {true, true, false, {}, {}}; }

using Attempts = std::vector<Attempt>;

TEST(Blame, AMatchThatIsPlayedCounts) {
  EXPECT_EQ(judge(Attempts{shared_played()}), Judgement::counts);
  EXPECT_EQ(judge(Attempts{alone_played()}), Judgement::counts);
}

TEST(Blame, WhereTeamsShareAProcessNobodyIsBlamed) {
  EXPECT_EQ(judge(Attempts{shared_died()}), Judgement::play_isolated);
  EXPECT_EQ(judge(Attempts{shared_died(), shared_died()}), Judgement::play_isolated);
  EXPECT_EQ(judge(Attempts{shared_killed()}), Judgement::play_isolated);
}

TEST(Blame, WhoseProcessDiesLoses) {
  for (const int side : {home, away}) {
    EXPECT_EQ(judge(Attempts{shared_died(), alone_died(side)}), Judgement::forfeit);
    EXPECT_EQ(judge(Attempts{shared_died(), alone_played(), alone_died(side)}), Judgement::forfeit);
    EXPECT_EQ(judge(Attempts{shared_killed(), alone_died(side)}), Judgement::forfeit);
  }
}

TEST(Blame, WhatDoesNotComeBackInThreeIsolatedPlaysBlamesNobody) {
  Attempts attempts{shared_died()};
  for (int i = 0; i < 2; ++i) {
    attempts.push_back(alone_played());
    EXPECT_EQ(judge(attempts), Judgement::play_isolated);
  }
  attempts.push_back(alone_played());
  EXPECT_EQ(judge(attempts), Judgement::set_aside);
  EXPECT_EQ(why_set_aside(attempts), "Segmentation fault; it did not come back in 3 isolated plays");
}

// The machine was out of memory, or somebody tidied up: the match is a function, so its result is the same.
TEST(Blame, AKillFromOutsideChangesNothing) {
  EXPECT_EQ(judge(Attempts{shared_killed(), alone_played()}), Judgement::counts);
  EXPECT_EQ(judge(Attempts{shared_killed(), alone_killed(home), alone_played()}), Judgement::counts);
  EXPECT_EQ(judge(Attempts{shared_killed(), alone_killed(home), alone_killed(away), alone_played()}),
            Judgement::counts);
}

TEST(Blame, APluginThatKillsItselfDoesItWheneverItPlaysAlone) {
  const Attempts twice{shared_killed(), alone_killed(away), alone_killed(away)};
  EXPECT_EQ(judge(twice), Judgement::play_isolated);
  EXPECT_EQ(judge(Attempts{shared_killed(), alone_killed(away), alone_killed(away), alone_killed(away)}),
            Judgement::forfeit);
  EXPECT_EQ(judge(Attempts{shared_killed(), alone_killed(away), alone_killed(home), alone_killed(away)}),
            Judgement::play_isolated);
}

// Under `--isolation always` there is no play before the three.
TEST(Blame, ThreeIsolatedPlaysAreEnoughAlsoWhereTheyAreAll) {
  for (const int side : {home, away}) {
    EXPECT_EQ(judge(Attempts{alone_killed(side), alone_killed(side)}), Judgement::play_isolated);
    EXPECT_EQ(judge(Attempts{alone_killed(side), alone_killed(side), alone_killed(side)}), Judgement::forfeit);
  }
}

TEST(Blame, KillsWithoutEndAreTheMachines) {
  Attempts attempts;
  for (std::size_t i = 0; i + 1 < most_failures; ++i) {
    attempts.push_back(i % 2 == 0 ? alone_killed(home) : alone_killed(away));
    EXPECT_EQ(judge(attempts), Judgement::play_isolated);
  }
  attempts.push_back(shared_killed());
  EXPECT_EQ(judge(attempts), Judgement::give_up);
}

TEST(Blame, AMatchThatDiesWithoutAnyPluginIsNoTeams) {
  EXPECT_EQ(judge(Attempts{shared_died(), match_itself_died()}), Judgement::play_isolated);
  EXPECT_EQ(judge(Attempts{shared_died(), match_itself_died(), match_itself_died(), match_itself_died()}),
            Judgement::give_up);
}

// Whatever happens, in whatever order: who forfeits has died alone, and the other side never has to pay.
TEST(Blame, OnlyASideWhoseOwnProcessFailedForfeits) {
  const Attempts kinds{shared_died(),      shared_killed(),     alone_died(home), alone_killed(home),
                       alone_killed(away), match_itself_died(), shared_played(),  alone_played()};
  std::vector<Attempts> open{{}};
  int forfeits = 0, ended = 0;
  for (int length = 1; length <= 6; ++length) {
    std::vector<Attempts> longer;
    for (const Attempts& before : open) {
      for (const Attempt& next : kinds) {
        Attempts attempts = before;
        attempts.push_back(next);
        const Judgement judgement = judge(attempts);
        if (judgement == Judgement::play_isolated) {
          longer.push_back(attempts);
          continue;
        }
        ++ended;
        if (judgement == Judgement::forfeit) {
          ++forfeits;
          ASSERT_TRUE(attempts.back().isolated && attempts.back().failure);
          if (attempts.back().failure->side == away) {
            ASSERT_TRUE(attempts.back().from_outside);
            ASSERT_GE(std::ranges::count_if(attempts, [](const Attempt& each) { return each.isolated; }), 3);
          }
        }
        if (judgement == Judgement::counts) {
          ASSERT_TRUE(attempts.back().played);
        }
        if (judgement == Judgement::set_aside) {
          ASSERT_GE(std::ranges::count_if(attempts, [](const Attempt& a) { return a.isolated && a.played; }), 3);
        }
      }
    }
    open = std::move(longer);
  }
  EXPECT_TRUE(open.empty() || open.size() < 100'000);
  EXPECT_GT(forfeits, 0);
  EXPECT_GT(ended, forfeits);
}

TEST(Blame, ADeathInWordsNamesTheCall) {
  plugin::CallNote note;
  EXPECT_EQ(in_words("Aborted", note), "Aborted");
  note.plugin = plugin::note_of_id("greedy");
  std::strcpy(note.call.data(), "assign");
  note.side = 1;
  note.robot = 3;
  note.tick = 41;
  note.inside = 1;
  EXPECT_EQ(in_words("Aborted", note),
            "Aborted; the present call was assign of plugin greedy (away, robot 3, tick 41)");
  note.inside = 0;
  EXPECT_EQ(in_words("Aborted", note), "Aborted; the last call was assign of plugin greedy (away, robot 3, tick 41)");
}

TEST(Blame, AForfeitIsLostByTen) {
  EXPECT_EQ(forfeit(failure_of(away), 2.0).score, (std::array<int, 2>{10, 0}));
  EXPECT_EQ(forfeit(failure_of(home), 2.0).score, (std::array<int, 2>{0, 10}));
}

TEST(Note, LongIdsAreCutOff) {
  const auto noted = plugin::note_of_id(std::string(100, 'x'));
  EXPECT_EQ(std::string(noted.data()), std::string(63, 'x'));
}

}  // namespace
}  // namespace regista::campaign
