// SPDX-License-Identifier: MIT
// The plugin extrapolated_change on a testkit host: reasons, eyes, offers, silence.
#include <gtest/gtest.h>
#include <regista/testkit/count_allocations.hpp>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using namespace regista::testkit;
using namespace extrapolated_change;

const Loaded& plugin() {
  static const Loaded loaded(REGISTA_PLUGIN_FILE, "extrapolated_change");
  return loaded;
}

regista_budget plenty(double time, double last) {
  regista_budget budget{};
  budget.size = sizeof budget;
  budget.packets_left = 1200;
  budget.line = 1000;
  budget.match_time_left = 1000;
  budget.since_own = budget.since_team = time - last;
  budget.bytes_free = 61;
  budget.share = 1.0;
  return budget;
}

// The same plugin on a host that has no extensions.
const Loaded& plugin_that_is_told_nothing() {
  static const regista_descriptor alone = [] {
    regista_descriptor out = plugin().descriptor();
    out.create = [](const regista_environment* environment, const regista_host* host, regista_span values,
                    regista_error* error) {
      static regista_host without;  // lives as long as any instance
      without = *host;
      without.extension = [](void*, const char*) -> const void* { return nullptr; };
      return plugin().descriptor().create(environment, &without, values, error);
    };
    return out;
  }();
  static const Loaded loaded(alone);
  return loaded;
}

// Robot 3 with two mates near; the ball is in sight and known.
FrameBuilder quiet(double time) {
  FrameBuilder frame;
  frame.own(3).time(time).robot(3).at(0, 0).role("supporter").target(0, 0).robot(1).at(-2, 0).robot(5).at(0, 2);
  regista_game game{};
  game.size = sizeof game;
  game.phase = REGISTA_PHASE_PLAYING;
  game.half = 1;
  game.time_left = 300.0;
  frame.game(game).ball(2, 0).ball_age(0.0).common([](WorldBuilder& world) { world.ball_age(1.0); });
  return frame;
}

struct Robot {
  Instance sender;
  double last = 0.0;
  std::vector<regista_event> events;
  std::vector<regista_offer> offers;
  int left = 1200;
  explicit Robot(const Values& values = Values(plugin()), const Loaded& loaded = plugin())
      : sender(loaded, EnvironmentBuilder{}.own(3), values) {
    sender.host().sees_ball = true;
  }

  // Of the first packet within so many seconds after `from`: time and reason; reason -1: none.
  std::pair<double, int> first(double from, double seconds, const std::function<FrameBuilder(double)>& frame) {
    for (int tick = 0; tick < static_cast<int>(seconds * 10.0 + 0.5); ++tick) {
      const double time = from + 0.1 * tick;
      regista_budget budget = plenty(time, last);
      budget.packets_left = left;
      const Sent sent = sender.decide(frame(time).build(), events, offers, budget);
      if (sent.send == 0) continue;
      last = time;
      return {time, sent.reason};
    }
    return {-1.0, -1};
  }
};

TEST(ExtrapolatedChangePlugin, ReasonsHaveNames) {
  Robot robot;
  EXPECT_EQ(robot.first(10.0, 1.0, quiet).second, REGISTA_REASON_OWN);  // the first packet
  EXPECT_EQ(robot.first(10.1, 20.0, quiet).second, -1);
  const auto with = [](auto change) {
    return [change](double time) {
      FrameBuilder frame = quiet(time);
      change(frame);
      return frame;
    };
  };
  double time = 40.0;
  const auto reason = [&](auto change) {
    const auto [when, why] = robot.first(time, 5.0, with(change));
    time += 20.0;
    robot.first(time, 3.0, quiet);  // back again, and told
    time += 20.0;
    return why;
  };
  EXPECT_EQ(reason([](FrameBuilder& f) { f.robot(3).at(0.4, 0); }), REGISTA_EVENT_POSE_MOVED);
  EXPECT_EQ(reason([](FrameBuilder& f) { f.robot(3).fallen(3.0); }), REGISTA_EVENT_FELL);
  EXPECT_EQ(reason([](FrameBuilder& f) {
              f.robot(3).role("jolly").common([](WorldBuilder& w) { w.robot(3).role("supporter"); });
            }),
            REGISTA_EVENT_ROLE_CHANGED);
  EXPECT_EQ(reason([](FrameBuilder& f) { f.common([](WorldBuilder& w) { w.ball_age(10.6); }); }),
            REGISTA_REASON_OWN + 2);
  robot.sender.host().sees_ball = false;
  EXPECT_EQ(reason([](FrameBuilder&) {}), REGISTA_REASON_OWN + 1);
  robot.sender.host().sees_ball = true;
  EXPECT_EQ(reason([](FrameBuilder&) {}), REGISTA_REASON_OWN + 1);
  robot.sender.host().receiver = 5;
  EXPECT_EQ(reason([](FrameBuilder&) {}), REGISTA_REASON_OWN + 3);
  robot.sender.host().receiver = 0;
  EXPECT_EQ(reason([](FrameBuilder&) {}), REGISTA_REASON_OWN + 3);
  EXPECT_EQ(reason([](FrameBuilder& f) { f.ball(2, 0.7).common([](WorldBuilder& w) { w.ball(2, 0).ball_age(1.0); }); }),
            REGISTA_EVENT_BALL_MOVED);
}

