// SPDX-License-Identifier: MIT
#include "config/rules.hpp"

#include "config/documents.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

Rules for_game(double seconds, ShortGames short_games = ShortGames::share, bool begins_in_play = true) {
  Rules rules;
  rules.messages.short_games = short_games;
  fit_packets(rules, seconds, begins_in_play);
  return rules;
}

TEST(PacketShare, IsThatOfTheLength) {
  EXPECT_EQ(packets(for_game(30.0).messages), 30);  // of 1200 in 1200 s
  EXPECT_EQ(packets(for_game(12.34).messages), 12);
  EXPECT_EQ(packets(for_game(0.5).messages), 0);
  EXPECT_EQ(packets(for_game(600.0).messages), 600);
  for (const double as_long : {1200.0, 1302.0, 1e6}) EXPECT_EQ(packets(for_game(as_long).messages), 1200);
  Rules small;
  small.messages.short_games = ShortGames::share;
  small.durations.halves = 1;
  small.messages.budget = 100;
  small.messages.share = packet_share(small, 60.0);
  EXPECT_EQ(packets(small.messages), 10);
  EXPECT_EQ(packet_share(small, std::nullopt), 1.0);
}

// A whole number of packets is one, though its share may round to a little less.
TEST(PacketShare, RoundingTakesNoPacketAway) {
  for (int seconds = 1; seconds < 1200; ++seconds) {
    EXPECT_EQ(packets(for_game(seconds).messages), seconds);
    Rules other;
    other.messages.short_games = ShortGames::share;
    other.messages.budget = 700;
    other.messages.share = packet_share(other, seconds);
    EXPECT_EQ(packets(other.messages), 700 * seconds / 1200);
  }
}

TEST(PacketShare, IsTheWholeUnlessAskedFor) {
  EXPECT_EQ(read_document<Rules>(project / "configs/rules/spl2023.yaml").messages.short_games, ShortGames::whole);
  const Rules rules = for_game(30.0, ShortGames::whole);
  EXPECT_EQ(rules.messages.share, 1.0);
  EXPECT_EQ(packets(rules.messages), 1200);
  EXPECT_EQ(packet_time_left(rules, 1250.0), 1250.0);
}

// Two halves of 600 s, and 50 s of Ready and Set before each.
TEST(PacketLine, IsEvenOverTheTimeInWhichATeamMaySend) {
  const Rules rules;
  EXPECT_EQ(sending_time(rules.durations), 1300.0);
  EXPECT_EQ(packet_line(rules, 1300.0), 1200.0);
  EXPECT_EQ(packet_line(rules, 650.0), 600.0);
  EXPECT_EQ(packet_line(rules, 0.0), 0.0);
  EXPECT_EQ(packet_line(rules, -0.1), 0.0);
  for (double left = 1300.0; left >= 1.0; left -= 0.5) {
    EXPECT_NEAR(packet_line(rules, left) - packet_line(rules, left - 1.0), 1200.0 / 1300.0, 1e-9);
  }
}

TEST(PacketLine, PhasesThatAreMissingTakeNoTime) {
  Rules rules;
  rules.durations.ready = rules.durations.set = 0.0;
  EXPECT_EQ(sending_time(rules.durations), 1200.0);
  for (double left = 0.0; left <= 1200.0; left += 0.5) EXPECT_EQ(packet_line(rules, left), left);
  rules.durations.halves = 1;
  rules.durations.set = 5.0;
  EXPECT_EQ(sending_time(rules.durations), 605.0);
  EXPECT_EQ(packet_line(rules, 605.0), 1200.0);
}

TEST(PacketLine, OfTheHumanoidLeagueIsTenTimesAsHigh) {
  const Rules rules = read_document<Rules>(project / "configs/rules/hsl2026.yaml");
  EXPECT_EQ(packet_line(rules, 1300.0), 12000.0);
  EXPECT_EQ(packet_line(rules, 650.0), 6000.0);
  EXPECT_EQ(packet_line(rules, 0.0), 0.0);
}

// A game from an opening has no Ready and Set before its first half. Its budget is spent by its end, not before.
TEST(PacketLine, OfAGameThatBeginsInPlay) {
  Rules rules;
  fit_packets(rules, std::nullopt, true);
  EXPECT_EQ(packet_line(rules, 1250.0), 1200.0);
  EXPECT_EQ(packet_line(rules, 0.0), 0.0);

  const Rules share = for_game(30.0);
  for (double clock = 0.0; clock <= 30.0; clock += 0.1) {
    EXPECT_NEAR(packet_line(share, 1250.0 - clock), 30.0 - clock, 1e-9);
    EXPECT_NEAR(packet_time_left(share, 1250.0 - clock), 30.0 - clock, 1e-9);
  }
  EXPECT_EQ(packet_line(share, 1150.0), 0.0);  // the clock went on: nothing is left to spend
  EXPECT_EQ(packet_time_left(share, 1150.0), 0.0);
}

// A limit counts from the beginning of Initial, in which nobody may send.
TEST(PacketLine, OfALimitedGameFromTheKickOff) {
  const Rules share = for_game(61.0, ShortGames::share, false);
  EXPECT_EQ(packets(share.messages), 61);
  EXPECT_NEAR(packet_line(share, 1300.0), 61.0, 1e-9);
  EXPECT_NEAR(packet_line(share, 1270.0), 30.5, 1e-9);
  EXPECT_NEAR(packet_line(share, 1240.0), 0.0, 1e-9);
  EXPECT_EQ(packet_line(for_game(61.0, ShortGames::whole, false), 1300.0), 1200.0);

  // Into the second half, whose Initial does not count either; over the end; less than the first Initial.
  EXPECT_NEAR(packet_time_left(for_game(702.0, ShortGames::share, false), 1300.0), 700.0, 1e-9);
  EXPECT_NEAR(packet_line(for_game(1302.0, ShortGames::share, false), 1300.0), 1200.0, 1e-9);
  EXPECT_NEAR(packet_line(for_game(1e6, ShortGames::share, false), 0.0), 0.0, 1e-9);
  EXPECT_EQ(packet_line(for_game(0.5, ShortGames::share, false), 1300.0), 0.0);
}

TEST(PacketShare, IsPartOfTheDocument) {
  EXPECT_EQ(
      read_document<Rules>(override_with(load(project / "configs/rules/spl2023.yaml"), {"messages.short_games=share"}))
          .messages.short_games,
      ShortGames::share);
  EXPECT_NE(schema(DocumentKind::rules).find("short_games"), std::string::npos);
}

}  // namespace
}  // namespace regista::config
