// SPDX-License-Identifier: MIT
// The plugin event_based: what it makes of events, offers and the budget.
#include <gtest/gtest.h>

#include <vector>

#include <regista/sender.hpp>
#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

namespace {

using namespace regista::testkit;

regista_budget plenty() {
  regista_budget budget{};
  budget.size = sizeof budget;
  budget.packets_left = 1000;
  budget.line = 1000.0;
  budget.since_own = 1.0;
  budget.bytes_free = 60;
  return budget;
}

Scene at_five_seconds() { return FrameBuilder{}.own(3).time(5.0).robot(3).build(); }

TEST(EventBasedPlugin, EventsAreTheReasonsOfThePackets) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "event_based");
  const auto answer = [&](int kind, double value) {
    Instance sender(plugin, EnvironmentBuilder{}.own(3), Values(plugin).set("period", 120.0));
    const std::vector<regista_event> events{{kind, 0, value}};
    const Sent sent = sender.decide(at_five_seconds(), events, {}, plenty());
    return sent.send == 1 ? sent.reason : -1;
  };
  for (const int kind :
       {REGISTA_EVENT_WHISTLE, REGISTA_EVENT_BALL_FOUND, REGISTA_EVENT_ROLE_CHANGED, REGISTA_EVENT_RETURNED}) {
    EXPECT_EQ(answer(kind, 0.0), kind);
  }
  EXPECT_EQ(answer(REGISTA_EVENT_ROLE_CHANGED, -1.0), REGISTA_EVENT_ROLE_CHANGED);  // lost its role
  EXPECT_EQ(answer(REGISTA_EVENT_GOALKEEPER_SAW_BALL, 7.9), -1);
  EXPECT_EQ(answer(REGISTA_EVENT_GOALKEEPER_SAW_BALL, 8.0), REGISTA_EVENT_GOALKEEPER_SAW_BALL);
  EXPECT_EQ(answer(REGISTA_EVENT_BALL_KNOWN_AGAIN, 4.9), -1);
  EXPECT_EQ(answer(REGISTA_EVENT_BALL_KNOWN_AGAIN, 5.0), REGISTA_EVENT_BALL_KNOWN_AGAIN);
  EXPECT_EQ(answer(REGISTA_EVENT_BALL_MOVED, 0.9), -1);
  EXPECT_EQ(answer(REGISTA_EVENT_BALL_MOVED, 1.0), REGISTA_EVENT_BALL_MOVED);
  EXPECT_EQ(answer(REGISTA_EVENT_POSE_MOVED, 1.0), REGISTA_EVENT_POSE_MOVED);
  EXPECT_EQ(answer(REGISTA_EVENT_CONTEXT_CHANGED, 1.0), -1);
}

TEST(EventBasedPlugin, PeriodsAreLeftOutWhenAskedFor) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "event_based");
  const auto sends = [&](const Values& values) {
    Instance sender(plugin, EnvironmentBuilder{}.own(3), values);
    regista_budget budget = plenty();
    budget.since_own = 120.0;
    return sender.decide(FrameBuilder{}.own(3).time(120.0).robot(3).build(), {}, {}, budget).send == 1;
  };
  EXPECT_TRUE(sends(Values(plugin)));
  EXPECT_FALSE(sends(Values(plugin).set("periodic", false)));
}

// A change of role waits from 20 packets below the line on, which is that of the team's own budget.
TEST(EventBasedPlugin, PaceIsTowardsTheReserve) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "event_based");
  const auto tells_its_role = [&](unsigned packets, double line, int left) {
    Instance sender(plugin, EnvironmentBuilder{}.own(3).packets(128, packets), Values(plugin).set("reserve", 30));
    const std::vector<regista_event> events{{REGISTA_EVENT_ROLE_CHANGED, 0, 4.0}};
    regista_budget budget = plenty();
    budget.packets_left = left;
    budget.line = line;
    return sender.decide(at_five_seconds(), events, {}, budget).send == 1;
  };
  EXPECT_TRUE(tells_its_role(1200, 400.0, 400));  // 30 + 1170 / 3 - 20
  EXPECT_FALSE(tells_its_role(1200, 400.0, 399));
  EXPECT_TRUE(tells_its_role(600, 200.0, 200));  // 30 + 570 / 3 - 20
  EXPECT_FALSE(tells_its_role(600, 200.0, 199));
}

// In a tenth of a match a tenth of the reserve, and no fewer than one packet of it.
TEST(EventBasedPlugin, ReserveIsOfTheShareOfAMatch) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "event_based");
  const auto sends = [&](int left, double share) {
    Instance sender(plugin, EnvironmentBuilder{}.own(3), Values(plugin).set("reserve", 30).set("pace", "none"));
    const std::vector<regista_event> events{{REGISTA_EVENT_WHISTLE, 0, 0.0}};
    regista_budget budget = plenty();
    budget.packets_left = left;
    budget.share = share;
    return sender.decide(at_five_seconds(), events, {}, budget).send == 1;
  };
  for (const auto& [share, kept] : {std::pair{1.0, 30}, {0.1, 3}, {0.025, 1}, {0.05, 2}, {1e-6, 1}}) {
    EXPECT_FALSE(sends(kept, share)) << share;
    EXPECT_TRUE(sends(kept + 1, share)) << share;
  }
  // A host that knows of no share.
  regista_budget older = plenty();
  older.share = 0.1;
  EXPECT_EQ(regista::in_this_game(30, older), 3);
  older.size = offsetof(regista_budget, share);
  EXPECT_EQ(regista::in_this_game(30, older), 30);
}

