// SPDX-License-Identifier: MIT
// The walk against closed forms; the plugin by packets and frames; and a team whose roles change while it is silent,
// beside dead reckoning and holding.
#include "algorithm.hpp"

#include <gtest/gtest.h>

#include <random>
#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

namespace intent_aware {
namespace {

using namespace regista::testkit;
using Eigen::Vector2d;

Parameters usual() {
  Parameters p;
  p.walk_speed = 0.1;
  p.trusted_for = 10.0;
  p.fades_for = 20.0;
  return p;
}

Packet walking() {
  Packet packet;
  packet.position << 1.0, 1.0;
  packet.has_target = true;
  packet.target << 4.0, 5.0;  // 5 m away
  packet.covariance << 0.02, 0.01, 0.01, 0.03;
  packet.heading_variance = 0.05;
  return packet;
}

Answer to(int task, double x, double y, bool claimed = false) { return {task, true, {x, y}, claimed}; }

TEST(Walk, IsStraightAtItsSpeedUntilTheNewsAreOld) {
  const Teammate mate(3, walking(), 8.0, usual());
  EXPECT_NEAR((mate.position() - Vector2d(1.48, 1.64)).norm(), 0.0, 1e-12);  // 0.8 m on the way
  EXPECT_NEAR((mate.velocity() - Vector2d(0.06, 0.08)).norm(), 0.0, 1e-12);
}

// The way is the integral of the speed, which falls linearly from 10 to 30 s.
TEST(Walk, FadesToHolding) {
  for (const double age : {10.0, 12.0, 20.0, 29.0, 30.0, 31.0, 1000.0}) {
    double way = 0.0;
    const int parts = 100000;
    for (int i = 0; i < parts; ++i) {
      const double then = (i + 0.5) * age / parts;
      way += age / parts * 0.1 * (then < 10.0 ? 1.0 : std::max(0.0, 1.0 - (then - 10.0) / 20.0));
    }
    const Teammate mate(3, walking(), age, usual());
    EXPECT_NEAR((mate.position() - Vector2d(1.0, 1.0)).norm(), way, 1e-3) << age;
  }
  EXPECT_NEAR((Teammate(3, walking(), 20.0, usual()).velocity().norm()), 0.05, 1e-12);
  EXPECT_EQ(Teammate(3, walking(), 31.0, usual()).velocity(), Vector2d::Zero());
}

TEST(Walk, CountsTheAgeThatTheNewsHadWhenSent) {
  Packet old = walking();
  old.age = 40.0;
  EXPECT_EQ(Teammate(3, old, 5.0, usual()).position(), old.position);
  EXPECT_EQ(Teammate(3, old, 5.0, usual()).age(), 45.0);
}

TEST(Walk, DoesNotOvershoot) {
  Packet near = walking();
  near.target << 1.03, 1.04;
  for (const double ago : {0.5 + 1e-9, 3.0, 500.0}) {
    EXPECT_EQ(Teammate(3, near, ago, usual()).position(), near.target);
    EXPECT_EQ(Teammate(3, near, ago, usual()).velocity(), Vector2d::Zero());
  }
  near.has_target = false;
  EXPECT_EQ(Teammate(3, near, 3.0, usual()).position(), near.position);
}

TEST(Walk, IsTheSameInWhateverSteps) {
  for (const double time : {5.0, 17.0, 60.0}) {
    const Teammate once(3, walking(), time, usual());
    Teammate often(3, walking(), 0.0, usual());
    for (int i = 0; i < 1000; ++i) often.walk(time / 1000, 0.0);
    EXPECT_LT((once.position() - often.position()).norm(), 1e-9);
    EXPECT_LT((once.position_covariance() - often.position_covariance()).norm(), 1e-9);
  }
}

TEST(Walk, EndsAtOnceWithoutFading) {
  Parameters p = usual();
  p.fades_for = 0.0;
  EXPECT_NEAR((Teammate(3, walking(), 100.0, p).position() - Vector2d(1.0, 1.0)).norm(), 1.0, 1e-12);
  p.trusted_for = 0.0;
  EXPECT_EQ(Teammate(3, walking(), 100.0, p).position(), walking().position);
}

TEST(Uncertainty, GrowsWithTheSilence) {
  const Teammate mate(3, walking(), 4.0, usual());
  EXPECT_NEAR(mate.position_covariance()(0, 0), 0.02 + 0.16, 1e-12);
  EXPECT_NEAR(mate.cross(), 0.04, 1e-12);
  EXPECT_NEAR(mate.heading_variance(), 0.05 + 0.64, 1e-12);
}

TEST(Rule, CountsOnlyOnceItsAnswerHasChanged) {
  Teammate mate(3, walking(), 0.0, usual());
  for (int i = 0; i < 10; ++i) {
    mate.hear_rule(to(2, -4.0, 0.1 * i));
    mate.walk(0.1, 0.0);
  }
  EXPECT_NEAR((mate.position() - Vector2d(1.06, 1.08)).norm(), 0.0, 1e-12) << "on its way to the sent target";
  mate.hear_rule(to(5, -3.94, 1.08));
  mate.walk(1.0, 0.0);
  EXPECT_NEAR((mate.position() - Vector2d(0.96, 1.08)).norm(), 0.0, 1e-12) << "on its way to the new task";
  mate.hear_rule(to(2, 0.96, 4.08));
  mate.walk(1.0, 0.0);
  EXPECT_NEAR((mate.position() - Vector2d(0.96, 1.18)).norm(), 0.0, 1e-12) << "a second change, back to the old task";
}

TEST(Rule, WithATaskThatTheRobotClaimedIsFollowedWhenThePlaceMoves) {
  for (const bool claimed : {true, false}) {
    Teammate mate(3, walking(), 0.0, usual());
    mate.hear_rule(to(2, 4.0, 5.0, claimed));
    mate.hear_rule(to(2, 4.0, 5.4, claimed));
    EXPECT_EQ(mate.goal(), Vector2d(4.0, 5.0));
    mate.hear_rule(to(2, 4.0, 5.6, claimed));
    EXPECT_EQ(mate.goal(), claimed ? Vector2d(4.0, 5.6) : Vector2d(4.0, 5.0));
  }
}

TEST(Rule, WithoutATaskHoldsTheRobotAndAnUnknownPlaceChangesNothing) {
  Teammate mate(3, walking(), 1.0, usual());
  mate.hear_rule(to(2, 4.0, 5.0));
  mate.hear_rule({7, false, {}, false});
  EXPECT_EQ(mate.goal(), Vector2d(4.0, 5.0));
  mate.hear_rule({});
  mate.walk(5.0, 0.0);
  EXPECT_NEAR((mate.position() - Vector2d(1.06, 1.08)).norm(), 0.0, 1e-12);
}

TEST(Rule, LetsTheFallenWalkWhenTheyAreUp) {
  Teammate mate(3, walking(), 0.0, usual());
  mate.walk(2.0, 1.5);
  EXPECT_NEAR((mate.position() - walking().position).norm(), 0.05, 1e-12);
  mate.walk(2.0, 9.0);
  EXPECT_NEAR((mate.position() - walking().position).norm(), 0.05, 1e-12);
  EXPECT_EQ(mate.velocity(), Vector2d::Zero());
}

// --- The plugin

regista_track packet_of(int number, double x, double y, double target_x, double target_y, double speed = 0.2) {
  regista_track track{};
  track.label = number;
  track.flags = REGISTA_TRACK_HAS_TARGET | REGISTA_TRACK_VELOCITY;
  track.x = x;
  track.y = y;
  track.pose.target[0] = target_x;
  track.pose.target[1] = target_y;
  const double way = std::hypot(target_x - x, target_y - y);
  track.vx = way > 0.0 ? speed * (target_x - x) / way : 0.0;
  track.vy = way > 0.0 ? speed * (target_y - y) / way : 0.0;
  track.covariance[0] = track.covariance[2] = 0.01;
  track.pose.velocity_variance = 0.01;
  track.weight = 1.0;
  return track;
}

// A frame of robot 2 in which robot 5 had `task` before; the striker's place is (2, 1), the supporter's (-1, -1).
Scene frame(std::uint64_t tick, const char* task, int knowledge = REGISTA_COMMON, int phase = REGISTA_PHASE_PLAYING) {
  FrameBuilder builder;
  builder.own(2)
      .phase(phase)
      .tick(tick)
      .time(0.1 * static_cast<double>(tick))
      .knowledge(knowledge)
      .robot(2)
      .at(0, 0)
      .robot(5)
      .at(0, 0);
  builder.role("supporter").task("striker").at(3, 2).after(2, 1).task("supporter").at(-1, -1);
  return builder.previous(5, task).build();
}

EnvironmentBuilder teammates() { return EnvironmentBuilder{}.own(2).subject(REGISTA_SUBJECT_TEAMMATES); }

TEST(Plugin, FollowsTheAnswerThatChangedAfterThePacket) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "intent_aware");
  Instance instance(plugin, teammates());
  std::uint64_t tick = 0;
  const auto live = [&](const char* task, int times) {  // the track, if there is one
    for (int i = 0; i < times; ++i) {
      const Scene last = frame(tick++, task);
      instance.predict(0.1, nullptr, &last.raw());
    }
    const auto tracks = instance.tracks();
    return tracks.empty() ? regista_track{} : tracks.front();
  };
  instance.predict(0.1, nullptr, nullptr);
  live("goalkeeper", 3);
  instance.absorb(std::vector{packet_of(5, -2.0, -1.0, -1.0, -1.0)}, 0.0);
  // The frame of the next decision tells the answer of the one before, which did not know the packet.
  EXPECT_EQ(live("striker", 1).pose.target[0], -1.0);
  EXPECT_EQ(live("supporter", 5).pose.target[0], -1.0);
  const regista_track before = live("supporter", 1);
  EXPECT_NEAR(before.x, -2.0 + 0.7 * 0.125, 1e-12);
  EXPECT_EQ(before.y, -1.0);
  const regista_track after = live("striker", 1);
  EXPECT_EQ(after.pose.target[0], 2.0) << "the place after the offset";
  EXPECT_EQ(after.pose.target[1], 1.0);
  EXPECT_GT(after.y, before.y);
  EXPECT_NEAR(std::hypot(after.x - before.x, after.y - before.y), 0.0125, 1e-12);
  EXPECT_NEAR(after.age, 0.8, 1e-12);
  instance.absorb(std::vector{packet_of(5, 0.0, 0.0, 0.0, 1.0)}, 0.5);
  EXPECT_NEAR(instance.tracks().front().y, 0.0625, 1e-12) << "a new packet is believed";
}

