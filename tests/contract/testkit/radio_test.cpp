// SPDX-License-Identifier: MIT
// The radio of rehearsals loses as many packets as it says, delays and reorders them, and delivers none twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <regista/testkit/radio.hpp>

namespace {

using regista::testkit::Packet;
using regista::testkit::Radio;

Packet packet(int sender, double time) { return {sender, time, {}, -1, 0.0}; }

// Times at which the packets of robot 1 were sent, in the order in which robot 2 got them; one packet a second.
std::vector<double> sent_and_heard(Radio& radio, int packets) {
  std::vector<double> out;
  for (int tick = 0; tick < 10 * packets + 100; ++tick) {
    if (tick % 10 == 0 && tick < 10 * packets) radio.send(packet(1, 0.1 * tick));
    for (const Packet& each : radio.arrived(2, 0.1 * tick)) out.push_back(each.time_sent);
  }
  return out;
}

TEST(Radio, LosesTheShareThatItSays) {
  constexpr int packets = 4000;
  for (const double loss : {0.0, 0.3, 0.6, 1.0}) {
    Radio radio(2, {.loss = loss}, 1);
    const double heard = static_cast<double>(sent_and_heard(radio, packets).size());
    const double deviation = std::sqrt(packets * loss * (1.0 - loss));
    EXPECT_NEAR(heard, packets * (1.0 - loss), 4.0 * deviation) << loss;
  }
}

TEST(Radio, DeliversEachPacketOnceAndSomeOutOfOrder) {
  Radio radio(2, {}, 2);
  std::vector<double> heard = sent_and_heard(radio, 1000);
  EXPECT_FALSE(std::ranges::is_sorted(heard));
  std::ranges::sort(heard);
  EXPECT_EQ(std::ranges::adjacent_find(heard), heard.end());
  EXPECT_EQ(heard.size(), 1000u);
}

TEST(Radio, NothingArrivesBeforeItWasSentNorLaterThanTheLongDelay) {
  Radio radio(2, {}, 3);
  for (int k = 0; k < 500; ++k) {
    const double sent = 10.0 * k;
    radio.send(packet(1, sent));
    EXPECT_TRUE(radio.arrived(2, sent - 1e-9).empty());
    EXPECT_EQ(radio.arrived(2, sent + 1.5).size(), 1u);
  }
}

TEST(Radio, NobodyHearsHimselfNorWhoIsOutOfRange) {
  Radio radio(3, {}, 4);
  radio.out_of_range(2);
  radio.send(packet(1, 0.0));
  radio.send(packet(2, 0.0));
  EXPECT_TRUE(radio.arrived(1, 9.0).empty());
  EXPECT_TRUE(radio.arrived(2, 9.0).empty());
  EXPECT_EQ(radio.arrived(3, 9.0).size(), 1u);
  radio.into_range(2);
  radio.send(packet(1, 10.0));
  EXPECT_EQ(radio.arrived(2, 19.0).size(), 1u);
}

TEST(Radio, WhoIsOutOfRangeDoesNotChangeTheLuckOfOthers) {
  Radio all(3, {.loss = 0.5}, 5), without(3, {.loss = 0.5}, 5);
  without.out_of_range(3);
  EXPECT_EQ(sent_and_heard(all, 300), sent_and_heard(without, 300));
}

}  // namespace
