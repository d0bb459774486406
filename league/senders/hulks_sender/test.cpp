// SPDX-License-Identifier: MIT
// The rules against a clock, and what one striker spends in a whole match.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include <regista/sender.hpp>
#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using hulks_sender::Cause, hulks_sender::Sender, hulks_sender::Settings, hulks_sender::Situation;

struct Packet {
  double time;
  Cause cause;
};

// One robot that decides ten times a second; `at` changes the situation.
std::vector<Packet> run(double length, const std::function<void(int tick, Situation&)>& at, int number = 3,
                        const Settings& settings = {}) {
  Sender sender;
  std::vector<Packet> packets;
  double last = 0.0;
  for (int tick = 0; tick < static_cast<int>(length * 10.0); ++tick) {
    Situation now;
    now.time = 0.1 * tick;
    now.number = number;
    now.team_size = 7;
    now.playing = true;
    now.since_own = now.time - last;
    at(tick, now);
    if (const auto cause = sender.decide(settings, now)) {
      packets.push_back({now.time, *cause});
      last = now.time;
    }
  }
  return packets;
}

TEST(HulksSender, OneStrikerSpendsAtMost600PacketsInAMatchAndOthersNone) {
  const auto packets = run(1200.0, [](int, Situation& now) { now.is_striker = true; });
  EXPECT_LE(packets.size(), 600u);
  EXPECT_GE(packets.size(), 598u);
  for (std::size_t k = 0; k < packets.size(); ++k) {
    EXPECT_EQ(packets[k].cause, Cause::resend);
    if (k > 0) {
      EXPECT_NEAR(packets[k].time - packets[k - 1].time, 2.0, 1e-6);
    }
  }
  EXPECT_TRUE(run(1200.0, [](int, Situation&) {}).empty());
}

TEST(HulksSender, NewsGoAtOnceButNoTwoWithinTheGap) {
  const auto packets = run(10.0, [](int tick, Situation& now) { now.has_news = tick >= 50; });
  ASSERT_EQ(packets.size(), 5u);
  for (std::size_t k = 0; k < packets.size(); ++k) {
    EXPECT_NEAR(packets[k].time, 5.0 + static_cast<double>(k), 1e-6);
    EXPECT_EQ(packets[k].cause, Cause::news);
  }
  EXPECT_EQ(run(10.0, [](int tick, Situation& now) { now.has_news = tick == 50 || tick == 55; }).size(), 1u);
}

TEST(HulksSender, SilentWithoutPackets) {
  EXPECT_TRUE(run(60.0, [](int tick, Situation& now) {
                now.has_packets = false;
                now.has_news = now.is_striker = true;
                now.playing = tick > 300;
                now.ready_or_set = tick <= 300;
              }).empty());
}

// Two times of Ready and Set of 50 s. Nobody claims there.
TEST(HulksSender, InReadyRobotsTellThatTheyPlay) {
  std::vector<double> all;
  for (int number = 1; number <= 7; ++number) {
    const auto packets = run(
        200.0,
        [](int tick, Situation& now) {
          now.ready_or_set = tick % 1000 < 500;
          now.playing = false;
          now.has_news = now.is_striker = true;
        },
        number);
    EXPECT_GE(packets.size(), 4u) << number;
    EXPECT_LE(packets.size(), 6u) << number;
    for (const Packet& packet : packets) {
      EXPECT_EQ(packet.cause, Cause::ready);
      EXPECT_LT(static_cast<int>(packet.time * 10.0 + 0.5) % 1000, 500);
      all.push_back(packet.time);
    }
  }
  std::sort(all.begin(), all.end());
  for (std::size_t k = 1; k < all.size(); ++k) EXPECT_GT(all[k] - all[k - 1], 2.0);
  Settings none;
  none.ready_period = 0.0;
  EXPECT_TRUE(run(
                  100.0,
                  [](int, Situation& now) {
                    now.playing = false;
                    now.ready_or_set = true;
                  },
                  3, none)
                  .empty());
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

struct Said {
  bool sends;
  int reason;
  std::size_t granted;
};

Said answer(double urgency, int left, double since_own, double share = 1.0, int phase = REGISTA_PHASE_PLAYING,
            std::uint32_t bytes_free = 60) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "hulks_sender");
  Instance sender(plugin, EnvironmentBuilder{}.own(3));
  regista_budget budget{};
  budget.size = sizeof budget;
  budget.packets_left = left;
  budget.since_own = since_own;
  budget.bytes_free = bytes_free;
  budget.share = share;
  const std::vector<regista_offer> offers{{11, 6, REGISTA_MEDIUM_RADIO, urgency, 99.0},
                                          {12, 20, REGISTA_MEDIUM_RADIO, 0.1, 99.0}};
  const Scene scene = FrameBuilder{}.own(3).time(50.0).robot(3).phase(phase).build();
  const Sent sent = sender.decide(scene, {}, offers, budget);
  return {sent.send == 1, sent.reason, sent.granted.size()};
}

TEST(HulksSenderPlugin, UrgencyTellsNewsFromTheStandingClaim) {
  EXPECT_TRUE(answer(1.0, 500, 1.0).sends);
  EXPECT_EQ(answer(1.0, 500, 1.0).reason, regista::own_reason(0));
  EXPECT_FALSE(answer(1.0, 500, 0.9).sends);
  EXPECT_TRUE(answer(0.5, 500, 2.0).sends);
  EXPECT_EQ(answer(0.5, 500, 2.0).reason, regista::own_reason(1));
  EXPECT_FALSE(answer(0.5, 500, 1.9).sends);
  EXPECT_FALSE(answer(0.4, 500, 100.0).sends);
  EXPECT_EQ(answer(1.0, 500, 1.0).granted, 2u);
  EXPECT_FALSE(answer(1.0, 500, 100.0, 1.0, REGISTA_PHASE_FINISHED).sends);
  EXPECT_FALSE(answer(1.0, 500, 100.0, 1.0, REGISTA_PHASE_PLAYING, 5).sends);  // nothing that fits
}

TEST(HulksSenderPlugin, SilentAtTwentyOfAWholeMatch) {
  EXPECT_FALSE(answer(1.0, 20, 100.0).sends);
  EXPECT_TRUE(answer(1.0, 21, 100.0).sends);
  EXPECT_FALSE(answer(1.0, 2, 100.0, 0.1).sends);
  EXPECT_TRUE(answer(1.0, 3, 100.0, 0.1).sends);
}

REGISTA_SENDER_CONTRACT(REGISTA_PLUGIN_FILE, "hulks_sender");

}  // namespace
