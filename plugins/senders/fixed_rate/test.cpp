// SPDX-License-Identifier: MIT
// Matches' worth of decisions: what is sent, when, and that the budget holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

#include <regista/choose_offers.hpp>
#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using fixed_rate::Schedule;
using fixed_rate::Settings;

struct Match {
  int robots = 7, budget = 1200, striker = 7;
  double length = 1200.0;
  double count_delay = 0.0;   // s until a packet shows in the count that robots are told
  bool keeps_striker = true;  // else the role goes round, a robot every 3 s
  Settings settings;
};

struct Course {
  std::vector<std::vector<double>> sent;  // times, by robot
  int packets = 0;
};

// Every robot decides ten times a second, each at its own moment.
Course play(const Match& match) {
  Course course;
  course.sent.resize(static_cast<std::size_t>(match.robots));
  std::vector<Schedule> schedules;
  for (int number = 1; number <= match.robots; ++number) schedules.emplace_back(number, match.robots);
  std::deque<double> uncounted;
  int counted = 0;
  for (int tick = 0; tick < static_cast<int>(match.length * 10.0); ++tick) {
    for (int number = 1; number <= match.robots; ++number) {
      const double time = 0.1 * tick + 0.013 * number;
      while (!uncounted.empty() && uncounted.front() + match.count_delay <= time) {
        uncounted.pop_front();
        ++counted;
      }
      const int striker = match.keeps_striker ? match.striker : 1 + static_cast<int>(time / 3.0) % match.robots;
      const auto index = static_cast<std::size_t>(number - 1);
      const double since = time - (course.sent[index].empty() ? 0.0 : course.sent[index].back());
      if (schedules[index].decide(match.settings, time, since, number == striker, match.budget - counted)) {
        course.sent[index].push_back(time);
        uncounted.push_back(time);
        ++course.packets;
      }
    }
  }
  return course;
}

TEST(FixedRate, SevenRobotsSpendTheBudgetInAMatch) {
  const Course course = play({});
  EXPECT_EQ(course.packets, 1200);
  for (std::size_t robot = 0; robot < 7; ++robot) {
    EXPECT_EQ(course.sent[robot].size(), robot == 6 ? 300u : 150u) << "robot " << robot + 1;
  }
}

TEST(FixedRate, IsStretchedByWhatIsMissing) {
  EXPECT_DOUBLE_EQ(fixed_rate::stretch(600, 600.0, 7), 1.0);
  EXPECT_DOUBLE_EQ(fixed_rate::stretch(700, 600.0, 7), 1.0);
  EXPECT_DOUBLE_EQ(fixed_rate::stretch(593, 600.0, 7), 1.0);
  EXPECT_DOUBLE_EQ(fixed_rate::stretch(500, 607.0, 7), 1.2);
  EXPECT_DOUBLE_EQ(fixed_rate::stretch(0, 600.0, 7), 1.0);
}

// The clock stands for 50 s before either half, as in Ready and Set.
TEST(FixedRate, TheBudgetLastsWhenTheClockHasStood) {
  for (const bool stretched : {false, true}) {
    std::vector<Schedule> schedules;
    for (int number = 1; number <= 7; ++number) schedules.emplace_back(number, 7);
    std::vector<double> last(7, 0.0);
    int left = 1200;
    double longest_silence = 0.0, last_of_team = 0.0;
    for (int tick = 0; tick < 13'000; ++tick) {
      const double time = 0.1 * tick;
      const double played = std::clamp(time - 50.0, 0.0, 600.0) + std::clamp(time - 700.0, 0.0, 600.0);
      for (int number = 1; number <= 7; ++number) {
        const auto i = static_cast<std::size_t>(number - 1);
        const double longer = stretched ? fixed_rate::stretch(left, 1200.0 - played, 7) : 1.0;
        if (!schedules[i].decide({8.0 * longer, number == 7 ? 4.0 * longer : 4.0, 0}, time, time - last[i], number == 7,
                                 left)) {
          continue;
        }
        --left;
        last[i] = last_of_team = time;
      }
      longest_silence = std::max(longest_silence, time - last_of_team);
    }
    if (stretched) {
      EXPECT_LE(longest_silence, 8.5);  // about a period
    } else {
      EXPECT_GT(longest_silence, 90.0);
    }
  }
}

TEST(FixedRate, PeriodsDoNotDrift) {
  const Course course = play({});
  for (std::size_t robot = 0; robot < 7; ++robot) {
    const double period = robot == 6 ? 4.0 : 8.0;
    const std::vector<double>& sent = course.sent[robot];
    for (std::size_t k = 1; k < sent.size(); ++k) EXPECT_NEAR(sent[k] - sent[k - 1], period, 0.1 + 1e-9);
    EXPECT_NEAR(sent.back() - sent.front(), period * static_cast<double>(sent.size() - 1), 0.1 + 1e-9);
  }
}

