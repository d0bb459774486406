// SPDX-License-Identifier: MIT
#include "campaign/blame.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace regista::campaign {
namespace {

End death(End::How how, int side, std::uint64_t tick, const char* id = "greedy") {
  End out;
  out.how = how;
  out.text = "Segmentation fault";
  out.note.plugin = plugin::note_of_id(id);
  out.note.call = {'a', 's', 's', 'i', 'g', 'n'};
  out.note.side = side;
  out.note.robot = 3;
  out.note.tick = tick;
  out.note.inside = 1;
  return out;
}

Judgement judged(std::vector<End> deaths) { return judge(deaths); }

constexpr auto died = End::How::died, outside = End::How::killed_from_outside;

TEST(Blame, OneDeathIsTriedAgain) {
  EXPECT_EQ(judged({death(died, 0, 5)}), Judgement::play_again);
  EXPECT_EQ(judged({death(outside, 0, 5)}), Judgement::play_again);
  EXPECT_EQ(judged({death(died, 0, 0, "")}), Judgement::play_again);
}

TEST(Blame, TwoDeathsInTheSameHandsAreAForfeit) {
  EXPECT_EQ(judged({death(died, 0, 5), death(died, 0, 5)}), Judgement::forfeit);
  EXPECT_EQ(judged({death(died, 1, 5), death(End::How::processor_time, 1, 9)}), Judgement::forfeit);
}

TEST(Blame, TwoDeathsInDifferentHandsNeedAThirdTry) {
  EXPECT_EQ(judged({death(died, 0, 5), death(died, 1, 7)}), Judgement::play_again);
  EXPECT_EQ(judged({death(died, 0, 5), death(died, 1, 7), death(died, 1, 9)}), Judgement::forfeit);
}

TEST(Blame, KillsFromOutsideAreNobodysFault) {
  EXPECT_EQ(judged({death(outside, 0, 5), death(outside, 0, 6)}), Judgement::play_again);
  EXPECT_EQ(judged({death(outside, 0, 5), death(died, 0, 6)}), Judgement::play_again);
  std::vector<End> deaths;
  for (std::uint64_t tick = 0; tick < most_deaths; ++tick) deaths.push_back(death(outside, 0, tick));
  EXPECT_EQ(judge(deaths), Judgement::give_up);
}

TEST(Blame, APluginThatKillsItselfDoesItInTheSameCall) {
  EXPECT_EQ(judged({death(outside, 1, 5), death(outside, 1, 5)}), Judgement::forfeit);
}

TEST(Blame, NobodyIsBlamedBeforeAnyPluginWasCalled) {
  EXPECT_EQ(judged({death(died, 0, 0, ""), death(died, 0, 0, "")}), Judgement::give_up);
  EXPECT_FALSE(suspect(death(died, 0, 0, "")).has_value());
}

TEST(Blame, TheSuspectIsWhoWasCalledLast) {
  const Failure expected{1, "greedy", "assign", 3, 7, "Segmentation fault"};
  EXPECT_EQ(suspect(death(died, 1, 7)), expected);
  End after = death(died, 1, 7);
  after.note.inside = 0;
  EXPECT_EQ(suspect(after)->what, "Segmentation fault, after this call");
}

TEST(Blame, AForfeitIsLostByTen) {
  EXPECT_EQ(forfeit(*suspect(death(died, 1, 7)), 2.0).score, (std::array<int, 2>{10, 0}));
  EXPECT_EQ(forfeit(*suspect(death(died, 0, 7)), 2.0).score, (std::array<int, 2>{0, 10}));
}

}  // namespace
}  // namespace regista::campaign