// A ball that a teammate has just told of is as new as a seen one; only the host knows which it is.
TEST(ExtrapolatedChangePlugin, OnlyTheOwnEyesSee) {
  const auto told_now = [](double time) { return quiet(time).ball_age(0.0); };
  const auto reason = [&](Robot& robot) {
    robot.first(10.0, 1.0, told_now);
    robot.first(20.0, 5.0, told_now);
    robot.sender.host().sees_ball = !robot.sender.host().sees_ball;
    return robot.first(30.0, 8.0, told_now).second;
  };
  for (const bool sees : {true, false}) {
    Robot robot;
    robot.sender.host().sees_ball = sees;
    EXPECT_EQ(reason(robot), REGISTA_REASON_OWN + 1) << sees;
  }
  Robot told_nothing(Values(plugin()), plugin_that_is_told_nothing());
  EXPECT_EQ(reason(told_nothing), -1);
}

// Whom a kick is meant for must last as all causes must: 0.75 s with the ball 2 m away.
TEST(ExtrapolatedChangePlugin, APassIsTold) {
  for (const double lasts : {0.7, 0.9}) {
    Robot robot;
    robot.first(10.0, 1.0, quiet);
    robot.sender.host().receiver = 5;
    EXPECT_EQ(robot.first(20.0, lasts, quiet).second, lasts < 0.75 ? -1 : REGISTA_REASON_OWN + 3);
  }
}

// As it was before there was the extension: a ball is seen while it is new, and no pass is known.
TEST(ExtrapolatedChangePlugin, AHostThatTellsNothing) {
  Robot robot(Values(plugin()), plugin_that_is_told_nothing());
  robot.sender.host().sees_ball = false;
  EXPECT_EQ(robot.first(10.0, 1.0, quiet).second, REGISTA_REASON_OWN);
  robot.sender.host().receiver = 5;
  EXPECT_EQ(robot.first(10.1, 20.0, quiet).second, -1);
  EXPECT_EQ(robot.first(40.0, 8.0, [](double time) { return quiet(time).ball_age(3.2); }).second,
            REGISTA_REASON_OWN + 1);
  EXPECT_EQ(robot.first(60.0, 8.0, quiet).second, REGISTA_REASON_OWN + 1);
}

TEST(ExtrapolatedChangePlugin, ARollingBallIsWhereItComesToRest) {
  Robot robot;
  robot.first(10.0, 1.0, quiet);
  // It rolls towards where it was told: 0.8 m/s stop after 1 m.
  const auto rolling = [](double time) { return quiet(time).ball(1, 0).ball_velocity(0.8, 0); };
  EXPECT_EQ(robot.first(20.0, 5.0, rolling).second, -1);
  const auto elsewhere = [](double time) {
    return quiet(time).ball(2, 0).ball_velocity(0, 0.8).common(
        [](WorldBuilder& w) { w.ball(2, 0).ball_velocity(0, 0).ball_age(1.0); });
  };
  EXPECT_EQ(robot.first(30.0, 5.0, elsewhere).second, REGISTA_EVENT_BALL_MOVED);
}

TEST(ExtrapolatedChangePlugin, WalksAsItSaid) {
  Robot robot;
  const auto walking = [](double time) {
    const double x = std::min(3.0, 0.125 * (time - 10.0));  // half of what it says
    return quiet(time).robot(3).at(x, 0).velocity(0.25, 0).target(3, 0);
  };
  EXPECT_EQ(robot.first(10.0, 1.0, walking), (std::pair{10.0, int{REGISTA_REASON_OWN}}));
  EXPECT_EQ(robot.first(10.1, 60.0, walking).second, -1);
  robot.sender.reset(1);
  robot.last = 0.0;
  const auto faster = [](double time) {
    return quiet(time).robot(3).at(0.25 * (time - 10.0), 0).velocity(0.25, 0).target(3, 0);
  };
  robot.first(10.0, 1.0, faster);
  const auto [time, why] = robot.first(10.1, 20.0, faster);
  EXPECT_EQ(why, REGISTA_EVENT_POSE_MOVED);
  EXPECT_GT(time, 10.0 + 0.3 / 0.125);
  EXPECT_LT(time, 10.0 + 0.3 / 0.125 + 1.5);
}