TEST(FixedRate, RobotsDoNotSendAtOnce) {
  Course course = play({});
  std::vector<double> all;
  for (std::size_t robot = 0; robot < 6; ++robot) {  // the six of equal period
    for (const double time : course.sent[robot]) all.push_back(time);
  }
  std::sort(all.begin(), all.end());
  for (std::size_t k = 1; k < all.size(); ++k) EXPECT_GT(all[k] - all[k - 1], 8.0 / 7.0 - 0.2);
}

TEST(FixedRate, BudgetIsNeverExceededAndIsSpentExactly) {
  for (const int budget : {0, 1, 100, 700, 1199}) {
    Match match;
    match.budget = budget;
    EXPECT_EQ(play(match).packets, budget);
    match.settings.reserve = 30;
    EXPECT_EQ(play(match).packets, std::max(0, budget - 30));
  }
  Match long_match;
  long_match.length = 2000.0;
  EXPECT_EQ(play(long_match).packets, 1200);
  Match quick;
  quick.settings.period = 2.0;
  EXPECT_EQ(play(quick).packets, 1200);
  Match unsteady;
  unsteady.keeps_striker = false;
  EXPECT_LE(play(unsteady).packets, 1200);
}

TEST(FixedRate, ALateCountNeedsAReserve) {
  Match match;
  match.length = 2000.0;
  match.count_delay = 0.5;
  match.settings.reserve = 7;
  EXPECT_LE(play(match).packets, 1200);
  EXPECT_GE(play(match).packets, 1193);
}

TEST(FixedRate, SilenceForGoodOnceSpent) {
  Match match;
  match.budget = 100;
  const Course course = play(match);
  double last = 0.0;
  for (const auto& sent : course.sent) last = sent.empty() ? last : std::max(last, sent.back());
  EXPECT_NEAR(last, 100.0, 3.0);
}

// One robot and its schedules, of which one is asked at a time.
struct Robot {
  std::vector<Schedule> schedules{Schedule(1, 1)};
  double last = 0.0;
  bool decides(double time, bool fast = false, std::size_t schedule = 0) {
    const bool sends = schedules[schedule].decide({}, time, time - last, fast, 1000);
    if (sends) last = time;
    return sends;
  }
};

TEST(FixedRate, DoesNotMakeUpForAbsence) {
  Robot robot;
  int packets = 0;
  for (int tick = 0; tick < 100; ++tick) packets += robot.decides(0.1 * tick) ? 1 : 0;
  EXPECT_EQ(packets, 1);  // at 4 s
  packets = 0;
  for (int tick = 0; tick < 70; ++tick) packets += robot.decides(100.0 + 0.1 * tick) ? 1 : 0;
  EXPECT_EQ(packets, 1);  // at once, and not again before 108 s
}

TEST(FixedRate, BecomingStrikerShortensTheWait) {
  Robot robot;
  for (int tick = 0; tick <= 40; ++tick) EXPECT_EQ(robot.decides(0.1 * tick), tick == 40);
  EXPECT_FALSE(robot.decides(7.9, true));
  EXPECT_TRUE(robot.decides(8.0, true));
}

TEST(FixedRate, ANewRoleNeedNotBeAnEvent) {
  const Settings settings{.period = 8.0, .fast_period = 4.0, .reserve = 0, .at_once = false};
  Schedule schedule(1, 1);
  std::vector<double> sent;
  for (int tick = 0; tick <= 300; ++tick) {
    const double time = 0.1 * tick;
    const double since = sent.empty() ? time : time - sent.back();
    if (schedule.decide(settings, time, since, time > 5.0, 1200)) sent.push_back(time);
  }
  // Striker since 5 s, but due at 12 s as when the packet of 4 s was sent; every 4 s from then on.
  ASSERT_EQ(sent.size(), 6u);
  for (std::size_t i = 0; i < sent.size(); ++i)
    EXPECT_NEAR(sent[i], i == 0 ? 4.0 : 8.0 + 4.0 * static_cast<double>(i), 1e-6);
}

TEST(FixedRate, AnotherContextsPacketsCount) {
  Robot robot;
  robot.schedules = {Schedule(1, 1), Schedule(1, 1)};
  std::vector<double> sent;
  for (int tick = 0; tick < 1000; ++tick) {
    if (robot.decides(0.1 * tick, false, static_cast<std::size_t>(tick / 13 % 2))) sent.push_back(0.1 * tick);
  }
  // A packet may be late by the 1.3 s for which a schedule is not asked; the rate stays.
  EXPECT_GE(sent.size(), 12u);
  EXPECT_LE(sent.size(), 13u);
  for (std::size_t k = 1; k < sent.size(); ++k) EXPECT_GE(sent[k] - sent[k - 1], 8.0 - 1.3 - 1e-9);
}

