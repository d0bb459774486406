// SPDX-License-Identifier: MIT
#include "plugin/kinds.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

class SenderTest : public PuppetTest {
 protected:
  // What ends a call in which the plugin decides this; else `decision` holds what it led to.
  std::string run(std::int32_t send, std::int32_t reason, std::vector<std::uint64_t> handles = {}) {
    wanted = {sizeof(regista_send), send, reason, static_cast<std::uint32_t>(handles.size()), nullptr};
    granted = std::move(handles);
    Puppet::sender.decide = [](void*, const regista_frame*, regista_span, regista_span on_offer, const regista_budget*,
                               regista_send* out, regista_error*) {
      EXPECT_EQ(out->granted_count, 0u);
      out->send = wanted.send;
      out->reason = wanted.reason;
      out->granted_count = wanted.granted_count;
      std::copy_n(granted.begin(), std::min<std::size_t>(granted.size(), on_offer.count), out->granted);
      return Puppet::ok;
    };
    const Scene scene;
    const regista_budget budget{};
    return message_of([&] {
      const SendDecision answer = sender.decide(scene.frame, {}, offers, budget);
      decision = {answer.send, answer.reason, {answer.granted.begin(), answer.granted.end()}};
    });
  }

  static inline regista_send wanted;
  static inline std::vector<std::uint64_t> granted;
  struct {
    bool send;
    int reason;
    std::vector<std::uint64_t> granted;
  } decision{};
  std::array<regista_offer, 3> offers{{{11, 8, 0, 0.5, 9.0}, {12, 8, 0, 0.5, 9.0}, {13, 8, 0, 0.5, 9.0}}};
  Sender sender{Puppet::instance()};
};

TEST_F(SenderTest, HandsBackWhatThePluginDecides) {
  EXPECT_EQ(run(1, REGISTA_EVENT_FELL, {13, 11}), "");
  EXPECT_TRUE(decision.send);
  EXPECT_EQ(decision.reason, REGISTA_EVENT_FELL);
  EXPECT_EQ(decision.granted, (std::vector<std::uint64_t>{13, 11}));
}

TEST_F(SenderTest, GrantsNothingWithoutAPacket) {
  EXPECT_EQ(run(0, 0, {13}), "");
  EXPECT_FALSE(decision.send);
  EXPECT_TRUE(decision.granted.empty());
}

TEST_F(SenderTest, RefusesWhatCannotBeDecided) {
  EXPECT_EQ(run(2, 0), Puppet::failure("decide: send is 2, neither 0 nor 1"));
  EXPECT_EQ(run(1, REGISTA_EVENT_COUNT), Puppet::failure("decide: reason 14 does not exist"));
  EXPECT_EQ(run(1, -1), Puppet::failure("decide: reason -1 does not exist"));
  EXPECT_EQ(run(1, 0, {11, 12, 13, 11}), Puppet::failure("decide: granted 4 offers of 3"));
  EXPECT_EQ(run(1, 0, {11, 99}), Puppet::failure("decide: granted handle 99, which is not on offer"));
  EXPECT_EQ(run(1, 0, {11, 12, 11}), Puppet::failure("decide: granted handle 11 twice"));
}

TEST_F(SenderTest, PassesEventsAndOffers) {
  static double sum;
  Puppet::sender.decide = [](void*, const regista_frame*, regista_span events, regista_span on_offer,
                             const regista_budget* budget, regista_send* out, regista_error*) {
    const auto* const bytes = static_cast<const char*>(events.data);
    for (std::uint32_t i = 0; i < events.count; ++i) {
      sum += reinterpret_cast<const regista_event*>(bytes + i * events.stride)->value;
    }
    out->send = on_offer.count == 3 && budget->packets_left == 70;
    return Puppet::ok;
  };
  const Scene scene;
  const std::array<regista_event, 2> events{{{REGISTA_EVENT_FELL, 0, 0.25}, {REGISTA_EVENT_GOT_UP, 0, 2.0}}};
  regista_budget budget{};
  budget.packets_left = 70;
  sum = 0.0;
  EXPECT_TRUE(sender.decide(scene.frame, events, offers, budget).send);
  EXPECT_EQ(sum, 2.25);
}

TEST_F(SenderTest, ReportsSharedObjectsByTheirFile) {
  const Scene scene;
  Sender throwing(instance_of(open("throws")));
  EXPECT_EQ(message_of([&] { throwing.decide(scene.frame, {}, {}, regista_budget{}); }),
            failure("throws", "decide: fell in decide"));
}

}  // namespace
}  // namespace regista::plugin::test