// Off unless asked for; then each is sent at once, and again after its interval at the earliest.
TEST(EventBasedPlugin, FallsAndChangesAreToldWhenAskedFor) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "event_based");
  const auto packets = [&](const Values& values, int kind) {
    Instance sender(plugin, EnvironmentBuilder{}.own(3), values);
    const std::vector<regista_event> events{{kind, 0, 2.0}};
    regista_budget budget = plenty();
    std::vector<double> times;
    double last = 0.0;
    for (int tick = 50; tick < 150; ++tick) {
      budget.since_own = 0.1 * tick - last;
      const Sent sent = sender.decide(FrameBuilder{}.own(3).robot(3).time(0.1 * tick).build(), events, {}, budget);
      if (sent.send == 0) continue;
      EXPECT_EQ(sent.reason, kind);
      times.push_back(last = 0.1 * tick);
    }
    return times;
  };
  const std::vector<std::pair<std::string, int>> kinds{{"fell", REGISTA_EVENT_FELL},
                                                       {"got_up", REGISTA_EVENT_GOT_UP},
                                                       {"phase_changed", REGISTA_EVENT_PHASE_CHANGED},
                                                       {"context_changed", REGISTA_EVENT_CONTEXT_CHANGED}};
  for (const auto& [name, kind] : kinds) {
    const Values quiet = Values(plugin).set("period", 120.0).set(name + "_interval", 3.0);
    EXPECT_TRUE(packets(quiet, kind).empty()) << name;
    EXPECT_EQ(packets(Values(quiet).set(name, 1.0), kind).size(), 4u) << name;  // at 5, 8, 11 and 14 s
    for (const auto& [other, other_kind] : kinds) {
      if (other == name) continue;
      EXPECT_TRUE(packets(Values(quiet).set(name, 1.0), other_kind).empty()) << name << ' ' << other;
    }
  }
}

// A robot that fell changes the game for all; the rest waits while the team has spent more than its share.
TEST(EventBasedPlugin, UrgentOffersThatFitAreAReason) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "event_based");
  const auto answer = [&](double urgency, std::uint32_t bytes) {
    Instance sender(plugin, EnvironmentBuilder{}.own(3), Values(plugin).set("period", 120.0));
    const std::vector<regista_offer> offers{{7, 20, REGISTA_MEDIUM_RADIO, 0.5, 99.0},
                                            {8, bytes, REGISTA_MEDIUM_RADIO, urgency, 99.0}};
    return sender.decide(at_five_seconds(), {}, offers, plenty());
  };
  EXPECT_EQ(answer(0.99, 40).send, 0);
  EXPECT_EQ(answer(1.0, 61).send, 0);
  EXPECT_EQ(answer(1.0, 40).reason, REGISTA_EVENT_OFFER);
  EXPECT_EQ(answer(1.0, 40).granted, (std::vector<std::uint64_t>{8, 7}));
  EXPECT_EQ(answer(1.0, 41).granted, (std::vector<std::uint64_t>{8}));
}

TEST(EventBasedPlugin, ThePeriodFollowsThePhaseAndWhoSeesTheBall) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "event_based");
  // Time from the first packet to the second.
  const auto period = [&](const FrameBuilder& frame, int number) {
    Instance sender(plugin, EnvironmentBuilder{}.own(number));
    regista_budget budget = plenty();
    double first = -1.0, last = 0.0;
    for (int tick = 0; tick < 600; ++tick) {
      budget.since_own = 0.1 * tick - last;
      if (sender.decide(FrameBuilder(frame).own(number).time(0.1 * tick).build(), {}, {}, budget).send == 0) continue;
      last = 0.1 * tick;
      if (first >= 0.0) return last - first;
      first = last;
    }
    return -1.0;
  };
  const FrameBuilder nobody = FrameBuilder{}.robot(1).robot(3).no_ball();
  EXPECT_NEAR(period(nobody, 3), 10.0, 0.11);
  EXPECT_NEAR(period(nobody, 1), 20.0, 0.11);
  const FrameBuilder mine = FrameBuilder{}.robot(3).ball(1, 1).common([](WorldBuilder& world) { world.no_ball(); });
  EXPECT_NEAR(period(mine, 3), 4.0, 0.11);
  const FrameBuilder ours = FrameBuilder{}.robot(3).ball(1, 1).common([](WorldBuilder& world) { world.ball_age(0.3); });
  EXPECT_NEAR(period(ours, 3), 10.0, 0.11);
  EXPECT_NEAR(period(FrameBuilder(nobody).phase(REGISTA_PHASE_READY), 1), 8.0, 0.11);
}

REGISTA_SENDER_CONTRACT(REGISTA_PLUGIN_FILE, "event_based");

}  // namespace
