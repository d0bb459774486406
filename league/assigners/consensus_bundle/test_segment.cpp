// SPDX-License-Identifier: MIT
// Segments: what is written is read, ages are exact, and a stranger's bytes are refused.
#include <gtest/gtest.h>

#include <vector>

#include "segment.hpp"
#include "test_problems.hpp"

namespace {

using namespace consensus_bundle;
using namespace consensus_bundle::test;

struct Said {
  std::vector<Claim> claims;
  std::vector<std::int64_t> stamps;
};

Said random_said(Random& random, std::size_t robots, std::size_t tasks, std::int64_t now) {
  Said out;
  for (std::size_t task = 0; task < tasks; ++task) {
    const int winner = static_cast<int>(below(random, robots + 1));
    const auto bid = static_cast<std::uint32_t>(1 + below(random, Segment::most_bid));
    out.claims.push_back(winner == nobody ? Claim{} : Claim{winner, bid});
  }
  for (std::size_t k = 0; k < robots; ++k) {
    out.stamps.push_back(below(random, 5) == 0 ? never : now - static_cast<std::int64_t>(below(random, 400)));
  }
  return out;
}

TEST(Segments, SayWhatIsWritten) {
  Random random(31);
  for (int round = 0; round < 3000; ++round) {
    const std::size_t robots = 1 + below(random, 22), tasks = below(random, 65);
    Segment segment;
    segment.setup(robots, tasks);
    const auto now = static_cast<std::int64_t>(below(random, 20000));
    const int own = 1 + static_cast<int>(below(random, robots));
    const Said said = random_said(random, robots, tasks, now);
    std::vector<std::uint8_t> bytes;
    segment.write(77, own, now, said.claims, said.stamps, bytes);
    const auto won = tasks - static_cast<std::size_t>(std::ranges::count(said.claims, nobody, &Claim::winner));
    ASSERT_EQ(bytes.size(), segment.bytes(won));
    const auto waited = static_cast<std::int64_t>(below(random, 100));  // from writing to sending
    Told told;
    std::uint8_t epoch = 0;
    ASSERT_TRUE(segment.read(bytes, own, now + waited, epoch, told));
    EXPECT_EQ(epoch, 77);
    EXPECT_EQ(told.sender, own);
    EXPECT_EQ(told.sent, now);
    EXPECT_EQ(told.claims, said.claims);
    for (std::size_t k = 0; k < robots; ++k) {
      const bool is_own = static_cast<int>(k) + 1 == own;
      const bool old = said.stamps[k] == never || now - said.stamps[k] > 254;
      ASSERT_EQ(told.stamps[k], is_own ? now : old ? never : said.stamps[k]);
    }
  }
}

TEST(Segments, SizesAsTheHeadOfTheFileSays) {
  Segment segment;
  segment.setup(7, 19);
  EXPECT_EQ(segment.bytes(7), 25u);
  segment.setup(15, 10);
  EXPECT_EQ(segment.bytes(10), 38u);
  segment.setup(16, 10);
  EXPECT_EQ(segment.bytes(10), 40u);  // one more age, and one more bit for each winner
}

TEST(Segments, OtherLengthsAndImpossibleClaimsAreRefused) {
  Random random(32);
  Segment segment;
  segment.setup(5, 9);
  const Said said = random_said(random, 5, 9, 1000);
  std::vector<std::uint8_t> bytes;
  segment.write(1, 2, 1000, said.claims, said.stamps, bytes);
  Told told;
  std::uint8_t epoch = 0;
  ASSERT_TRUE(segment.read(bytes, 2, 1000, epoch, told));
  EXPECT_FALSE(segment.read(bytes, 0, 1000, epoch, told));
  EXPECT_FALSE(segment.read(bytes, 6, 1000, epoch, told));
  EXPECT_FALSE(segment.read(std::span(bytes).first(bytes.size() - 1), 2, 1000, epoch, told));
  bytes.push_back(0);
  EXPECT_FALSE(segment.read(bytes, 2, 1000, epoch, told));
  for (const Claim& wrong : {Claim{6, 10}, Claim{3, 0}}) {
    segment.write(1, 2, 1000, std::vector<Claim>(9, wrong), said.stamps, bytes);
    EXPECT_FALSE(segment.read(bytes, 2, 1000, epoch, told));
  }
  int read = 0;
  for (int round = 0; round < 20000; ++round) {
    segment.write(1, 2, 1000, said.claims, said.stamps, bytes);
    for (std::size_t wrong = below(random, 4); wrong > 0; --wrong) {
      bytes[below(random, bytes.size())] ^= static_cast<std::uint8_t>(1u << below(random, 8));
    }
    if (round % 2 == 0) bytes.resize(below(random, 40));
    if (!segment.read(bytes, 1 + static_cast<int>(below(random, 5)), 300, epoch, told)) continue;
    ++read;
    ASSERT_GT(told.sent, 300 - 256);
    ASSERT_LE(told.sent, 300);
    for (const std::int64_t stamp : told.stamps) ASSERT_TRUE(stamp == never || stamp <= told.sent);
    for (const Claim& claim : told.claims) {
      ASSERT_TRUE(claim == Claim{} || (claim.winner >= 1 && claim.winner <= 5 && claim.bid > 0));
    }
  }
  EXPECT_GT(read, 1000);
  EXPECT_LT(read, 15000);
}

}  // namespace
