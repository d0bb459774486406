// SPDX-License-Identifier: MIT
// What robots conclude from packets that answer, and from silence.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include "test_team.hpp"

namespace {

using namespace token_passing;

// Robot 1 of three, alone with what the test lets it hear.
struct Single {
  Robot robot;
  Settings settings;
  std::vector<std::int32_t> able;
  double now = 0.0;
  Single(std::vector<std::int32_t> capability) : able(std::move(capability)) { robot.reserve(3, 2); }

  const Token& decide() {
    const std::vector<Work> work{{0, 0, able}};
    robot.decide(settings, {now, 1, 7, work});
    return *robot.token(0);
  }
  void speak(int packets, double every) {
    for (int i = 0; i < packets; ++i, now += every) {
      decide();
      robot.transmitted(robot.told().size());
    }
  }
  // Another robot speaks, and says nothing of token 0.
  void hear_of_something_else(int sender) {
    Told other;
    other.id = 1;
    other.token = {.generation = 1, .creator = 3, .holder = static_cast<std::uint8_t>(sender), .kept = true};
    robot.hear(1, sender, std::vector{other}, now, now, false);
  }
};

TEST(Answers, WhoSpeaksAndDoesNotKnowHasNotHeard) {
  Single one({100, 900, 800});
  EXPECT_EQ(one.decide().holder, 2);
  one.speak(3, 1.0);
  one.hear_of_something_else(2);  // a moment after the last packet: it may not have arrived
  EXPECT_EQ(one.decide().holder, 2);
  one.now += 1.5;
  one.hear_of_something_else(2);
  EXPECT_EQ(one.decide().holder, 3);
  EXPECT_EQ(one.decide().generation, 2);
  EXPECT_EQ(one.decide().visited, only(1) | only(2));
}

TEST(Answers, TooFewPacketsProveNothing) {
  Single one({100, 900, 800});
  one.speak(2, 1.0);
  one.robot.decide(one.settings, {one.now, 1, 7, {}});
  EXPECT_FALSE(one.robot.is_urgent());
  one.now += 3.0;
  one.hear_of_something_else(2);
  EXPECT_EQ(one.decide().holder, 2);
  EXPECT_TRUE(one.robot.is_urgent()) << "it is sent again at once";
}

TEST(Answers, APacketWithoutTokensIsAnAnswerToo) {
  Single one({100, 900, 800});
  one.speak(3, 1.0);
  one.now += 1.5;
  one.robot.overhear(1, 2, one.now);
  EXPECT_TRUE(one.robot.was_heard(2));
  EXPECT_EQ(one.decide().holder, 3);
}

// It was passed to robot 2, which does it, and then no longer says so: that it is done was lost.
TEST(Answers, AHolderThatDoesNotNameItsTokenHasNone) {
  const auto holder_after = [](int packets, bool says_all) {
    Single one({100, 900, 800});
    one.speak(1, 1.0);
    Told kept{0, *one.robot.token(0)};
    kept.token.kept = true;
    ++kept.token.hop;
    one.robot.hear(1, 2, std::vector{kept}, one.now, one.now, true);
    one.able[1] = -1;
    for (int i = 0; i < packets; ++i) {
      one.now += 1.0;
      one.robot.overhear(1, 2, one.now);
      one.robot.overhear(1, 2, one.now);  // the same
      if (says_all) continue;
      kept.id = 1;
      one.now += 0.1;
      one.robot.hear(1, 2, std::vector{kept}, one.now, one.now, false);  // had no room for the other
      kept.id = 0;
      one.robot.hear(1, 2, std::vector{kept}, one.now + 0.1, one.now + 0.1, true);
    }
    return static_cast<int>(one.decide().holder);
  };
  EXPECT_EQ(holder_after(2, true), 2);
  EXPECT_EQ(holder_after(3, true), 3);
  EXPECT_EQ(holder_after(9, false), 2);
}

TEST(Answers, WhoIsSilentLosesTheTokenAfterPatience) {
  Single one({100, 900, 800});
  one.speak(3, 1.0);
  one.now += one.settings.patience - 1.5;  // the last packet left a second ago
  EXPECT_EQ(one.decide().holder, 2);
  one.now += 1.0;
  EXPECT_EQ(one.decide().holder, 3);
}

TEST(Answers, WhoeverIsTheOnlyOneIsToldAgainAndAgain) {
  Single one({-1, 900, -1});
  for (int i = 0; i < 30; ++i) {
    one.speak(1, 1.0);
    one.hear_of_something_else(2);
    ASSERT_EQ(one.decide().holder, 2);
    ASSERT_EQ(one.decide().generation, 1);
    ASSERT_EQ(one.robot.told().size(), 1u);
  }
}

TEST(Answers, WhoRefusedAgainstThePredictionIsAskedAgainAfterARest) {
  Single one({100, 900, -1});
  EXPECT_EQ(one.decide().holder, 2);
  one.speak(1, 1.0);
  Told back;
  back.token = *one.robot.token(0);
  back.token.holder = 1;
  back.token.visited |= only(2);
  ++back.token.hop;
  one.robot.hear(1, 2, std::vector{back}, one.now, one.now, false);
  const double refused = one.now;
  EXPECT_EQ(one.decide().holder, 1);  // at a threshold that has fallen
  EXPECT_TRUE(one.robot.token(0)->kept);
  one.able[0] = -1;  // it cannot go on
  EXPECT_EQ(one.decide().holder, 1);
  EXPECT_FALSE(one.robot.token(0)->kept);
  one.now = refused + one.settings.rest - 0.1;
  EXPECT_EQ(one.decide().holder, 1);
  one.now = refused + one.settings.rest + 0.1;
  EXPECT_EQ(one.decide().holder, 2);
}

}  // namespace