// The same through the plugin, which reads clock and silence from what the host tells: two decisions a second, and
// always an urgent offer. What is left stays above the half's reserve, and is all spent but a few.
TEST(ExtrapolatedChangePlugin, AWholeMatch) {
  constexpr double period = 0.5;
  std::vector<std::unique_ptr<Instance>> team;
  for (int n = 1; n <= 7; ++n) {
    team.push_back(std::make_unique<Instance>(plugin(), EnvironmentBuilder{}.own(n).decision_period(period)));
  }
  std::vector<double> sent(7, 0.0);
  const std::vector<regista_offer> offers{{7, 20, REGISTA_MEDIUM_RADIO, 1.0, 1e9}};
  const Allowance allowance;
  int left = 1200;
  double time = 0.0, team_sent = 0.0, least_in_play = 1e9;
  for (const int half : {1, 2}) {
    for (double clock = -50.0; clock < 600.0; clock += period, time += period) {
      regista_game game{};
      game.size = sizeof game;
      game.phase = clock < 0.0 ? REGISTA_PHASE_READY : REGISTA_PHASE_PLAYING;
      game.half = half;
      game.time_left = 600.0 - std::max(0.0, clock);
      const int known_left = left;
      const double known_sent = team_sent;
      for (int n = 1; n <= 7; ++n) {
        double& own = sent[static_cast<std::size_t>(n - 1)];
        regista_budget budget = plenty(time, own);
        budget.packets_left = known_left;
        budget.since_team = time - known_sent;
        const Scene scene = FrameBuilder{}.own(n).time(time).robot(n).at(n, 0).game(game).no_ball().build();
        if (team[static_cast<std::size_t>(n - 1)]->decide(scene, {}, offers, budget).send == 0) continue;
        own = team_sent = time;
        --left;
      }
      const double line = allowance.line(share_left(allowance, {half, game.time_left}));
      if (clock > 100.0) least_in_play = std::min(least_in_play, left - line);
    }
    const double reserve = half == 1 ? 615.0 : 30.0;
    EXPECT_GE(left, reserve);
    EXPECT_LE(left, reserve + 12.0);
  }
  EXPECT_GE(least_in_play, -7.0);
}

// Half-way through the first half 907 packets should be left.
TEST(ExtrapolatedChangePlugin, SilencesBelowTheLine) {
  const auto sends = [](Instance& sender, double time, int left, double silent) {
    regista_budget budget = plenty(time, 0.0);
    budget.packets_left = left;
    budget.since_team = silent;
    return sender.decide(quiet(time).build(), {}, {}, budget).send == 1;
  };
  {  // 10 above the half's reserve for 300 s
    Instance sender(plugin(), EnvironmentBuilder{}.own(3));
    EXPECT_FALSE(sends(sender, 10.0, 625, 29.0));
    EXPECT_TRUE(sends(sender, 12.0, 625, 31.0));
  }
  {  // 57 below the line when the team's last packet was sent: 3.96 s
    Instance sender(plugin(), EnvironmentBuilder{}.own(3));
    EXPECT_FALSE(sends(sender, 10.0, 850, 1.0));
    EXPECT_FALSE(sends(sender, 10.1, 850, 0.1));
    EXPECT_FALSE(sends(sender, 13.9, 850, 3.9));
    EXPECT_TRUE(sends(sender, 14.6, 850, 4.6));
  }
}

TEST(ExtrapolatedChangePlugin, AShareOfAMatch) {
  // A tenth of a match: 120 packets and a reserve of 3. The line is the host's.
  for (const auto& [left, line, silent, sends] :
       {std::tuple{70, 60.0, 0.0, true}, {60, 60.0, 0.0, false}, {60, 60.0, 3.0, true}, {3, 60.0, 1000.0, false}}) {
    Instance sender(plugin(), EnvironmentBuilder{}.own(7).packets(128, 120));
    regista_budget budget = plenty(10.0, 0.0);
    budget.share = 0.1;
    budget.packets_left = left;
    budget.line = line;
    budget.match_time_left = 65.0;
    budget.since_team = silent;
    EXPECT_EQ(sender.decide(quiet(10.0).own(7).build(), {}, {}, budget).send == 1, sends) << left << ' ' << silent;
  }
}