TEST(Plugin, NobodyWalksInSet) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "intent_aware");
  Instance instance(plugin, teammates());
  instance.absorb(std::vector{packet_of(5, -2.0, -1.0, -1.0, -1.0)}, 0.0);
  const auto pass = [&](std::uint64_t tick, int phase) {
    const Scene last = frame(tick, "supporter", REGISTA_COMMON, phase);
    instance.predict(0.1, nullptr, &last.raw());
    return instance.tracks().front();
  };
  EXPECT_NEAR(pass(0, REGISTA_PHASE_READY).x, -2.0 + 0.0125, 1e-12);
  const regista_track stands = pass(1, REGISTA_PHASE_SET);
  EXPECT_NEAR(stands.x, -2.0 + 0.0125, 1e-12);
  EXPECT_EQ(stands.vx, 0.0);
  EXPECT_NEAR(stands.age, 0.2, 1e-12);
  EXPECT_NEAR(pass(2, REGISTA_PHASE_PLAYING).x, -2.0 + 0.025, 1e-12);
}

TEST(Plugin, LeavesPrivateAnswersAloneUnlessToldOtherwise) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "intent_aware");
  for (const bool only_common : {true, false}) {
    Instance instance(plugin, teammates(), Values(plugin).set("only_common", only_common ? 1.0 : 0.0));
    instance.absorb(std::vector{packet_of(5, -2.0, -1.0, -1.0, -1.0)}, 0.0);
    for (std::uint64_t tick = 0; tick < 10; ++tick) {
      const Scene last = frame(tick, tick < 5 ? "supporter" : "striker", REGISTA_MINE);
      instance.predict(0.1, nullptr, &last.raw());
    }
    EXPECT_EQ(instance.tracks().front().pose.target[0], only_common ? -1.0 : 2.0);
  }
}

