// SPDX-License-Identifier: MIT
#include "config/packet_share.hpp"

#include <cstring>
#include <random>

#include "config/documents.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

Rules for_game(double seconds, ShortGames short_games = ShortGames::share) {
  Rules rules;
  rules.messages.short_games = short_games;
  rules.messages.share = packet_share(rules, seconds);
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
  EXPECT_EQ(read_rules(project / "configs/rules/spl2023.yaml").messages.short_games, ShortGames::whole);
  const Rules rules = for_game(30.0, ShortGames::whole);
  EXPECT_EQ(rules.messages.share, 1.0);
  EXPECT_EQ(packets(rules.messages), 1200);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> left(-1.0, 1200.0);
  for (int i = 0; i < 1000; ++i) {
    const double now = left(random), line = packet_line(rules, now), until_0_5 = 1200 * now / (600.0 * 2);
    EXPECT_EQ(std::memcmp(&line, &until_0_5, sizeof line), 0) << "to the last bit";
    EXPECT_EQ(packet_time_left(rules, now), now);
  }
}

// In a game of 30 s everything is as in the first 30 s of a match, less the packets of all that is not played.
TEST(PacketShare, LineFallsAsInAWholeMatch) {
  const Rules whole, share = for_game(30.0);
  for (double clock = 0.0; clock <= 30.0; clock += 0.1) {
    const double left = 1200.0 - clock;
    EXPECT_NEAR(packet_line(share, left), packet_line(whole, left) - 1170.0, 1e-9);
    EXPECT_NEAR(packet_time_left(share, left), 30.0 - clock, 1e-9);
  }
  EXPECT_EQ(packet_line(share, 1100.0), 0.0);  // the clock went on: nothing is left to spend
  EXPECT_EQ(packet_time_left(share, 1100.0), 0.0);
}

TEST(PacketShare, IsPartOfTheDocument) {
  EXPECT_EQ(read_rules(override_with(load(project / "configs/rules/spl2023.yaml"), {"messages.short_games=share"}))
                .messages.short_games,
            ShortGames::share);
  EXPECT_NE(schema(DocumentKind::rules).find("short_games"), std::string::npos);
}

}  // namespace
}  // namespace regista::config
