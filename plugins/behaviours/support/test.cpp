// SPDX-License-Identifier: MIT
// Receiving a ball that comes along, against a ball that rolls step by step; and walking to the place of the task.
#include <gtest/gtest.h>

#include <regista/testkit/dice.hpp>

#include "../supporting.hpp"
#include "../test_conduct.hpp"
#include "../test_situations.hpp"

namespace {

using namespace behaviours;

constexpr RollingSettings rolling;

// A ball of 1 m/s rolls 1 / (2 * 0.32) = 1.5625 m: from (-2, 1) to (-0.4375, 1).
TEST(Interception, TheNearestPointOfTheBallsWay) {
  const auto from = [](double x, double y) {
    return interception(with_ball(standing(x, y), {-2, 1}, {1, 0}), rolling, 1.0);
  };
  ASSERT_TRUE(from(-1, 0.5));
  EXPECT_NEAR((*from(-1, 0.5) - Vector2d(-1, 1)).norm(), 0.0, 1e-12);
  ASSERT_TRUE(from(0, 1)) << "where it comes to rest";
  EXPECT_NEAR((*from(0, 1) - Vector2d(-0.4375, 1)).norm(), 0.0, 1e-12);
  EXPECT_FALSE(from(-3, 1)) << "it leaves";
  EXPECT_FALSE(from(-2, 0.5)) << "it has passed";
  EXPECT_TRUE(from(-1, 0.01));
  EXPECT_FALSE(from(-1, -0.01)) << "too far away";
}

TEST(Interception, NotOfABallThatLiesOrIsLost) {
  EXPECT_TRUE(interception(with_ball(standing(-1.95, 1), {-2, 1}, {0.26, 0}), rolling, 1.0));
  EXPECT_FALSE(interception(with_ball(standing(-1.95, 1), {-2, 1}, {0.24, 0}), rolling, 1.0));
  Situation lost = with_ball(standing(-1, 0.5), {-2, 1}, {1, 0});
  lost.ball_trusted = false;
  EXPECT_FALSE(interception(lost, rolling, 1.0));
}

// Truth: the ball rolls on in steps of a millisecond and loses 0.32 m/s in each second.
TEST(Interception, AsOfABallThatRollsStepByStep) {
  regista::testkit::Dice dice(5);
  int met = 0, missed = 0;
  for (int round = 0; round < 200; ++round) {
    const double x = dice.real(-3, 3), y = dice.real(-2, 2), vx = dice.real(-1.5, 1.5), vy = dice.real(-1.5, 1.5);
    const double bx = x + dice.real(-2, 2), by = y + dice.real(-2, 2);
    const Vector2d own(x, y), ball(bx, by), velocity(vx, vy);
    if (velocity.norm() < rolling.rolling) continue;
    Vector2d at = ball, nearest = ball;
    for (double speed = velocity.norm(); speed > 0.0; speed -= 0.32e-3) {
      at += velocity.normalized() * (speed * 1e-3);
      if ((at - own).norm() < (nearest - own).norm()) nearest = at;
    }
    const auto point = interception(with_ball(standing(x, y), ball, velocity), rolling, 1.0);
    const double distance = (nearest - own).norm(), along = (nearest - ball).norm();
    if (std::abs(distance - 1.0) < 0.01 || (along < 0.01 && along > 0.0)) continue;  // too close to call
    EXPECT_EQ(point.has_value(), distance < 1.0 && along > 0.0) << "round " << round;
    if (point) {
      EXPECT_NEAR((*point - nearest).norm(), 0.0, 0.01) << "round " << round;
    }
    ++(point ? met : missed);
  }
  EXPECT_GT(met, 20);
  EXPECT_GT(missed, 20);
}

TEST(Support, ReceivesUnlessTheBallIsTheOpponents) {
  SupportMemory memory;
  const Situation pass = with_ball(standing(-1, 0.5), {-2, 1}, {1, 0});
  const auto walk = std::get<WalkTo>(support(pass, {}, rolling, {}, {}, memory));
  EXPECT_NEAR(walk.target.y, 1.0, 1e-12);
  EXPECT_NEAR(walk.target.heading, std::atan2(0.5, -1.0), 1e-12);
  EXPECT_TRUE(walk.brisk);
  EXPECT_FALSE(walk.straight);
  const auto forbidden =
      std::get<WalkTo>(support(in_set_play(pass, SetPlay::kick_in, false), {}, rolling, {}, {}, memory));
  EXPECT_FALSE(forbidden.brisk);
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

// From the corner of an L to the other end of it, along the edges only where the team wants it.
TEST(SupportPlugin, WalksAlongEdgesWhereTheTeamWantsIt) {
  Instance behaviour(Loaded(REGISTA_PLUGIN_FILE, "support"), EnvironmentBuilder{}.own(4));
  const FrameBuilder straight = FrameBuilder{}
                                    .own(4)
                                    .robot(4)
                                    .no_ball()
                                    .waypoint(-3, -2)
                                    .waypoint(-3, 2)
                                    .waypoint(3, 2)
                                    .edge(0, 1)
                                    .edge(1, 2)
                                    .task("supporter")
                                    .at(3.2, 2.2)
                                    .heading(0.4);
  const BodyBuilder body = BodyBuilder{}.at(-3, -1.9).task(0);
  const regista_action direct = behaviour.act(straight.build(), body);
  EXPECT_EQ(direct.pose[0], 3.2);
  EXPECT_EQ(direct.pose[1], 2.2);
  const regista_action along = behaviour.act(FrameBuilder(straight).along_edges().build(), body);
  EXPECT_EQ(along.motion, REGISTA_MOTION_WALK_TO);
  EXPECT_EQ(along.walk, 0u);
  EXPECT_EQ(along.pose[0], -3.0);
  EXPECT_EQ(along.pose[1], 2.0);
  EXPECT_EQ(along.pose[2], 0.4) << "facing as the task asks";
}

// A ball beside it, and a teammate far away.
TEST(SupportPlugin, TakesABallWhoseFirstItSurelyIsAndSaysSo) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "support");
  const FrameBuilder base =
      FrameBuilder{}.own(4).robot(4).robot(2).at(2, 2).age(0.2).ball(0, 0).task("supporter").at(-2, 1);
  const BodyBuilder near = BodyBuilder{}.at(-0.2, 0).task(0).sees_ball();
  Instance by_role(plugin, EnvironmentBuilder{}.own(4));
  EXPECT_EQ(by_role.act(base.build(), near).kick, REGISTA_NO_KICK);
  EXPECT_EQ(by_role.act(base.build(), near).flags, 0u);
  Instance claims(plugin, EnvironmentBuilder{}.own(4), Values(plugin).set("nearest_plays", 1));
  const regista_action takes = claims.act(base.build(), near);
  EXPECT_NE(takes.kick, REGISTA_NO_KICK);
  EXPECT_EQ(takes.flags, std::uint32_t{REGISTA_ACTION_TARGET});
  EXPECT_EQ(takes.target[0], 0.0);
  EXPECT_EQ(takes.target[1], 0.0);
  EXPECT_EQ(claims.act(base.build(), BodyBuilder(near).kicking()).flags, std::uint32_t{REGISTA_ACTION_TARGET})
      << "its own while it kicks";
  const Scene theirs = FrameBuilder(base).set_play(REGISTA_SET_PLAY_KICK_IN, false).build();
  EXPECT_EQ(claims.act(theirs, near).flags, 0u);
  Instance cannot(plugin, EnvironmentBuilder{}.own(4).no_kicks(), Values(plugin).set("nearest_plays", 1));
  EXPECT_EQ(cannot.act(base.build(), near).flags, 0u);
}

