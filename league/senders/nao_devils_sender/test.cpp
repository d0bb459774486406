// SPDX-License-Identifier: MIT
// Each kind of news alone, matches' worth of restless robots against the published limits, and the plugin.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <regista/sender.hpp>
#include <regista/testkit/contract.hpp>
#include <regista/testkit/count_allocations.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using nao_devils::Limit, nao_devils::News, nao_devils::Sender, nao_devils::Settings, nao_devils::Situation;

// A robot that has told its place and has no news.
Situation quiet(double time) {
  Situation now;
  now.time = time;
  now.team_size = 7;
  now.speed = 0.3;
  now.packets_left = 1000;
  now.line = 1000.0;
  return now;
}
Sender with_nothing_new() {
  Sender sender;
  EXPECT_EQ(sender.decide({}, quiet(-100.0)), News::moved);
  EXPECT_FALSE(sender.decide({}, quiet(-90.0)));
  return sender;
}

// --- Limits ----------------------------------------------------------------------------------------------------

TEST(Times, EqualCountingTheWindow) {
  std::mt19937 random(1);
  int allowed = 0, refused = 0;
  for (int round = 0; round < 10000; ++round) {
    const Limit limit{1 + static_cast<int>(random() % nao_devils::Times::most),
                      0.5 * static_cast<double>(random() % 20)};
    nao_devils::Times times;
    std::vector<double> all;
    for (std::size_t k = random() % 30; k-- > 0;) {
      all.push_back(0.5 * static_cast<double>(random() % 40));  // in any order
      times.add(all.back());
    }
    const double now = 20.0;
    const auto within = std::count_if(all.begin(), all.end(), [&](double time) { return now - time < limit.window; });
    const bool truth = within < limit.count;
    ASSERT_EQ(times.allow(limit, now), truth) << "round " << round;
    (truth ? allowed : refused) += 1;
  }
  EXPECT_GT(allowed, 1000);
  EXPECT_GT(refused, 1000);
}

// --- News ------------------------------------------------------------------------------------------------------

TEST(NaoDevilsSender, TheFirstPacketTellsThePlace) {
  Sender sender;
  EXPECT_EQ(sender.decide({}, quiet(0.0)), News::moved);
  EXPECT_FALSE(sender.decide({}, quiet(50.0)));
}

TEST(NaoDevilsSender, HowFarIsNews) {
  const auto tells = [](double distance, const auto& change) {
    Sender sender = with_nothing_new();
    Situation now = quiet(0.0);
    now.x = 0.6 * distance;
    now.y = -0.8 * distance;
    change(now);
    return sender.decide({}, now) == News::moved;
  };
  const auto far = [](Situation&) {};
  const auto chaser = [](Situation& now) { now.is_chaser = now.said_chaser = true; };
  const auto near = [](Situation& now) { now.ball_distance = 1.49; };
  const auto not_near = [](Situation& now) { now.ball_distance = 1.51; };
  const auto slow = [](Situation& now) { now.speed = 0.09, now.ball_distance = 1.0; };
  EXPECT_FALSE(tells(1.19, far));
  EXPECT_TRUE(tells(1.21, far));
  EXPECT_FALSE(tells(1.19, not_near));
  EXPECT_FALSE(tells(0.49, chaser));
  EXPECT_TRUE(tells(0.51, chaser));
  EXPECT_FALSE(tells(0.49, near));
  EXPECT_TRUE(tells(0.51, near));
  EXPECT_FALSE(tells(0.19, slow));
  EXPECT_TRUE(tells(0.21, slow));
}

TEST(NaoDevilsSender, TheBallIsNewsWhenItIsOffOrLacked) {
  const auto tells = [](std::optional<double> off, double lacked) {
    Sender sender = with_nothing_new();
    Situation now = quiet(0.0);
    now.ball_off = off;
    now.ball_lacked = lacked;
    return sender.decide({}, now) == News::ball;
  };
  EXPECT_FALSE(tells({}, 0.0));
  EXPECT_FALSE(tells(0.99, 0.0));
  EXPECT_TRUE(tells(1.0, 0.0));
  EXPECT_FALSE(tells({}, 2.9));
  EXPECT_TRUE(tells({}, 3.0));
}