TEST(Offers, UrgencyThenAgeWhileTheyFit) {
  std::vector<std::size_t> chosen;
  const std::vector<regista::PendingOffer> offers{{20, 0.5}, {30, 0.9}, {10, 0.5}, {70, 1.0}, {5, 0.1}};
  regista::choose_offers(offers, 1000, chosen);
  EXPECT_EQ(chosen, (std::vector<std::size_t>{3, 1, 0, 2, 4}));
  regista::choose_offers(offers, 65, chosen);
  EXPECT_EQ(chosen, (std::vector<std::size_t>{1, 0, 2, 4}));
  regista::choose_offers(offers, 34, chosen);
  EXPECT_EQ(chosen, (std::vector<std::size_t>{1}));
  regista::choose_offers(offers, 0, chosen);
  EXPECT_TRUE(chosen.empty());
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

// Packets of robot 4 in 80 s while it has this role.
int packets_as(const char* role, const char* fast_role) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "fixed_rate");
  Instance sender(plugin, EnvironmentBuilder{}.own(4), Values(plugin).set("fast_role", fast_role));
  regista_budget budget{};
  budget.size = sizeof budget;
  budget.packets_left = 1000;
  int packets = 0;
  double last = 0.0;
  for (int tick = 0; tick < 800; ++tick) {
    budget.since_own = 0.1 * tick - last;
    const Scene scene = FrameBuilder{}.own(4).time(0.1 * tick).robot(4).previous(4, role).build();
    const Sent sent = sender.decide(scene, {}, {}, budget);
    packets += sent.send;
    if (sent.send == 1) last = 0.1 * tick;
    EXPECT_EQ(sent.reason, REGISTA_EVENT_PERIOD);
  }
  return packets;
}

TEST(FixedRatePlugin, TheFastRoleIsKnownByName) {
  EXPECT_EQ(packets_as("striker", "striker"), 20);
  EXPECT_EQ(packets_as("supporter", "striker"), 10);
  EXPECT_EQ(packets_as("supporter", "supporter"), 20);
  EXPECT_EQ(packets_as("striker", ""), 10);
  EXPECT_ANY_THROW(packets_as("striker", "strikr"));
}

TEST(FixedRatePlugin, ReserveIsOfTheShareOfAMatch) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "fixed_rate");
  const auto sends = [&](int left, double share) {
    Instance sender(plugin, EnvironmentBuilder{}.team_size(1).own(1),
                    Values(plugin).set("reserve", 100).set("lasts", false));
    regista_budget budget{};
    budget.size = sizeof budget;
    budget.packets_left = left;
    budget.share = share;
    const auto at = [](double time) { return FrameBuilder{}.own(1).team_size(1).time(time).robot(1).build(); };
    sender.decide(at(0.0), {}, {}, budget);
    budget.since_own = 8.0;
    return sender.decide(at(8.0), {}, {}, budget).send == 1;
  };
  for (const auto& [share, kept] : {std::pair{1.0, 100}, {0.1, 10}, {0.025, 3}}) {
    EXPECT_FALSE(sends(kept, share)) << share;
    EXPECT_TRUE(sends(kept + 1, share)) << share;
  }
}

TEST(FixedRatePlugin, TakesOffersAlong) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "fixed_rate");
  Instance sender(plugin, EnvironmentBuilder{}.team_size(1).own(1));
  regista_budget budget{};
  budget.size = sizeof budget;
  budget.packets_left = 1000;
  budget.bytes_free = 60;
  const std::vector<regista_offer> offers{{11, 50, REGISTA_MEDIUM_RADIO, 0.2, 99.0},
                                          {12, 40, REGISTA_MEDIUM_RADIO, 0.9, 99.0},
                                          {13, 20, REGISTA_MEDIUM_RADIO, 0.1, 99.0}};
  EXPECT_EQ(sender.decide(FrameBuilder{}.own(1).team_size(1).time(0.0).robot(1).build(), {}, offers, budget).send, 0);
  budget.since_own = 4.0;
  const Sent sent = sender.decide(FrameBuilder{}.own(1).team_size(1).time(4.0).robot(1).build(), {}, offers, budget);
  EXPECT_EQ(sent.send, 1);
  EXPECT_EQ(sent.granted, (std::vector<std::uint64_t>{12, 13}));
}

REGISTA_SENDER_CONTRACT(REGISTA_PLUGIN_FILE, "fixed_rate");

}  // namespace