TEST(SupportPlugin, KeepsClearOfTheBallAndOfMoreImportantTargets) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "support");
  const FrameBuilder striker = FrameBuilder{}.own(4).robot(4).ball(0, 0).task("striker").at(0, 0);
  const Scene scene = FrameBuilder(striker).task("supporter").at(-0.5, 0).build();
  const BodyBuilder body = BodyBuilder{}.at(-3, 0).task(1).sees_ball();
  EXPECT_EQ(Instance(plugin, EnvironmentBuilder{}.own(4)).act(scene, body).pose[0], -0.5);
  EXPECT_NEAR(
      Instance(plugin, EnvironmentBuilder{}.own(4), Values(plugin).set("clear_of_ball", 1.2)).act(scene, body).pose[0],
      -1.2, 1e-12);
  EXPECT_NEAR(Instance(plugin, EnvironmentBuilder{}.own(4), Values(plugin).set("apart", 1.0)).act(scene, body).pose[0],
              -1.0, 1e-12);
}

TEST(SupportPlugin, LeavesTheGoalAreaToOthers) {
  Instance behaviour(Loaded(REGISTA_PLUGIN_FILE, "support"), EnvironmentBuilder{}.own(4));
  const Scene scene = FrameBuilder{}.own(4).robot(4).no_ball().task("supporter").at(-4.4, 0.5).build();
  EXPECT_DOUBLE_EQ(behaviour.act(scene, BodyBuilder{}.task(0)).pose[0], -3.7);
}

REGISTA_CONDUCT_TESTS("support", 0u);

}  // namespace
