// SPDX-License-Identifier: MIT
// The air: bounds of delay, order, loss, and bytes that arrive as they were sent.
#include "match/radio.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "match/physics_world.hpp"

namespace regista::match {
namespace {

using Bytes = std::vector<std::uint8_t>;

Disturbances none(int team_size) {
  static const config::Disturbance disturbance;
  return Disturbances(disturbance, {}, team_size, 1, Side::home);
}

TEST(Radio, DelaysWithinItsBoundsAndSparesTheSender) {
  const config::Radio profile{0.05, 0.1, 0.0};
  const Disturbances trouble = none(5);
  Radio radio(profile, trouble, 5, 1, Side::home);
  std::vector<mind::HeardPacket> heard;
  double least = 1.0, largest = 0.0;
  int count = 0;
  for (std::uint32_t tick = 0; tick < 20000; ++tick) {
    const double time = tick * physics_step;
    if (tick % 10 == 0) radio.send(2, Bytes(8, static_cast<std::uint8_t>(tick / 10)), time, tick);
    for (int receiver = 1; receiver <= 5; ++receiver) {
      heard.clear();
      radio.deliver(receiver, time, tick, heard);
      if (receiver == 2) {
        ASSERT_TRUE(heard.empty());
      }
      for (const auto& packet : heard) {
        ASSERT_LE(packet.time_heard, time);
        ASSERT_GT(packet.time_heard, time - physics_step - 1e-9) << "delivered as soon as it is heard";
        const double sent = std::floor((packet.time_heard - 0.05) / 0.2 + 1e-9) * 0.2;
        ASSERT_EQ(packet.bytes.size(), 8u);
        ASSERT_EQ(packet.bytes[0], static_cast<std::uint8_t>(std::lround(sent / 0.2)));
        least = std::fmin(least, packet.time_heard - sent);
        largest = std::fmax(largest, packet.time_heard - sent);
        ++count;
      }
    }
  }
  EXPECT_NEAR(count, 2000 * 4, 4);
  EXPECT_GE(least, 0.05 - 1e-9);
  EXPECT_LT(least, 0.051);
  EXPECT_LT(largest, 0.15);
  EXPECT_GT(largest, 0.149);
}

TEST(Radio, LosesByBothCauses) {
  config::Disturbance disturbance;
  disturbance.radio.loss = 0.5;
  disturbance.radio.delay = 0.2;
  const Disturbances trouble(disturbance, {}, 3, 1, Side::away);
  Radio radio({0.05, 0.0, 0.2}, trouble, 3, 1, Side::away);
  std::vector<mind::HeardPacket> heard;
  int first = 0, both = 0;
  constexpr int packets = 20000;
  for (int i = 0; i < packets; ++i) {
    const auto tick = static_cast<std::uint32_t>(100 * i);
    radio.send(1, Bytes{1}, tick * physics_step, tick);
    heard.clear();
    radio.deliver(2, tick * physics_step + 0.24, tick + 12, heard);
    ASSERT_TRUE(heard.empty()) << "the disturbance delays";
    radio.deliver(2, tick * physics_step + 0.26, tick + 13, heard);
    const bool second_heard = !heard.empty();
    first += second_heard ? 1 : 0;
    heard.clear();
    radio.deliver(3, tick * physics_step + 0.26, tick + 13, heard);
    both += second_heard && !heard.empty() ? 1 : 0;
  }
  EXPECT_NEAR(first / double(packets), 0.4, 0.015);  // 0.8 * 0.5
  EXPECT_NEAR(both / double(packets), 0.16, 0.012);  // per receiver, independently
}

// Whether it sends or receives: a slow radio is slow both ways.
TEST(Radio, ARobotsOwnDelayIsOfWhatItSendsAndOfWhatItHears) {
  config::Disturbance disturbance;
  config::Incident& slow = disturbance.incidents.emplace_back();
  slow.kind = config::Incident::Kind::radio_delay;
  slow.robots = {config::Incident::Whom::Choice::listed, {2}};
  slow.at = {0.0};
  slow.delay = 0.5;
  Disturbances trouble(disturbance, {}, 3, 1, Side::home);
  trouble.update(0.0);
  const auto heard_after = [&](int sender, int receiver) {
    Radio radio({0.1, 0.0, 0.0}, trouble, 3, 1, Side::home);
    radio.send(sender, Bytes{1}, 0.0, 0);
    std::vector<mind::HeardPacket> heard;
    radio.deliver(receiver, 2.0, 100, heard);
    return heard.size() == 1 ? heard.front().time_heard : -1.0;
  };
  EXPECT_DOUBLE_EQ(heard_after(1, 3), 0.1);
  EXPECT_DOUBLE_EQ(heard_after(1, 2), 0.6);
  EXPECT_DOUBLE_EQ(heard_after(2, 1), 0.6);
}

TEST(Radio, OrdersByTimeHeardThenSender) {
  const Disturbances trouble = none(4);
  Radio radio({0.1, 0.0, 0.0}, trouble, 4, 1, Side::home);
  radio.send(4, Bytes{4}, 0.0, 0);
  radio.send(2, Bytes{2}, 0.0, 0);
  radio.send(3, Bytes{3}, 0.02, 1);
  radio.send(1, Bytes{1}, 0.0, 0);
  std::vector<mind::HeardPacket> heard;
  radio.deliver(4, 1.0, 50, heard);
  ASSERT_EQ(heard.size(), 3u);
  EXPECT_EQ(heard[0].bytes[0], 1);
  EXPECT_EQ(heard[1].bytes[0], 2);
  EXPECT_EQ(heard[2].bytes[0], 3);
  heard.clear();
  radio.deliver(4, 2.0, 100, heard);
  EXPECT_TRUE(heard.empty());
}

TEST(Radio, NothingIsHeardInTheTickOfSending) {
  const Disturbances trouble = none(2);
  Radio radio({0.0, 0.0, 0.0}, trouble, 2, 1, Side::home);
  radio.send(1, Bytes{1}, 0.0, 0);
  std::vector<mind::HeardPacket> heard;
  radio.deliver(2, 0.0, 0, heard);
  EXPECT_TRUE(heard.empty());
  radio.deliver(2, 0.02, 1, heard);
  EXPECT_EQ(heard.size(), 1u);
}

}  // namespace
}  // namespace regista::match
