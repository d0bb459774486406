// SPDX-License-Identifier: MIT
// Tokens as bytes: they come back as they were, and any other bytes are ignored or do no lasting harm.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include "message.hpp"
#include "test_team.hpp"

namespace {

using namespace token_passing;

Told random_told(const Layout& layout, int sender, int id, std::mt19937& random) {
  const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
  Told out;
  out.id = id;
  out.token.generation = static_cast<std::uint8_t>(random());
  out.token.hop = static_cast<std::uint8_t>(random());
  out.token.creator = static_cast<std::uint8_t>(1 + below(layout.team_size));
  out.token.round = static_cast<std::uint8_t>(below(layout.rounds + 1));
  out.token.visited = static_cast<Robots>(random()) & ((Robots{1} << layout.team_size) - 1);
  const int state = below(3);
  out.token.kept = state == 1;
  out.token.done = state == 2;
  out.token.holder = static_cast<std::uint8_t>(state == 0 ? 1 + below(layout.team_size) : sender);
  return out;
}

std::vector<Told> random_message(const Layout& layout, int sender, std::mt19937& random) {
  std::vector<int> ids(static_cast<std::size_t>(layout.tokens));
  std::iota(ids.begin(), ids.end(), 0);
  std::shuffle(ids.begin(), ids.end(), random);
  ids.resize(1 + random() % ids.size());
  std::vector<Told> out;
  for (const int id : ids) out.push_back(random_told(layout, sender, id, random));
  return out;
}

TEST(TokenMessage, ComesBackAsItWas) {
  std::mt19937 random(1);
  std::vector<std::uint8_t> bytes;
  std::vector<Told> read_back;
  int understood = 0, ignored = 0;  // of messages that were cut off
  for (int round = 0; round < 5000; ++round) {
    const Layout layout{static_cast<int>(1 + random() % 22), static_cast<int>(1 + random() % 64),
                        static_cast<int>(random() % 51)};
    const int sender = 1 + static_cast<int>(random() % static_cast<unsigned>(layout.team_size));
    const std::vector<Told> told = random_message(layout, sender, random);
    write(layout, told, bytes);
    ASSERT_EQ(bytes.size(), layout.bytes(told.size()));
    ASSERT_EQ(layout.most(bytes.size()), told.size());
    ASSERT_TRUE(read(layout, sender, bytes, read_back));
    ASSERT_EQ(read_back.size(), told.size());
    for (std::size_t i = 0; i < told.size(); ++i) {
      ASSERT_EQ(read_back[i].id, told[i].id);
      ASSERT_EQ(read_back[i].token, told[i].token);
    }
    bytes.resize(random() % bytes.size());
    if (read(layout, sender, bytes, read_back)) {  // some were cut off, and the rest stands by itself
      ++understood;
      ASSERT_LE(read_back.size(), told.size());
      for (std::size_t i = 0; i < read_back.size(); ++i) {
        ASSERT_EQ(read_back[i].id, told[i].id);
        ASSERT_EQ(read_back[i].token, told[i].token);
      }
    } else {
      ++ignored;
      ASSERT_TRUE(read_back.empty());
    }
    write(layout, told, bytes);
    bytes.insert(bytes.end(), {0, 0, 0, 0});
    if (layout.most(bytes.size()) == told.size()) {
      ASSERT_FALSE(read(layout, sender, bytes, read_back));
    }
  }
  EXPECT_GT(understood, 100);
  EXPECT_GT(ignored, 1000);
}

TEST(TokenMessage, FiveBytesATokenOrSix) {
  EXPECT_EQ((Layout{7, 19, 7}.told_bits()), 39u);
  EXPECT_EQ((Layout{7, 19, 7}.bytes(7)), 35u);
  EXPECT_EQ((Layout{11, 19, 7}.bytes(11)), 62u);
}

TEST(TokenMessage, NonsenseIsNotRead) {
  const Layout layout{5, 10, 7};
  std::vector<std::uint8_t> bytes;
  std::vector<Told> out;
  const auto is_read = [&](std::vector<Told> told, int sender) {
    write(layout, told, bytes);
    return read(layout, sender, bytes, out);
  };
  Told good;
  good.id = 9;
  good.token = {.generation = 1, .creator = 1, .holder = 2, .round = 7, .kept = true};
  EXPECT_TRUE(is_read({good}, 2));
  EXPECT_FALSE(is_read({good}, 3)) << "only the holder can say that it does the task";
  EXPECT_TRUE(is_read({good}, 0)) << "for people";
  EXPECT_FALSE(is_read({good, good}, 2)) << "twice";
  const auto change = [&](auto&& what) {
    Told bad = good;
    what(bad);
    return is_read({bad}, 2);
  };
  EXPECT_FALSE(change([](Told& bad) { bad.id = 10; }));
  EXPECT_FALSE(change([](Told& bad) { bad.token.creator = 6; }));
  EXPECT_FALSE(change([](Told& bad) { bad.token.done = true; }));
  EXPECT_FALSE(change([](Told& bad) { bad.token.holder = 6, bad.token.kept = false; }));
  EXPECT_FALSE(read(layout, 2, {}, out));
  EXPECT_TRUE(out.empty());
}

// Random bytes, and messages with bits turned over, are heard by all from everybody; afterwards the team finds to one
// holder for each token again.
TEST(TokenMessage, ATeamRecoversFromAnyBytes) {
  std::mt19937 random(2);
  int understood = 0;
  for (int round = 0; round < 100; ++round) {
    const int robots = 3 + static_cast<int>(random() % 9);
    Settings settings;
    settings.silence = 4.0;
    settings.patience = 2.0;
    Team team(robots, robots, settings, static_cast<std::uint32_t>(round));
    for (int id = 0; id < robots; ++id) {
      team.tasks.ids.push_back(id);
      team.tasks.importance.push_back(id);
      auto& row = team.tasks.capability.emplace_back();
      for (int number = 1; number <= robots; ++number) row.push_back(static_cast<std::int32_t>(random() % 1001));
    }
    team.play(2.0);
    const Layout layout{robots, robots, settings.rounds()};
    std::vector<std::uint8_t> bytes;
    std::vector<Told> told;
    for (int number = 1; number <= robots; ++number) {
      const int sender = number % robots + 1;
      write(layout, random_message(layout, sender, random), bytes);
      if (random() % 2 == 0) bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1u << random() % 8);
      if (random() % 4 == 0) std::ranges::generate(bytes, [&] { return static_cast<std::uint8_t>(random()); });
      if (!read(layout, sender, bytes, told)) continue;
      ++understood;
      team.robot(number).hear(number, sender, told, team.now - 0.01, team.now, false);
    }
    team.play(25.0);
    bool one_each = true;
    for (int id = 0; id < robots; ++id) one_each &= team.holders(id).size() == 1;
    ASSERT_TRUE(one_each) << "team " << round;
  }
  EXPECT_GT(understood, 200);
}

}  // namespace