// --- A silent team

struct Errors {
  double intent = 0.0, reckoning = 0.0, hold = 0.0;  // m, mean over games and time
};

// Robot 5 says where it walks and falls silent for 20 s; 1 to 5 s later the rule gives it another task. It walks there
// at its own speed, unless it does not follow the rule and goes on to the target it sent, or stands all the time.
enum class Truth { follows_rule, keeps_target, stands };

Errors silent_robot(Truth truth) {
  const Loaded intent_plugin(REGISTA_PLUGIN_FILE, "intent_aware"), plain(DEAD_RECKONING_FILE, "dead_reckoning");
  std::mt19937_64 random(17);
  const auto uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Errors sum;
  constexpr int games = 40, ticks = 200;
  for (int game = 0; game < games; ++game) {
    Instance intent(intent_plugin, teammates()), reckoning(plain, teammates());
    Instance hold(plain, teammates(), Values(plain).set("speed_factor", 0.0));
    const double x0 = uniform(-4.0, 4.0), y0 = uniform(-2.5, 2.5);
    const double old_x = uniform(-4.0, 4.0), old_y = uniform(-2.5, 2.5);
    const double new_x = uniform(-4.0, 4.0), new_y = uniform(-2.5, 2.5);
    const double speed = uniform(0.1, 0.25);
    const int changes = static_cast<int>(uniform(10.0, 50.0));
    double x = x0, y = y0;
    const auto scene = [&](int tick, const char* task) {
      FrameBuilder builder;
      builder.own(2).tick(static_cast<std::uint64_t>(tick)).knowledge(REGISTA_COMMON).robot(2).robot(5);
      builder.role("supporter").task("striker").at(new_x, new_y).task("supporter").at(old_x, old_y);
      return builder.previous(5, task).build();
    };
    const Scene before = scene(0, "supporter");
    intent.predict(0.1, nullptr, &before.raw());
    const std::vector packet{packet_of(5, x0, y0, old_x, old_y, speed)};
    for (Instance* each : {&intent, &reckoning, &hold}) each->absorb(packet, 0.0);
    for (int tick = 1; tick <= ticks; ++tick) {
      const bool changed = truth == Truth::follows_rule && tick >= changes;
      const double dx = (changed ? new_x : old_x) - x, dy = (changed ? new_y : old_y) - y, way = std::hypot(dx, dy);
      const double step = std::min(way, 0.1 * speed);
      if (way > 0.0 && truth != Truth::stands) {
        x += step * dx / way;
        y += step * dy / way;
      }
      const Scene last = scene(tick, tick >= changes ? "striker" : "supporter");
      const auto error = [&](Instance& each) {
        each.predict(0.1, nullptr, &last.raw());
        const regista_track track = each.tracks().front();
        return std::hypot(track.x - x, track.y - y);
      };
      const double of_intent = error(intent), of_reckoning = error(reckoning), of_hold = error(hold);
      EXPECT_LE(of_intent, of_hold + 0.125 * 0.1 * tick + 1e-9) << "it cannot have gone farther";
      sum.intent += of_intent / (games * ticks);
      sum.reckoning += of_reckoning / (games * ticks);
      sum.hold += of_hold / (games * ticks);
    }
  }
  const char* const name = truth == Truth::follows_rule   ? "right"
                           : truth == Truth::keeps_target ? "wrong, target kept"
                                                          : "wrong, standing";
  std::printf("rule %s: mean error of intent_aware %.3f m, dead_reckoning %.3f m, hold last %.3f m\n", name, sum.intent,
              sum.reckoning, sum.hold);
  return sum;
}

TEST(SilentTeam, IsFollowedBestWhenTheRuleIsRight) {
  const Errors errors = silent_robot(Truth::follows_rule);
  EXPECT_LT(errors.intent, 0.6 * errors.reckoning);
  EXPECT_LT(errors.intent, 0.6 * errors.hold);
}

// By no more, on average over the time, than the way that it was taken to walk.
TEST(SilentTeam, IsNotMuchWorseThanHeldWhenTheRuleIsWrong) {
  double bound = 0.0;
  for (int tick = 1; tick <= 200; ++tick) bound += 0.125 / 200 * full_seconds(0.0, 0.1 * tick, usual());
  const Errors kept = silent_robot(Truth::keeps_target), stands = silent_robot(Truth::stands);
  EXPECT_LT(kept.intent, kept.hold + 0.5 * bound);
  EXPECT_LE(stands.intent, stands.hold + bound + 1e-9);
}

}  // namespace
}  // namespace intent_aware

REGISTA_PREDICTOR_CONTRACT(REGISTA_PLUGIN_FILE, "intent_aware");
