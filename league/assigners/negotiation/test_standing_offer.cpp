// SPDX-License-Identifier: MIT
// The standing offer against a host: one offer waits at a time, in its newest form, until it has left or lapsed.
#include "standing_offer.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <vector>

#include <regista/testkit/recording_host.hpp>

namespace {

using negotiation::StandingOffer;
using regista::testkit::RecordingHost;
using Bytes = std::vector<std::uint8_t>;

struct Standing {
  RecordingHost host{8};
  StandingOffer offer;
  Standing() { offer.setup(regista::Mailbox(host.raw()), 8); }
  const RecordingHost::Offered& last() const { return host.offers.back(); }
  std::size_t waiting() const {
    std::size_t count = 0;
    for (const auto& each : host.offers) count += each.waits() ? 1 : 0;
    return count;
  }
};

TEST(StandingOffer, IsOfferedOnceWhileNothingChanges) {
  Standing one;
  for (const double now : {1.0, 1.1, 9.0}) one.offer.say(Bytes{1, 2}, now);
  ASSERT_EQ(one.host.offers.size(), 1u);
  EXPECT_EQ(one.last().bytes, (Bytes{1, 2}));
  EXPECT_EQ(one.last().urgency, 0.0);
  EXPECT_EQ(one.last().expiry, 11.0);
  EXPECT_EQ(one.last().replaces, 0u);
}

TEST(StandingOffer, TheNewestReplacesWhatWaits) {
  Standing one;
  Bytes newest;
  for (std::uint8_t k = 0; k < 20; ++k) {
    newest = Bytes(k % 8, k);
    one.offer.say(newest, 0.1 * k);
    EXPECT_EQ(one.waiting(), 1u);
    EXPECT_EQ(one.last().bytes, newest);
  }
  EXPECT_EQ(one.host.offers.size(), 20u);
  EXPECT_EQ(Bytes(one.offer.said().begin(), one.offer.said().end()), newest);
}

TEST(StandingOffer, AnotherUrgencyIsAnotherOfferOfTheSameBytes) {
  Standing one;
  one.offer.say(Bytes{1}, 1.0);
  one.offer.say(Bytes{1}, 1.1, 1.0);
  one.offer.say(Bytes{1}, 1.2, 1.0);
  ASSERT_EQ(one.host.offers.size(), 2u);
  EXPECT_EQ(one.last().urgency, 1.0);
  EXPECT_EQ(one.last().replaces, one.host.offers[0].handle);
  one.offer.say(Bytes{1}, 1.3);
  EXPECT_EQ(one.host.offers.size(), 3u);
  EXPECT_EQ(one.last().urgency, 0.0);
}

TEST(StandingOffer, GoesAlongWithTheNextPacketToo) {
  Standing one;
  one.offer.say(Bytes{1}, 1.0);
  EXPECT_TRUE(one.offer.gone(one.last().handle));
  EXPECT_FALSE(one.offer.gone(one.last().handle));  // it is gone already
  one.offer.say(Bytes{1}, 1.1);
  ASSERT_EQ(one.host.offers.size(), 2u);
  EXPECT_EQ(one.last().replaces, 0u);
  EXPECT_EQ(one.last().bytes, (Bytes{1}));
}

// The host drops what has waited for ten seconds, and says so before the next decision.
TEST(StandingOffer, WhatLapsedIsOfferedAgain) {
  Standing one;
  one.offer.say(Bytes{1}, 1.0);
  one.host.set_time(11.0);
  EXPECT_TRUE(one.offer.gone(one.last().handle));
  one.offer.say(Bytes{1}, 11.0);
  ASSERT_EQ(one.host.offers.size(), 2u);
  EXPECT_EQ(one.host.refused, 0u);
  EXPECT_EQ(one.last().expiry, 21.0);
}

// The host tells of a replaced offer only after the call that replaced it.
TEST(StandingOffer, NewsOfTheReplacedOneDoNotEndTheNewOne) {
  Standing one;
  one.offer.say(Bytes{1}, 1.0);
  const std::uint64_t replaced = one.last().handle;
  one.offer.say(Bytes{2}, 1.1);
  EXPECT_FALSE(one.offer.gone(replaced));
  one.offer.say(Bytes{2}, 1.2);
  EXPECT_EQ(one.host.offers.size(), 2u);  // it still waits
  EXPECT_TRUE(one.offer.gone(one.last().handle));
}

TEST(StandingOffer, WhatTheHostRefusesIsTriedAgainAndIsNeverGone) {
  Standing one;
  const Bytes too_long(9, 1);
  one.offer.say(too_long, 1.0);
  one.offer.say(too_long, 1.1);
  EXPECT_EQ(one.host.refused, 2u);
  EXPECT_TRUE(one.host.offers.empty());
  EXPECT_FALSE(one.offer.gone(0));
  one.offer.withdraw();
  one.offer.say(Bytes(8, 1), 1.2);
  EXPECT_EQ(one.waiting(), 1u);
}

TEST(StandingOffer, IsWithdrawnAndForgotten) {
  Standing one;
  one.offer.withdraw();  // nothing is there
  one.offer.say(Bytes{1}, 1.0);
  one.offer.withdraw();
  EXPECT_EQ(one.waiting(), 0u);
  EXPECT_FALSE(one.offer.gone(one.last().handle));
  one.offer.say(Bytes{1}, 1.1);
  EXPECT_EQ(one.waiting(), 1u);
  const std::uint64_t of_last_match = one.last().handle;
  one.offer.forget();
  EXPECT_TRUE(one.offer.said().empty());
  one.offer.say(Bytes{1}, 0.0);
  EXPECT_EQ(one.last().replaces, 0u);
  EXPECT_FALSE(one.offer.gone(of_last_match));
}

}  // namespace