TEST(NaoDevilsSender, ChaserIsNewsWhenThePacketBeforeSaidOtherwise) {
  for (const bool is : {false, true}) {
    for (const bool said : {false, true}) {
      Sender sender = with_nothing_new();
      Situation now = quiet(0.0);
      now.is_chaser = is;
      now.said_chaser = said;
      EXPECT_EQ(sender.decide({}, now) == News::chaser, is != said);
    }
  }
}

TEST(NaoDevilsSender, TeammatesNewsCountForTheTeam) {
  const auto after = [](News news, double since) {
    Sender sender = with_nothing_new();
    sender.told(news, -since);
    Situation now = quiet(0.0);
    now.has_new_map = news == News::map;
    now.is_chaser = news == News::chaser;
    if (news == News::ball) now.ball_off = 2.0;
    return sender.decide({}, now) == news;
  };
  EXPECT_FALSE(after(News::map, 2.9));
  EXPECT_TRUE(after(News::map, 3.0));
  EXPECT_FALSE(after(News::ball, 0.9));
  EXPECT_TRUE(after(News::ball, 1.0));
  EXPECT_TRUE(after(News::chaser, 0.1));  // the second of three
  Sender sender = with_nothing_new();
  for (const double time : {-4.4, -2.0, -1.0}) sender.told(News::chaser, time);
  Situation now = quiet(0.0);
  now.is_chaser = true;
  EXPECT_FALSE(sender.decide({}, now));
  now.time = 0.1;
  EXPECT_EQ(sender.decide({}, now), News::chaser);
  now.time = 5.0;
  EXPECT_FALSE(sender.decide({}, now));  // its own was 4.9 s ago
  now.time = 5.1;
  EXPECT_EQ(sender.decide({}, now), News::chaser);
}

// --- The budget ------------------------------------------------------------------------------------------------

TEST(NaoDevilsSender, BudgetAllowsAboveItsShareOrInSilence) {
  const auto allows = [](int left, double line, double time, double silence) {
    Situation now = quiet(time);
    now.number = 7;  // first in the first ten seconds of each seventy
    now.packets_left = left;
    now.line = line;
    now.since_team = silence;
    now.reserve = 5;
    return nao_devils::budget_allows({}, now);
  };
  EXPECT_TRUE(allows(1080, 1200.0, 0.0, 0.0));
  EXPECT_FALSE(allows(1079, 1200.0, 0.0, 0.0));
  EXPECT_FALSE(allows(1139, 1200.0, 45.0, 0.0));  // 0.95
  EXPECT_TRUE(allows(1140, 1200.0, 45.0, 0.0));
  EXPECT_FALSE(allows(599, 600.0, 700.0, 0.0));
  EXPECT_TRUE(allows(600, 600.0, 700.0, 0.0));
  EXPECT_FALSE(allows(599, 600.0, 700.0, 1.0));
  EXPECT_TRUE(allows(599, 600.0, 700.0, 1.1));
  EXPECT_TRUE(allows(6, 0.0, 1199.0, 0.0));
  EXPECT_FALSE(allows(5, 0.0, 1199.0, 9.0));
}

TEST(NaoDevilsSender, RobotsTakeTurnsInWaiting) {
  const Settings settings;
  for (const double time : {0.0, 10.0, 700.0, 1234.5}) {
    std::vector<double> waits;
    for (int number = 1; number <= 7; ++number) {
      Situation now = quiet(time);
      now.number = number;
      waits.push_back(nao_devils::silence_to_wait_for(settings, now));
    }
    std::sort(waits.begin(), waits.end());
    for (int k = 0; k < 7; ++k) EXPECT_NEAR(waits[static_cast<std::size_t>(k)], 1.1 + 0.2 * k, 1e-9);
  }
}

