// SPDX-License-Identifier: MIT
// The rules one by one against a clock, and a match's worth of decisions against the budget.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include <regista/sender.hpp>

#include "algorithm.hpp"
#include "ball_witness.hpp"

namespace {

using event_based::BallWitness;
using event_based::Cause;
using event_based::Event;
using event_based::Pace;
using event_based::Sender;
using event_based::Settings;
using event_based::Situation;

struct Packet {
  double time;
  Cause cause;
};

// One robot that decides ten times a second. `at` may change the situation and returns what happened.
std::vector<Packet> run(const Settings& settings, double length,
                        const std::function<std::vector<Event>(int tick, Situation&)>& at, int number = 3) {
  Sender sender;
  std::vector<Packet> packets;
  double last = 0.0;
  for (int tick = 0; tick < static_cast<int>(length * 10.0); ++tick) {
    Situation now;
    now.time = 0.1 * tick;
    now.number = number;
    now.team_size = 7;
    now.budget = 1200;
    now.packets_left = 1000;
    now.reserve = 30;
    now.since_own = now.time - last;
    const std::vector<Event> events = at(tick, now);
    if (const auto cause = sender.decide(settings, now, events)) {
      packets.push_back({now.time, *cause});
      last = now.time;
    }
  }
  return packets;
}

std::vector<Event> nothing(int, Situation&) { return {}; }

// Time between the later packets of a robot to which nothing happens.
double steady_period(
    int number, const std::function<void(Situation&)>& set = [](Situation&) {}) {
  const auto packets = run(
      {}, 200.0, [&](int, Situation& now) { return set(now), std::vector<Event>{}; }, number);
  EXPECT_GE(packets.size(), 5u);
  for (const Packet& packet : packets) EXPECT_EQ(packet.cause, Cause::period);
  for (std::size_t k = 2; k < packets.size(); ++k) {
    EXPECT_NEAR(packets[k].time - packets[k - 1].time, packets[1].time - packets[0].time, 1e-6);
  }
  return packets[1].time - packets[0].time;
}

TEST(EventBased, Periods) {
  EXPECT_NEAR(steady_period(3), 10.0, 1e-6);
  EXPECT_NEAR(steady_period(1), 20.0, 1e-6);
  EXPECT_NEAR(steady_period(3, [](Situation& now) { now.alone_with_ball = true; }), 4.0, 1e-6);
  EXPECT_NEAR(steady_period(1, [](Situation& now) { now.alone_with_ball = true; }), 4.0, 1e-6);
  EXPECT_NEAR(steady_period(1, [](Situation& now) { now.ready_or_set = true; }), 8.0, 1e-6);
  EXPECT_NEAR(steady_period(4, [](Situation& now) { now.ready_or_set = true; }), 11.0, 1e-6);
  EXPECT_NEAR(steady_period(7, [](Situation& now) { now.ready_or_set = true; }), 14.0, 1e-6);
}

TEST(EventBased, ByEventsAloneNothingIsSentForTime) {
  Settings settings;
  settings.periodic = false;
  for (const bool ready : {false, true}) {
    for (const bool alone : {false, true}) {
      const auto set = [&](int, Situation& now) {
        now.ready_or_set = ready;
        now.alone_with_ball = alone;
        return std::vector<Event>{};
      };
      for (int number = 1; number <= 7; ++number) EXPECT_TRUE(run(settings, 300.0, set, number).empty());
    }
  }
  const auto packets = run(settings, 300.0, [](int tick, Situation&) {
    return tick == 1000 || tick == 2000 ? std::vector<Event>{{Cause::pose_moved, 2.0}} : std::vector<Event>{};
  });
  ASSERT_EQ(packets.size(), 2u);
  EXPECT_NEAR(packets[0].time, 100.0, 1e-9);
  EXPECT_NEAR(packets[1].time, 200.0, 1e-9);
  for (const Packet& packet : packets) EXPECT_EQ(packet.cause, Cause::pose_moved);
}

TEST(EventBased, FirstPacketsAreSpread) {
  std::vector<double> first;
  for (int number = 2; number <= 7; ++number) first.push_back(run({}, 30.0, nothing, number).at(0).time);
  for (std::size_t k = 1; k < first.size(); ++k) EXPECT_NEAR(first[k] - first[k - 1], 10.0 / 7.0, 0.11);
}

TEST(EventBased, AnEventIsToldAtOnce) {
  for (std::size_t k = 0; k < event_based::causes - 1; ++k) {
    const auto cause = static_cast<Cause>(k);
    Settings settings;
    settings.period = 1000.0;
    const auto at = [&](int tick, Situation&) {
      return tick == 50 ? std::vector<Event>{{cause, 1e3}} : std::vector<Event>{};
    };
    const auto packets = run(settings, 20.0, at);
    ASSERT_EQ(packets.size(), 1u) << k;
    EXPECT_NEAR(packets[0].time, 5.0, 1e-9);
    EXPECT_EQ(packets[0].cause, cause);
    settings.rules[k].heeded = false;
    EXPECT_TRUE(run(settings, 20.0, at).empty()) << k;
  }
}

TEST(EventBased, ThresholdsAndIntervals) {
  Settings settings;
  settings.period = 1000.0;
  auto& rule = settings.rules[static_cast<std::size_t>(Cause::ball_moved)];
  rule = {true, 2.0, 1.0};
  const auto always = [](double value) {
    return [value](int, Situation&) { return std::vector<Event>{{Cause::ball_moved, value}}; };
  };
  EXPECT_TRUE(run(settings, 20.0, always(0.99)).empty());
  const auto packets = run(settings, 20.05, always(1.0));
  ASSERT_EQ(packets.size(), 10u);  // since 1.0 s, when the least interval since the start has passed, every 2 s
  for (std::size_t k = 1; k < packets.size(); ++k) EXPECT_NEAR(packets[k].time - packets[k - 1].time, 2.0, 1e-6);
  settings.minimum_interval = 5.0;
  for (std::size_t k = 1; k < run(settings, 60.0, always(1.0)).size(); ++k) {
    EXPECT_NEAR(run(settings, 60.0, always(1.0))[k].time - run(settings, 60.0, always(1.0))[k - 1].time, 5.0, 1e-6);
  }
}

TEST(EventBased, WhistleCoolsDown) {
  Settings settings;
  settings.period = 1000.0;
  settings.rules[static_cast<std::size_t>(Cause::whistle)].interval = 1.5;
  const auto packets = run(settings, 12.0, [](int tick, Situation&) {  // a whistle of 1.4 s, and another at 11 s
    return (tick >= 50 && tick < 64) || tick == 110 ? std::vector<Event>{{Cause::whistle}} : std::vector<Event>{};
  });
  // The news of 6.3 s waits for the cool-down and is told at 6.5 s.
  ASSERT_EQ(packets.size(), 3u);
  EXPECT_NEAR(packets[0].time, 5.0, 1e-9);
  EXPECT_NEAR(packets[1].time, 6.5, 1e-9);
  EXPECT_NEAR(packets[2].time, 11.0, 1e-9);
}

TEST(EventBased, AnEventThatMustWaitIsToldWhileItIsNew) {
  Settings settings;
  settings.period = 1000.0;
  settings.minimum_interval = 3.0;
  const auto at = [](int tick, Situation&) {
    if (tick == 50) return std::vector<Event>{{Cause::whistle}};
    if (tick == 65) return std::vector<Event>{{Cause::role_changed, -1.0}};
    return std::vector<Event>{};
  };
  settings.pending_for = 2.0;
  auto packets = run(settings, 20.0, at);
  ASSERT_EQ(packets.size(), 2u);
  EXPECT_NEAR(packets[1].time, 8.0, 1e-9);
  EXPECT_EQ(packets[1].cause, Cause::role_changed);
  settings.pending_for = 1.0;
  EXPECT_EQ(run(settings, 20.0, at).size(), 1u);
}

TEST(EventBased, OnePacketTellsAllAndIsCountedForTheMostImportant) {
  Settings settings;
  settings.period = 1000.0;
  const auto packets = run(settings, 20.0, [](int tick, Situation&) {
    return tick == 50 ? std::vector<Event>{{Cause::pose_moved, 9.0}, {Cause::role_changed}, {Cause::ball_found}}
                      : std::vector<Event>{};
  });
  ASSERT_EQ(packets.size(), 1u);
  EXPECT_EQ(packets[0].cause, Cause::ball_found);
}

TEST(EventBased, SilentAtTheReserve) {
  Settings settings;
  for (const int left : {30, 29, 0, -5}) {
    EXPECT_TRUE(run(settings, 60.0, [&](int, Situation& now) {
                  now.packets_left = left;
                  return std::vector<Event>{{Cause::whistle}, {Cause::offer}};
                }).empty());
  }
  EXPECT_FALSE(
      run(settings, 60.0, [](int, Situation& now) { return now.packets_left = 31, std::vector<Event>{}; }).empty());
}

TEST(EventBased, BehindTheLineOnlyGreatEventsAreTold) {
  Settings settings;
  // 1170 of 1200 packets lie above the reserve. A third of the time is left: 30 + 1170 / 3 = 420, less the margin
  // of 20.
  int left = 399;
  const auto behind = [&left](int tick, Situation& now) {
    now.packets_left = left;
    now.line = 400.0;
    std::vector<Event> events{{Cause::role_changed}, {Cause::pose_moved, 5.0}};
    if (tick == 100) events.push_back({Cause::returned});
    return events;
  };
  const auto packets = run(settings, 60.0, behind);
  ASSERT_EQ(packets.size(), 1u);
  EXPECT_EQ(packets[0].cause, Cause::returned);
  settings.pace = Pace::none;
  EXPECT_GT(run(settings, 60.0, behind).size(), 10u);
  settings.pace = Pace::linear;
  settings.pace_margin = 21.0;
  EXPECT_GT(run(settings, 60.0, behind).size(), 10u);
  settings.pace_margin = 20.0;
  left = 400;
  EXPECT_GT(run(settings, 60.0, behind).size(), 10u);
}

TEST(EventBased, TheLineRunsFromTheBudgetToTheReserve) {
  const auto line = [](int budget, int reserve, double left_evenly) {
    Situation now;
    now.budget = budget;
    now.reserve = reserve;
    now.line = left_evenly;
    return event_based::line_to_reserve(now);
  };
  EXPECT_DOUBLE_EQ(line(1200, 30, 1200.0), 1200.0);
  EXPECT_DOUBLE_EQ(line(1200, 30, 600.0), 615.0);  // half of the 1170, and the reserve
  EXPECT_DOUBLE_EQ(line(1200, 30, 40.0), 69.0);    // a thirtieth of them
  EXPECT_DOUBLE_EQ(line(1200, 30, 0.0), 30.0);
  EXPECT_DOUBLE_EQ(line(120, 3, 60.0), 61.5);
  EXPECT_DOUBLE_EQ(line(1200, 0, 345.6), 345.6);
  EXPECT_DOUBLE_EQ(line(20, 30, 10.0), 30.0);  // no packet may be spent
  EXPECT_DOUBLE_EQ(line(0, 0, 0.0), 0.0);
}

// Seven restless robots for 1200 s. `left_at_end`: what the line leaves is spent, and never more.
struct Totals {
  int packets = 0, least_left = 1200;
  double last_packet = 0.0;  // s
  double worst_lag = 0.0;    // packets below the line to the reserve
  std::map<Cause, int> by_cause;
};

Totals play(const Settings& settings, double events_per_second, bool great_events) {
  Totals totals;
  std::vector<Sender> senders(7);
  std::vector<double> last(7, 0.0);
  std::mt19937 random(10);
  std::bernoulli_distribution small(events_per_second / 10.0), great(great_events ? 0.002 : 0.0);
  for (int tick = 0; tick < 12000; ++tick) {
    for (int number = 1; number <= 7; ++number) {
      const auto i = static_cast<std::size_t>(number - 1);
      Situation now;
      now.time = 0.1 * tick + 0.013 * number;
      now.number = number;
      now.team_size = 7;
      now.budget = 1200;
      now.packets_left = 1200 - totals.packets;
      now.reserve = 30;
      now.line = 1200.0 - now.time;
      now.since_own = now.time - last[i];
      std::vector<Event> events;
      if (small(random)) events.push_back({Cause::role_changed});
      if (great(random)) events.push_back({Cause::ball_known_again, 10.0});
      if (const auto cause = senders[i].decide(settings, now, events)) {
        EXPECT_GE(now.time - last[i], settings.minimum_interval - 1e-6);
        last[i] = totals.last_packet = now.time;
        ++totals.packets;
        ++totals.by_cause[*cause];
        if (!event_based::is_great(*cause)) {
          const double line = 30.0 + 0.975 * (1200.0 - now.time);
          totals.worst_lag = std::max(totals.worst_lag, line - (1200 - totals.packets));
        }
      }
    }
    totals.least_left = std::min(totals.least_left, 1200 - totals.packets);
  }
  return totals;
}

TEST(EventBased, PaceKeepsSmallEventsToTheLine) {
  const Totals restless = play({}, 1.0, false);
  EXPECT_LE(restless.worst_lag, 21.0);  // the margin, and the packet itself
  EXPECT_EQ(restless.least_left, 30);
  // Always 20 packets below the line, they reach the reserve when 20 of its 1170 packets in 1200 s are left to it.
  EXPECT_NEAR(restless.last_packet, 1200.0 - 20.0 / 0.975, 2.0);
  EXPECT_GT(restless.by_cause.at(Cause::role_changed), 800);
}

TEST(EventBased, WithoutPaceTheBudgetGoesEarlyButTheReserveStays) {
  Settings settings;
  settings.pace = Pace::none;
  const Totals restless = play(settings, 1.0, true);
  EXPECT_EQ(restless.packets, 1170);
  EXPECT_GT(restless.worst_lag, 200.0);
}

TEST(EventBased, QuietRobotsSpendTheirPeriods) {
  const Totals quiet = play({}, 0.0, false);
  // Six every 10 s and the goalkeeper every 20 s, within the tenth of a second of a decision each.
  EXPECT_LE(quiet.packets, 6 * 120 + 60 + 7);
  EXPECT_GE(quiet.packets, 6 * 118 + 59);
}

// --- Who sees the ball --------------------------------------------------------------------------------------------

TEST(BallWitness, AloneUntilSomebodyElseTells) {
  BallWitness witness;
  EXPECT_FALSE(witness.is_alone(0.0, {false, 0.0}, {false, 0.0}, 10.0));
  EXPECT_TRUE(witness.is_alone(1.0, {true, 0.0}, {false, 0.0}, 10.0));
  witness.sent();
  // Its own packet comes back as what all know: nobody else is behind it, even if ages were rounded.
  EXPECT_TRUE(witness.is_alone(2.0, {true, 0.0}, {true, 0.9}, 10.0));
  // Now another one tells of a sighting at 2.5 s.
  EXPECT_FALSE(witness.is_alone(3.0, {true, 0.0}, {true, 0.5}, 10.0));
  EXPECT_FALSE(witness.is_alone(12.4, {true, 0.0}, {true, 9.9}, 10.0));
  EXPECT_TRUE(witness.is_alone(12.6, {true, 0.0}, {true, 10.1}, 10.0));
}

TEST(BallWitness, WhoDoesNotSeeIsNotAlone) {
  BallWitness witness;
  EXPECT_FALSE(witness.is_alone(5.0, {true, 0.6}, {false, 0.0}, 10.0));
  // Fresh in the own world only because a teammate told just now.
  EXPECT_FALSE(witness.is_alone(6.0, {true, 0.2}, {true, 0.2}, 0.0));
}

TEST(EventBased, OnlyTheFallIsGreat) {
  using event_based::is_great;
  EXPECT_TRUE(is_great(Cause::fell));
  for (const Cause cause : {Cause::got_up, Cause::phase_changed, Cause::context_changed}) EXPECT_FALSE(is_great(cause));
}

}  // namespace
