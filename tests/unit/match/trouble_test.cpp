// SPDX-License-Identifier: MIT
// Troubles against the laws they are declared by, and against what a match would be without them.
#include "match/disturbances.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <vector>

#include "match/digest.hpp"
#include "match/physics_world.hpp"
#include "match/radio.hpp"
#include "scripted.hpp"

namespace regista::match {
namespace {

using config::Disturbance;
using config::Incident;
using Kind = Incident::Kind;
using scripted::chasers;
using scripted::statues;

Incident incident(Kind kind, double at, std::vector<int> robots = {}) {
  Incident out;
  out.kind = kind;
  out.at = {at};
  if (!robots.empty()) out.robots = {Incident::Whom::Choice::listed, std::move(robots)};
  return out;
}

// The channel of Gilbert and Elliott as a receiver feels it: packets 20 ms apart, for 6 hours.
TEST(BurstLoss, HasTheShareAndTheLengthsOfItsLaw) {
  Disturbance disturbance;
  disturbance.radio.burst = {4.5, 3.0, 1.0};
  Disturbances trouble(disturbance, {}, 2, 1, Side::home);
  Radio radio({0.0, 0.0, 0.0}, trouble, 2, 1, Side::home);
  constexpr double hours = 6.0;
  constexpr auto ticks = static_cast<std::uint32_t>(hours * 3600.0 / physics_step);
  std::vector<mind::HeardPacket> heard;
  const std::vector<std::uint8_t> packet{1};
  int lost = 0, bursts = 0, long_bursts = 0, run = 0;
  for (std::uint32_t tick = 0; tick < ticks; ++tick) {
    const double time = tick * physics_step;
    trouble.update(time);
    radio.send(1, packet, time, tick);
    heard.clear();
    radio.deliver(2, time + physics_step, tick + 1, heard);
    if (heard.empty()) {
      ++lost, ++run;
    } else if (run > 0) {
      ++bursts;
      if (run * physics_step > 3.0) ++long_bursts;
      run = 0;
    }
  }
  // Of a two-state process with these mean times: share p = 0.4, correlation time 1 / (1/4.5 + 1/3) = 1.8 s, so the
  // variance of the share is 2 p (1 - p) 1.8 s / T; the lengths are exponential. Four standard deviations.
  const double length = hours * 3600.0, expected_bursts = length / 7.5;
  EXPECT_NEAR(lost / double(ticks), 0.4, 4.0 * std::sqrt(2.0 * 0.4 * 0.6 * 1.8 / length));
  EXPECT_NEAR(lost * physics_step / bursts, 3.0, 4.0 * 3.0 / std::sqrt(expected_bursts) + physics_step);
  const double e = std::exp(-1.0);
  EXPECT_NEAR(long_bursts / double(bursts), e, 4.0 * std::sqrt(e * (1.0 - e) / expected_bursts) + 0.01);
}

TEST(BurstLoss, LosesItsShareWithinABurst) {
  Disturbance disturbance;
  disturbance.radio.burst = {0.01, 1e6, 0.3};  // always within one
  Disturbances trouble(disturbance, {}, 3, 1, Side::home);
  Radio radio({0.0, 0.0, 0.0}, trouble, 3, 1, Side::home);
  std::vector<mind::HeardPacket> heard;
  const std::vector<std::uint8_t> packet{1};
  int arrived = 0;
  for (std::uint32_t tick = 1; tick <= 20000; ++tick) {
    trouble.update(tick * physics_step);
    radio.send(1, packet, tick * physics_step, tick);
    radio.deliver(2, (tick + 1) * physics_step, tick + 1, heard);
    heard.clear();
    radio.deliver(3, (tick + 1) * physics_step, tick + 1, heard);
    arrived += static_cast<int>(heard.size());
  }
  EXPECT_NEAR(arrived / 20000.0, 0.7, 4.0 * std::sqrt(0.3 * 0.7 / 20000.0));
}

// Every beginning of an incident that strikes one robot at random.
TEST(AtRandom, IsAPoissonProcessThatStrikesAllAlike) {
  Disturbance disturbance;
  Incident blind;
  blind.kind = Kind::blind_camera;
  blind.robots.choice = Incident::Whom::Choice::any;
  blind.per_hour = 360.0;
  blind.duration = 0.1;
  disturbance.incidents = {blind};
  Disturbances trouble(disturbance, {}, 5, 7, Side::away);
  std::vector<double> times;
  std::vector<int> struck(5);
  for (std::uint32_t tick = 0; tick < 100u * 3600u * 50u; ++tick) {
    const double time = tick * physics_step;
    if (!trouble.update(time)) continue;
    for (int number = 1; number <= 5; ++number) {
      if (!trouble.of(number).blind) continue;
      if (!times.empty() && time - times.back() < 0.15) continue;  // the same, or one right upon it
      times.push_back(time);
      ++struck[static_cast<std::size_t>(number - 1)];
    }
  }
  const double count = static_cast<double>(times.size());
  EXPECT_NEAR(count, 36000.0 * std::exp(-0.015), 4.0 * std::sqrt(36000.0));
  int later_than_mean = 0;
  for (std::size_t i = 1; i < times.size(); ++i) later_than_mean += times[i] - times[i - 1] > 10.0 ? 1 : 0;
  const double e = std::exp(-1.0) * std::exp(0.015);  // given that it is later than 0.15 s
  EXPECT_NEAR(later_than_mean / count, e, 4.0 * std::sqrt(e * (1.0 - e) / count));
  for (const int each : struck) EXPECT_NEAR(each, count / 5.0, 4.0 * std::sqrt(count * 0.16));
}

TEST(AtItsTime, BeginsAndEnds) {
  Disturbance disturbance;
  disturbance.incidents = {incident(Kind::crash, 1.0, {2}), incident(Kind::slow_robot, 0.0)};
  disturbance.incidents[0].at = {1.0, 5.0};
  disturbance.incidents[0].duration = 2.0;
  disturbance.incidents[1].speed = 0.5;
  Disturbances trouble(disturbance, {}, 3, 1, Side::home);
  for (std::uint32_t tick = 0; tick <= 500; ++tick) {
    trouble.update(tick * physics_step);
    const bool during = (tick >= 50 && tick < 150) || (tick >= 250 && tick < 350);
    ASSERT_EQ(trouble.of(2).crashed, during) << tick;
    ASSERT_FALSE(trouble.of(1).crashed || trouble.of(3).crashed);
    ASSERT_EQ(trouble.of(3).speed, 0.5);
  }
}

TEST(Silence, IsTotalForWhomItStrikes) {
  Disturbance disturbance;
  disturbance.incidents = {incident(Kind::radio_silence, 0.0, {2})};
  Disturbances trouble(disturbance, {}, 3, 1, Side::home);
  trouble.update(0.0);
  Radio radio({0.0, 0.0, 0.0}, trouble, 3, 1, Side::home);
  std::vector<mind::HeardPacket> heard;
  for (int sender = 1; sender <= 3; ++sender) {
    radio.send(sender, std::vector<std::uint8_t>{static_cast<std::uint8_t>(sender)}, 0.0, 0);
  }
  radio.deliver(1, 1.0, 50, heard);
  ASSERT_EQ(heard.size(), 1u);
  EXPECT_EQ(heard[0].bytes[0], 3);
  heard.clear();
  radio.deliver(2, 1.0, 50, heard);
  EXPECT_TRUE(heard.empty());
  radio.deliver(3, 1.0, 50, heard);
  ASSERT_EQ(heard.size(), 1u);
  EXPECT_EQ(heard[0].bytes[0], 1);
}

TEST(Silence, ReachesWhatIsUnderWay) {
  Disturbance disturbance;
  disturbance.incidents = {incident(Kind::radio_silence, 1.0, {2})};
  disturbance.incidents[0].duration = 5.0;
  Disturbances trouble(disturbance, {}, 3, 1, Side::home);
  trouble.update(0.0);
  Radio radio({2.0, 0.0, 0.0}, trouble, 3, 1, Side::home);
  radio.send(1, std::vector<std::uint8_t>{1}, 0.0, 0);
  trouble.update(1.0);
  std::vector<mind::HeardPacket> heard;
  radio.deliver(2, 3.0, 150, heard);
  EXPECT_TRUE(heard.empty()) << "silent when it arrives";
  radio.deliver(3, 3.0, 150, heard);
  EXPECT_EQ(heard.size(), 1u);
  heard.clear();
  trouble.update(6.0);
  radio.deliver(2, 7.0, 350, heard);
  EXPECT_TRUE(heard.empty()) << "what has passed by does not come again";
  radio.send(1, std::vector<std::uint8_t>{2}, 7.0, 350);
  radio.deliver(2, 9.1, 455, heard);
  ASSERT_EQ(heard.size(), 1u);
  EXPECT_EQ(heard[0].bytes[0], 2);
}

TEST(Ghosts, MoreThanARobotCanSeeAreRefused) {
  Disturbance disturbance;
  for (int i = 0; i < config::most_ghost_balls; ++i) {
    disturbance.incidents.push_back(incident(Kind::ghost_ball, 1.0, {2}));
  }
  disturbance.incidents.push_back(incident(Kind::ghost_ball, 1.0, {3}));
  EXPECT_NO_THROW(config::check(disturbance, config::Rules{}, {}));
  disturbance.incidents.push_back(incident(Kind::ghost_ball, 1.0));
  EXPECT_THROW(config::check(disturbance, config::Rules{}, {}), config::Error);
}

TEST(DelayAndJitter, CountOnceForAPacketBetweenTwoThatSuffer) {
  Disturbance disturbance;
  disturbance.incidents = {incident(Kind::radio_delay, 0.0, {1, 2}), incident(Kind::radio_jitter, 0.0, {2})};
  disturbance.incidents[0].delay = 1.0;
  disturbance.incidents[1].jitter = 0.5;
  Disturbances trouble(disturbance, {}, 3, 1, Side::home);
  trouble.update(0.0);
  Radio radio({0.1, 0.0, 0.0}, trouble, 3, 1, Side::home);
  std::vector<mind::HeardPacket> heard;
  std::map<int, double> least, most;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const std::uint32_t tick = 200 * i;
    radio.send(1, std::vector<std::uint8_t>{1}, tick * physics_step, tick);
    for (const int receiver : {2, 3}) {
      heard.clear();
      radio.deliver(receiver, tick * physics_step + 3.0, tick + 150, heard);
      ASSERT_EQ(heard.size(), 1u);
      const double late = heard[0].time_heard - tick * physics_step;
      least.try_emplace(receiver, late).first->second = std::min(least.try_emplace(receiver, late).first->second, late);
      most.try_emplace(receiver, late).first->second = std::max(most.try_emplace(receiver, late).first->second, late);
    }
  }
  EXPECT_NEAR(least[3], 1.1, 1e-9);
  EXPECT_NEAR(most[3], 1.1, 1e-9);
  EXPECT_NEAR(least[2], 1.1, 0.002);
  EXPECT_NEAR(most[2], 1.6, 0.002);
}

// --- In a match ------------------------------------------------------------------------------------------------------

// All that reaches the robots of a side, as one number.
std::uint64_t percepts_of(Side side, const Setup& setup, std::span<const mind::Think> home,
                          std::span<const mind::Think> away) {
  Digest digest;
  Observer observer;
  observer.decision = [&](const Decision& decision) {
    if (decision.side != side) return;
    digest.add(decision.number);
    const mind::Pose& odometry = decision.percepts.odometry;
    const std::array values{decision.time, odometry.x, odometry.y, odometry.heading};
    digest.add(std::as_bytes(std::span(values)));
    for (const mind::BallSighting& ball : decision.percepts.balls)
      digest.add(std::as_bytes(std::span(ball.position.data(), 2)));
    for (const auto& robot : decision.percepts.robots) digest.add(std::as_bytes(std::span(robot.position.data(), 2)));
    for (const auto& landmark : decision.percepts.landmarks)
      digest.add(std::as_bytes(std::span(landmark.position.data(), 2)));
    for (const mind::HeardPacket& heard : decision.heard) digest.add(std::as_bytes(heard.bytes));
  };
  play(setup, home, away, &observer);
  return digest.value();
}

Setup with_all_troubles_of_home(double at) {
  match::Setup setup = scripted::setup(11, 5);
  setup.limit = 90.0;
  Disturbance& disturbance = setup.disturbances[0];
  for (std::size_t kind = 0; kind < config::incident_kinds().size(); ++kind) {
    disturbance.incidents.push_back(incident(static_cast<Kind>(kind), at));
    Incident& last = disturbance.incidents.back();
    last.duration = 20.0;
    if (last.kind == Kind::pose_bias) last.x = 1.0, last.heading = 0.2;
    if (last.kind == Kind::radio_delay) last.delay = 1.0;
    if (last.kind == Kind::radio_jitter) last.jitter = 1.0;
    if (last.kind == Kind::slow_robot) last.speed = 0.5;
  }
  return setup;
}

TEST(Luck, OfASideDoesNotHangOnTheTroublesOfTheOther) {
  match::Setup setup = with_all_troubles_of_home(5.0);
  setup.disturbances[0].radio.loss = 0.5;
  setup.disturbances[0].camera = {0.5, 1.0};
  // A crash can be seen: the referee takes the robot out.
  std::erase_if(setup.disturbances[0].incidents, [](const Incident& each) { return each.kind == Kind::crash; });
  match::Setup undisturbed = setup;
  undisturbed.disturbances[0] = {};
  // Home stands still, so that what befalls it has no way to the others but through chance.
  const auto home = statues(5);
  EXPECT_EQ(percepts_of(Side::away, setup, home, chasers(5, 10)),
            percepts_of(Side::away, undisturbed, home, chasers(5, 10)));
  EXPECT_NE(percepts_of(Side::home, setup, home, chasers(5, 10)),
            percepts_of(Side::home, undisturbed, home, chasers(5, 10)));
}

TEST(Off, IsTheSameMatchToTheLastByte) {
  match::Setup none = scripted::setup(11, 5);
  none.limit = 90.0;
  const std::uint64_t hash = play(none, chasers(5, 10), chasers(5, 10)).hash;
  match::Setup later = with_all_troubles_of_home(90.0);  // when it is over
  later.disturbances[1] = later.disturbances[0];
  later.disturbances[0].radio.burst = {1.0, 1.0, 0.0};
  Incident never = incident(Kind::crash, 0.0);
  never.at.clear();
  never.per_hour = 0.0;
  later.disturbances[0].incidents.push_back(never);
  EXPECT_EQ(play(later, chasers(5, 10), chasers(5, 10)).hash, hash);
  match::Setup disturbed = with_all_troubles_of_home(5.0);
  EXPECT_NE(play(disturbed, chasers(5, 10), chasers(5, 10)).hash, hash);
}

TEST(Off, NobodyStrikesARobotThatIsNotThere) {
  match::Setup setup = scripted::setup(1, 3);
  setup.disturbances[1].incidents = {incident(Kind::crash, 0.0, {4})};
  EXPECT_THROW(play(setup, statues(3), statues(3)), std::exception);
}

// A robot that walks in circles, sending; what it does in a match, second by second.
mind::Think walker() {
  return [](const mind::Percepts& percepts, std::span<const mind::HeardPacket>, mind::Outcome& out) {
    out.command.walk = {0.2, 0.0, percepts.penalised ? 0.0 : 0.5};
    out.send = true;
    out.packet.assign(8, 1);
  };
}

Setup in_play(int team_size) {
  match::Setup setup = scripted::setup(1, team_size);
  config::Opening opening;
  opening.name = "apart";
  opening.ball.at = {0.0, 2.5};
  for (int i = 0; i < team_size; ++i) {
    opening.home.push_back({{-3.0, -2.0 + i}, {}});
    opening.away.push_back({{3.0, -2.0 + i}, {}});
  }
  setup.opening = opening;
  setup.limit = 60.0;
  for (auto& robot : setup.robots) robot.body.falls_per_contact_second = 0.0;
  return setup;
}

TEST(Crash, NothingIsDecidedSentOrHeardUntilItsEnd) {
  match::Setup setup = in_play(2);
  setup.limit = 9.0;  // less than it takes to be penalised for being inactive
  setup.disturbances[0].incidents = {incident(Kind::crash, 2.0, {1})};
  setup.disturbances[0].incidents[0].duration = 4.0;
  Observer observer;
  std::map<int, int> during, after;
  int heard_early = 0;
  double moved = 0.0, turning = 0.0;
  observer.decision = [&](const Decision& decision) {
    if (decision.side != Side::home) return;
    if (decision.time >= 2.0 - 1e-9 && decision.time < 6.0 - 1e-9) ++during[decision.number];
    if (decision.time >= 6.0 - 1e-9) {
      ++after[decision.number];
      for (const auto& packet : decision.heard) heard_early += packet.time_heard < 5.9 ? 1 : 0;
    }
  };
  BodyState last{};
  observer.step = [&](const Snapshot& now) {
    if (now.time > 3.0 && now.time < 6.0) {
      moved += std::hypot(now.bodies[0].x - last.x, now.bodies[0].y - last.y);
      turning += std::fabs(now.bodies[0].heading - last.heading);
    }
    last = now.bodies[0];
  };
  const std::vector<mind::Think> minds(2, walker());
  play(setup, minds, statues(2), &observer);
  EXPECT_EQ(during[1], 0);
  EXPECT_EQ(during[2], 40);
  EXPECT_EQ(after[1], 30);
  EXPECT_EQ(heard_early, 0);
  EXPECT_EQ(moved, 0.0) << "after its acceleration has brought it to rest";
  EXPECT_EQ(turning, 0.0);
}

TEST(Crash, IsPenalisedAsInactiveAndComesBack) {
  match::Setup setup = in_play(2);
  setup.limit = 150.0;
  setup.disturbances[0].incidents = {incident(Kind::crash, 2.0, {2})};
  setup.disturbances[0].incidents[0].duration = 60.0;
  std::vector<double> penalties;
  int late_decisions = 0;
  Observer observer;
  observer.event = [&](double time, const Event& event, const GameState&) {
    if (event.kind != EventKind::penalty || event.side != Side::home || event.number != 2) return;
    if (penalties.empty()) {
      EXPECT_EQ(event.offence, Offence::inactive);
    }
    penalties.push_back(time);
  };
  observer.decision = [&](const Decision& decision) {
    if (decision.side == Side::home && decision.number == 2 && decision.time > 130.0) ++late_decisions;
  };
  const std::vector<mind::Think> minds(2, walker());
  play(setup, minds, statues(2), &observer);
  ASSERT_FALSE(penalties.empty());
  EXPECT_NEAR(penalties.front(), 2.0 + setup.rules.offences.inactive, 1.5);
  EXPECT_EQ(late_decisions, 200);
}

double distance_walked(double speed) {
  match::Setup setup = in_play(1);
  if (speed < 1.0) {
    setup.disturbances[0].incidents = {incident(Kind::slow_robot, 0.0)};
    setup.disturbances[0].incidents[0].speed = speed;
  }
  double walked = 0.0;
  BodyState last{};
  Observer observer;
  observer.step = [&](const Snapshot& now) {
    if (now.time > 1.0) walked += std::hypot(now.bodies[0].x - last.x, now.bodies[0].y - last.y);
    last = now.bodies[0];
  };
  const std::vector<mind::Think> minds(1, walker());
  play(setup, minds, statues(1), &observer);
  return walked;
}

TEST(SlowRobot, WalksThePartOfTheWayThatItsFactorSays) {
  const double whole = distance_walked(1.0);
  EXPECT_GT(whole, 10.0);
  for (const double speed : {0.25, 0.5, 0.9}) EXPECT_NEAR(distance_walked(speed) / whole, speed, 0.01);
}

}  // namespace
}  // namespace regista::match