struct Packet {
  News news;
  double time;
  int robot;
};

// Seven robots that have all kinds of news nearly always, ten decisions a second each, for 1200 s. Others hear of a
// packet, and all of the count, after `delay`.
std::vector<Packet> play(unsigned seed, double delay, double restless) {
  const Settings settings;
  std::mt19937 random(seed);
  std::bernoulli_distribution has_news(restless);
  std::vector<Sender> senders(7);
  std::vector<Packet> packets;
  std::vector<double> own_last(7, 0.0);
  std::size_t heard = 0;
  for (int tick = 0; tick < 12000; ++tick) {
    for (int robot = 0; robot < 7; ++robot) {
      const double time = 0.1 * tick + 0.013 * robot;
      for (; heard < packets.size() && packets[heard].time + delay <= time; ++heard) {
        for (int other = 0; other < 7; ++other) {
          if (other != packets[heard].robot) {
            senders[static_cast<std::size_t>(other)].told(packets[heard].news, packets[heard].time);
          }
        }
      }
      const double heard_last = heard == 0 ? 0.0 : packets[heard - 1].time;
      Situation now;
      now.number = robot + 1;
      now.team_size = 7;
      now.time = time;
      now.packets_left = 1200 - static_cast<int>(heard);
      now.line = 1200.0 - time;
      now.reserve = settings.reserve;
      now.since_team = time - std::max(heard_last, own_last[static_cast<std::size_t>(robot)]);
      now.has_new_map = has_news(random);
      now.is_chaser = has_news(random);
      if (has_news(random)) now.ball_off = 3.0;
      now.x = has_news(random) ? 10.0 * tick : 0.0;
      const auto news = senders[static_cast<std::size_t>(robot)].decide(settings, now);
      if (!news) continue;
      const double wanted = std::min(1.0, 0.9 + time / 900.0) * now.line;
      EXPECT_TRUE(now.packets_left >= wanted - 1e-9 || now.since_team >= 1.1 - 1e-9) << time;
      EXPECT_GT(now.packets_left, 5);
      packets.push_back({*news, time, robot});
      own_last[static_cast<std::size_t>(robot)] = time;
    }
  }
  return packets;
}

// Whether more than `count` of these came within any window.
bool exceeds(const std::vector<double>& times, const Limit& limit) {
  for (std::size_t k = static_cast<std::size_t>(limit.count); k < times.size(); ++k) {
    if (times[k] - times[k - static_cast<std::size_t>(limit.count)] < limit.window - 1e-6) return true;
  }
  return false;
}

TEST(NaoDevilsSender, LimitsAndBudgetHoldThroughAMatch) {
  for (const double restless : {0.02, 0.2, 1.0}) {
    const std::vector<Packet> packets = play(static_cast<unsigned>(100 * restless), 0.0, restless);
    std::map<News, std::vector<double>> team;
    std::map<std::pair<int, News>, std::vector<double>> own;
    for (const Packet& each : packets) {
      team[each.news].push_back(each.time);
      own[{each.robot, each.news}].push_back(each.time);
    }
    EXPECT_FALSE(exceeds(team[News::map], {1, 3.0}));
    EXPECT_FALSE(exceeds(team[News::chaser], {3, 4.5}));
    EXPECT_FALSE(exceeds(team[News::ball], {1, 1.0}));
    for (int robot = 0; robot < 7; ++robot) {
      EXPECT_FALSE(exceeds(own[{robot, News::chaser}], {1, 5.0}));
      EXPECT_FALSE(exceeds(own[{robot, News::moved}], {1, 1.0}));
    }
    for (const News news : {News::map, News::chaser, News::ball, News::moved}) EXPECT_GT(team[news].size(), 20u);
    EXPECT_LE(packets.size(), 1195u);
    if (restless < 0.1) continue;
    // At most a tenth of the packets ahead of even spending; and after 90 s whoever is ahead sends in silence only.
    for (std::size_t k = 1; k < packets.size(); ++k) {
      const double ahead = static_cast<double>(k) - packets[k].time;
      EXPECT_LE(ahead, 120.0);
      if (packets[k].time > 90.0 && ahead > 1e-9) {
        ASSERT_GE(packets[k].time - packets[k - 1].time, 1.1 - 1e-9);
      }
    }
    EXPECT_GT(packets.back().time, 1150.0);
    EXPECT_GT(packets.size(), 1150u);
  }
}