TEST(ExtrapolatedChangePlugin, AWhistleBelowTheReserve) {
  for (const auto& [left, share, sends] :
       {std::tuple{16, 1.0, true}, {15, 1.0, false}, {2, 0.05, true}, {1, 0.05, false}}) {
    Robot robot;
    robot.events = {{REGISTA_EVENT_WHISTLE, 0, 0.0}};
    regista_budget budget = plenty(10.0, 0.0);
    budget.packets_left = left;
    budget.share = share;
    const Sent sent = robot.sender.decide(quiet(10.0).build(), robot.events, {}, budget);
    EXPECT_EQ(sent.send == 1, sends) << left << ' ' << share;
    if (sends) {
      EXPECT_EQ(sent.reason, REGISTA_EVENT_WHISTLE);
    }
  }
}

TEST(ExtrapolatedChangePlugin, OffersThatFitGoAlong) {
  Robot robot;
  robot.first(10.0, 1.0, quiet);
  robot.offers = {{7, 20, REGISTA_MEDIUM_RADIO, 0.5, 99.0}, {8, 61, REGISTA_MEDIUM_RADIO, 0.9, 99.0}};
  EXPECT_EQ(robot.first(20.0, 3.0, quiet).second, -1);
  robot.offers[1].urgency = 1.0;
  regista_budget budget = plenty(30.0, 10.0);
  const Sent sent = robot.sender.decide(quiet(30.0).build(), {}, robot.offers, budget);
  EXPECT_EQ(sent.reason, REGISTA_EVENT_OFFER);
  EXPECT_EQ(sent.granted, (std::vector<std::uint64_t>{8}));
  robot.offers[1].bytes = 62;
  EXPECT_EQ(robot.sender.decide(quiet(40.0).build(), {}, robot.offers, budget).send, 0);
}

TEST(ExtrapolatedChangePlugin, BeforeTheKickOff) {
  for (const bool before : {true, false}) {
    Robot robot(Values(plugin()).set("before_kick_off", before ? 1.0 : 0.0));
    const auto ready = [](double time) { return quiet(time).phase(REGISTA_PHASE_READY, 1.0); };
    EXPECT_EQ(robot.first(10.0, 5.0, ready).second >= 0, before);
  }
}

TEST(ExtrapolatedChangePlugin, SilentWhilePoorlyLocalised) {
  Robot robot;
  const auto lost = [](double time) {
    return quiet(time).mine([](WorldBuilder& world) {
      world.data().robots[2].covariance[0] = world.data().robots[2].covariance[2] = 0.6 * 0.6;
    });
  };
  EXPECT_EQ(robot.first(10.0, 5.0, lost).second, -1);
  EXPECT_EQ(robot.first(15.0, 5.0, quiet).first, 15.0);
}

std::vector<double> kept;  // outside of functions, so that no compiler leaves an allocation out

TEST(ExtrapolatedChangePlugin, NothingIsAllocated) {
  std::map<std::string, RecordingHost::CallCosts> costs;
  Robot robot;
  robot.sender.host().costs = &costs;
  robot.sender.host().allocated = [] { return allocations; };  // but for the testkit's own
  std::size_t sent = 0;
  const std::size_t all = allocations_during([&] {
    kept = std::vector<double>(1000);
    for (int k = 0; k < 100; ++k) {
      const double time = 10.0 + 2.0 * k;
      FrameBuilder frame = quiet(time);
      frame.robot(3).at(0.1 * (k % 20), 0);
      robot.sender.host().sees_ball = k % 3 != 0;
      robot.sender.host().receiver = k % 5;
      const std::vector<regista_offer> offers(static_cast<std::size_t>(k % 3), {1, 9, REGISTA_MEDIUM_RADIO, 1.0, 1e9});
      sent += robot.sender.decide(frame.build(), {}, offers, plenty(time, time - 5.0 * (k % 2))).send == 1 ? 1u : 0u;
    }
  });
  EXPECT_GT(all, 0u);  // it does count
  EXPECT_GT(sent, 20u);
  EXPECT_LT(sent, 80u);
  EXPECT_EQ(costs["decide"].allocations, std::vector<std::size_t>(100, 0));
}

REGISTA_SENDER_CONTRACT(REGISTA_PLUGIN_FILE, "extrapolated_change");

}  // namespace