TEST(NaoDevilsSender, TheBudgetLastsThoughPacketsAreHeardLate) {
  const std::vector<Packet> packets = play(7, 0.09, 1.0);
  EXPECT_LE(packets.size(), 1200u);
  EXPECT_GT(packets.back().time, 1100.0);
  std::map<std::pair<int, News>, std::vector<double>> own;
  for (const Packet& each : packets) own[{each.robot, each.news}].push_back(each.time);
  for (int robot = 0; robot < 7; ++robot) {
    EXPECT_FALSE(exceeds(own[{robot, News::chaser}], {1, 5.0}));
    EXPECT_FALSE(exceeds(own[{robot, News::moved}], {1, 1.0}));
  }
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

const Loaded& plugin() {
  static const Loaded loaded(REGISTA_PLUGIN_FILE, "nao_devils_sender");
  return loaded;
}

regista_budget plenty() {
  regista_budget budget{};
  budget.size = sizeof budget;
  budget.packets_left = 1000;
  budget.line = 1000.0;
  budget.share = 1.0;
  budget.bytes_free = 60;
  return budget;
}

// Robot 3 with its offers as the host would list them, and one decision a second; the first has told its place.
struct Robot {
  Instance instance{plugin(), EnvironmentBuilder{}.own(3)};
  double time = 1.0;
  Robot() { EXPECT_EQ(decide(FrameBuilder{}.robot(3)), regista::own_reason(3)); }
  std::vector<std::uint64_t> granted;
  int decide(FrameBuilder frame, const std::vector<regista_event>& events = {},
             std::vector<regista_offer> offers = {}) {
    for (const auto& each : instance.host().offers) {
      if (each.waits()) offers.push_back({each.handle, 3, REGISTA_MEDIUM_RADIO, each.urgency, each.expiry});
    }
    const Sent sent = instance.decide(frame.own(3).time(time).build(), events, offers, plenty());
    granted = sent.granted;
    for (const std::uint64_t handle : granted) {
      std::erase_if(instance.host().offers, [&](const auto& each) { return each.handle == handle; });
      instance.transmitted(handle);
    }
    time += 1.0;
    return sent.send == 1 ? sent.reason : -1;
  }
};

constexpr std::uint64_t map_offer = 1000, other_offer = 1001;

TEST(NaoDevilsSenderPlugin, NewsAreTheReasons) {
  const FrameBuilder still = FrameBuilder{}.robot(3);
  const auto after_start = [&](FrameBuilder frame, const std::vector<regista_event>& events = {},
                               const std::vector<regista_offer>& offers = {}) {
    Robot robot;
    return robot.decide(std::move(frame), events, offers);
  };
  EXPECT_EQ(after_start(still), -1);
  EXPECT_EQ(after_start(still, {}, {{map_offer, 8, REGISTA_MEDIUM_RADIO, 1.0, 99.0}}), regista::own_reason(0));
  EXPECT_EQ(after_start(still, {}, {{map_offer, 8, REGISTA_MEDIUM_RADIO, 0.9, 99.0}}), -1);
  EXPECT_EQ(after_start(still, {}, {{map_offer, 57, REGISTA_MEDIUM_RADIO, 1.0, 99.0}}), regista::own_reason(0));
  EXPECT_EQ(after_start(still, {}, {{map_offer, 58, REGISTA_MEDIUM_RADIO, 1.0, 99.0}}), -1);  // would never fit
  EXPECT_EQ(after_start(FrameBuilder(still).previous(3, "striker")), regista::own_reason(1));
  EXPECT_EQ(after_start(FrameBuilder(still).role("striker").previous(3, "striker")), -1);
  EXPECT_EQ(after_start(FrameBuilder(still).role("striker")), regista::own_reason(1));  // no longer
  EXPECT_EQ(after_start(still, {{REGISTA_EVENT_BALL_MOVED, 0, 1.2}}), regista::own_reason(2));
  EXPECT_EQ(after_start(still, {{REGISTA_EVENT_BALL_MOVED, 0, 0.9}}), -1);
  EXPECT_EQ(after_start(still, {{REGISTA_EVENT_BALL_KNOWN_AGAIN, 0, 4.0}}), regista::own_reason(2));
  EXPECT_EQ(after_start(FrameBuilder{}.robot(3).at(0.3, 0)), regista::own_reason(3));  // it stands
  EXPECT_EQ(after_start(FrameBuilder{}.robot(3).at(0.3, 0).velocity(0.2, 0)), -1);
}

TEST(NaoDevilsSenderPlugin, APacketSaysWhatItIsForAndTakesAlongWhatFits) {
  Robot robot;
  // One offer for each news that limits of the team count.
  std::map<std::uint64_t, std::string> said;
  for (const auto& each : robot.instance.host().offers) said[each.handle] = robot.instance.describe(each.bytes);
  ASSERT_EQ(said.size(), 3u);
  const std::vector<regista_offer> offers{{other_offer, 50, REGISTA_MEDIUM_RADIO, 0.5, 99.0},
                                          {other_offer + 1, 20, REGISTA_MEDIUM_RADIO, 0.4, 99.0}};
  ASSERT_EQ(robot.decide(FrameBuilder{}.robot(3).previous(3, "striker"), {}, offers), regista::own_reason(1));
  ASSERT_EQ(robot.granted.size(), 2u);
  EXPECT_EQ(said[robot.granted[0]], "sent for: chaser_changed");
  EXPECT_EQ(robot.granted[1], other_offer);
  // Its own place is nobody's limit.
  ASSERT_EQ(robot.decide(FrameBuilder{}.robot(3).at(2, 0).role("striker").previous(3, "striker")),
            regista::own_reason(3));
  EXPECT_TRUE(robot.granted.empty());
  EXPECT_EQ(robot.instance.host().offers.size(), 3u);  // there is one of each again
  EXPECT_EQ(robot.instance.describe(std::vector<std::uint8_t>{7}), "no news of this team");
}

TEST(NaoDevilsSenderPlugin, ANewMapWaitsForItsTurnAndAnOldOneGoesAlong) {
  const std::vector<regista_offer> map{{map_offer, 8, REGISTA_MEDIUM_RADIO, 1.0, 99.0}};
  const std::vector<std::uint8_t> label_of_map{0};
  const auto takes_map = [](const Robot& robot) {
    return std::find(robot.granted.begin(), robot.granted.end(), map_offer) != robot.granted.end();
  };
  Robot robot;
  robot.instance.receive(5, label_of_map, 1.5, 1.6);
  ASSERT_EQ(robot.decide(FrameBuilder{}.robot(3), {}, map), -1);  // at 2 s
  ASSERT_EQ(robot.decide(FrameBuilder{}.robot(3).at(2, 0), {}, map), regista::own_reason(3));
  EXPECT_FALSE(takes_map(robot));
  ASSERT_EQ(robot.decide(FrameBuilder{}.robot(3).at(2, 0), {}, map), -1);
  ASSERT_EQ(robot.decide(FrameBuilder{}.robot(3).at(2, 0), {}, map), regista::own_reason(0));  // at 5 s
  EXPECT_TRUE(takes_map(robot));
  // With the new place of another moment, when maps may come again.
  robot.time = 20.0;
  ASSERT_EQ(robot.decide(FrameBuilder{}.robot(3).at(2, 0).previous(3, "striker"), {}, map), regista::own_reason(0));
  robot.time = 22.0;
  ASSERT_EQ(robot.decide(FrameBuilder{}.robot(3).at(2, 0).previous(3, "striker"), {}, map), regista::own_reason(1));
  EXPECT_FALSE(takes_map(robot));
  // What is repeated is not urgent.
  robot.time = 22.5;
  const std::vector<regista_offer> old_map{{map_offer, 8, REGISTA_MEDIUM_RADIO, 0.0, 99.0}};
  ASSERT_EQ(robot.decide(FrameBuilder{}.robot(3).at(2, 0), {{REGISTA_EVENT_BALL_MOVED, 0, 2.0}}, old_map),
            regista::own_reason(2));
  EXPECT_TRUE(takes_map(robot));
}

TEST(NaoDevilsSenderPlugin, WhatIsHeardTwiceOrTooLateCountsOnce) {
  const std::vector<std::uint8_t> label_of_chaser{1};
  Robot robot;
  for (int k = 0; k < 5; ++k) robot.instance.receive(5, label_of_chaser, 1.5, 1.6);
  robot.instance.receive(5, label_of_chaser, 1.4, 1.7);
  robot.instance.receive(6, label_of_chaser, 1.5, 1.7);
  robot.instance.receive(0, label_of_chaser, 1.5, 1.7);
  robot.instance.receive(8, label_of_chaser, 1.5, 1.7);
  EXPECT_EQ(robot.decide(FrameBuilder{}.robot(3).previous(3, "striker")), regista::own_reason(1));  // the third
  Robot other;
  for (const int number : {4, 5, 6}) other.instance.receive(number, label_of_chaser, 1.5, 1.6);
  EXPECT_EQ(other.decide(FrameBuilder{}.robot(3).previous(3, "striker")), -1);
}

std::vector<double> kept;  // outside of functions, so that no compiler leaves an allocation out

TEST(NaoDevilsSenderPlugin, NothingIsAllocated) {
  using namespace regista::testkit;
  std::map<std::string, RecordingHost::CallCosts> costs;
  Robot robot;
  robot.instance.host().costs = &costs;
  robot.instance.host().allocated = [] { return allocations; };  // but for the testkit's own
  const std::vector<regista_offer> offers{{map_offer, 8, REGISTA_MEDIUM_RADIO, 1.0, 999.0},
                                          {other_offer, 20, REGISTA_MEDIUM_RADIO, 0.4, 999.0}};
  std::map<int, int> sent;
  const std::size_t all = allocations_during([&] {
    kept = std::vector<double>(1000);
    for (int k = 0; k < 200; ++k) {
      robot.instance.receive(1 + k % 9, std::vector<std::uint8_t>{static_cast<std::uint8_t>(k % 4)}, robot.time,
                             robot.time + 0.1);
      FrameBuilder frame;
      frame.robot(3).at(0.2 * (k / 3 % 20), 0);
      if (k % 7 == 0) frame.previous(3, "striker");
      std::vector<regista_event> events;
      if (k % 5 == 0) events.push_back({REGISTA_EVENT_BALL_MOVED, 0, 2.0});
      ++sent[robot.decide(std::move(frame), events, k % 11 == 0 ? offers : std::vector<regista_offer>{})];
    }
  });
  EXPECT_GT(all, 0u);          // it does count
  EXPECT_GT(sent.size(), 3u);  // packets of several kinds, and silence
  EXPECT_EQ(costs["receive"].allocations, std::vector<std::size_t>(200, 0));
  const std::vector<std::size_t>& of_decisions = costs["decide"].allocations;
  EXPECT_EQ(of_decisions, std::vector<std::size_t>(of_decisions.size(), 0));
  EXPECT_GE(of_decisions.size(), 200u);
}

REGISTA_SENDER_CONTRACT(REGISTA_PLUGIN_FILE, "nao_devils_sender");

}  // namespace
