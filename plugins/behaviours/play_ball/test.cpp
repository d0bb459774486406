// SPDX-License-Identifier: MIT
// Getting behind the ball and kicking it, worked out by hand; and what the plugin makes of a ball that is lost or that
// it must not touch.
#include <gtest/gtest.h>

#include <regista/testkit/dice.hpp>

#include "../approach.hpp"
#include "../test_conduct.hpp"
#include "../test_situations.hpp"

namespace {

using namespace behaviours;

// Touching is at 0.2 m and the reach is 0.22 m, so it stands 0.21 m behind the ball.
const KickPlan ahead{{1, 0}, 3.0, 1};

Movement approach_from(const Situation& situation, const KickPlan& kick = ahead) {
  return approach(situation, {}, {}, kick);
}

TEST(Approach, KicksWhatLiesBeforeIt) {
  const auto kick = std::get<KickBall>(approach_from(with_ball(standing(-0.2, 0), {0, 0})));
  EXPECT_EQ(kick.kind, 1);
  EXPECT_EQ(kick.distance, 3.0);
  EXPECT_EQ(kick.direction, 0.0);
  const auto turned = std::get<KickBall>(approach_from(with_ball(standing(-0.2, 0, 0.29), {0, 0})));
  EXPECT_NEAR(turned.direction, -0.29, 1e-12) << "to the right of its heading";
}

TEST(Approach, OnlyInReachInLineAndInSight) {
  const auto kicks = [](const Situation& situation) {
    return std::holds_alternative<KickBall>(approach_from(situation));
  };
  EXPECT_TRUE(kicks(with_ball(standing(-0.21, 0), {0, 0})));
  EXPECT_FALSE(kicks(with_ball(standing(-0.23, 0), {0, 0})));
  EXPECT_FALSE(kicks(with_ball(standing(-0.2, 0, 0.31), {0, 0})));
  EXPECT_TRUE(kicks(with_ball(standing(-0.16, -0.11, 0), {0, 0}))) << "the cosine is 0.82";
  EXPECT_FALSE(kicks(with_ball(standing(-0.15, -0.13, 0), {0, 0}))) << "the cosine is 0.76";
  Situation unseen = with_ball(standing(-0.2, 0), {0, 0});
  unseen.sees_ball = false;
  EXPECT_FALSE(kicks(unseen));
}

TEST(Approach, WalksBehindTheBall) {
  const auto walk = std::get<WalkTo>(approach_from(with_ball(standing(-2, 0.1), {0, 0})));
  EXPECT_NEAR(walk.target.x, -0.21, 1e-12);
  EXPECT_NEAR(walk.target.y, 0.0, 1e-12);
  EXPECT_EQ(walk.target.heading, 0.0);
  EXPECT_FALSE(walk.brisk || walk.straight || walk.around || walk.creep);
}

TEST(Approach, AroundTheBallFromBeforeIt) {
  const auto walk = std::get<WalkTo>(approach_from(with_ball(standing(0.5, 0, pi), {0, 0.1})));
  EXPECT_NEAR(walk.target.x, -0.36, 1e-12) << "0.15 m farther than where it kicks";
  EXPECT_NEAR(walk.target.y, 0.1, 1e-12);
  ASSERT_TRUE(walk.around);
  EXPECT_EQ(walk.around->centre, Vector2d(0, 0.1));
  EXPECT_NEAR(walk.around->radius, 0.35, 1e-12) << "0.15 m farther than touching";
  EXPECT_FALSE(walk.creep);
}

TEST(Approach, CreepsOntoTheBall) {
  const auto creep = [](double distance, double turned) {
    return std::get<WalkTo>(approach_from(with_ball(standing(-distance, 0, turned), {0, 0}))).creep;
  };
  ASSERT_TRUE(creep(0.32, 0.0));
  EXPECT_NEAR((*creep(0.32, 0.0) - Vector2d(0.12, 0)).norm(), 0.0, 1e-12);
  EXPECT_FALSE(creep(0.34, 0.0));
  // 0.59 rad to the left, so the ball is to its right.
  ASSERT_TRUE(creep(0.32, 0.59));
  EXPECT_NEAR((*creep(0.32, 0.59) - 0.12 * Vector2d(std::cos(0.59), -std::sin(0.59))).norm(), 0.0, 1e-12);
  EXPECT_FALSE(creep(0.32, 0.61));
  ASSERT_TRUE(creep(0.2, 0.5)) << "turned too far for a kick";
}

// After the 4 s of way, or the 2 s that it looks ahead at most, a ball of 0.5 m/s lies: 0.25 / 0.64 m farther.
TEST(Approach, MeetsARollingBallWhereItWillBe) {
  const auto walk = std::get<WalkTo>(approach_from(with_ball(standing(0, 0), {1, 0}, {0, 0.5})));
  EXPECT_NEAR(walk.target.x, 0.79, 1e-12);
  EXPECT_NEAR(walk.target.y, 0.390625, 1e-12);
  // A fast one rolls on: 2 s at 3 m/s, no slowing counted.
  const auto fast = std::get<WalkTo>(approach_from(with_ball(standing(0, 0), {1, 0}, {0, 3})));
  EXPECT_NEAR(fast.target.y, 6.0, 1e-12);
  // At 0.25 m/s the robot needs 1 s for 0.25 m.
  const auto near = std::get<WalkTo>(approach_from(with_ball(standing(0.75, 0), {1, 0}, {0, 0.4})));
  EXPECT_NEAR(near.target.y, 0.25, 1e-12) << "where it comes to rest, 0.16 / 0.64 m on";
  const auto slow = std::get<WalkTo>(approach_from(with_ball(standing(0, 0), {1, 0}, {0, 0.24})));
  EXPECT_EQ(slow.target.y, 0.0) << "walked to as if it lay";
}

TEST(Approach, NothingToKickNothingToDo) {
  EXPECT_TRUE(std::holds_alternative<Stand>(approach_from(with_ball(standing(-0.2, 0), {0, 0}), KickPlan{})));
}

// The same from every side: turning field, robot and kick together turns the answer.
TEST(Approach, DoesNotDependOnTheDirectionsOfTheField) {
  regista::testkit::Dice dice(4);
  for (int round = 0; round < 500; ++round) {
    const double angle = dice.real(-3, 3), c = std::cos(angle), s = std::sin(angle);
    const auto turn = [&](const Vector2d& v) { return Vector2d(c * v.x() - s * v.y(), s * v.x() + c * v.y()); };
    const double x = dice.real(-0.6, 0.6), y = dice.real(-0.6, 0.6), heading = dice.real(-0.1, 0.1);
    const Vector2d velocity(dice.chance(0.5) ? 0.5 : 0.0, 0.1);
    const Vector2d moved = turn({x, y});
    const Movement here = approach_from(with_ball(standing(x, y, heading), {0, 0}, velocity));
    const Movement there =
        approach_from(with_ball(standing(moved.x(), moved.y(), wrap(heading + angle)), {0, 0}, turn(velocity)),
                      {turn({1, 0}), 3.0, 1});
    ASSERT_EQ(here.index(), there.index());
    if (const auto* walk = std::get_if<WalkTo>(&here)) {
      const auto& other = std::get<WalkTo>(there);
      EXPECT_NEAR((turn({walk->target.x, walk->target.y}) - Vector2d(other.target.x, other.target.y)).norm(), 0, 1e-9);
      EXPECT_NEAR(std::cos(walk->target.heading + angle - other.target.heading), 1.0, 1e-9);
      ASSERT_EQ(walk->creep.has_value(), other.creep.has_value());
      if (walk->creep) {
        EXPECT_NEAR((*walk->creep - *other.creep).norm(), 0.0, 1e-9) << "robot frame";
      }
    }
  }
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

FrameBuilder striker() {
  return FrameBuilder{}.own(3).robot(3).task("striker").at(1, 0).heading(0.2).ball(2, 0).time(2.0);
}

BodyBuilder behind_ball() { return BodyBuilder{}.at(1.8, 0).task(0).sees_ball(); }

TEST(PlayBallPlugin, ShootsWithAKickThatTheRobotHas) {
  Instance behaviour(Loaded(REGISTA_PLUGIN_FILE, "play_ball"), EnvironmentBuilder{}.own(3));
  const regista_action shot = behaviour.act(striker().build(), behind_ball());
  EXPECT_EQ(shot.kick, 0) << "the fast one";
  EXPECT_NEAR(shot.kick_distance, 3.5, 0.1) << "2.5 m to the line, and a metre into the net";
  EXPECT_LT(std::abs(shot.kick_direction), std::atan2(0.75, 2.5));
  EXPECT_EQ(shot.motion, REGISTA_MOTION_STAND);
  Instance weak(Loaded(REGISTA_PLUGIN_FILE, "play_ball"),
                EnvironmentBuilder{}.own(3).no_kicks().kick("tap", 0.1, 0.3, 0.5, 0.2));
  EXPECT_NEAR(weak.act(striker().build(), behind_ball()).kick_distance, 0.3, 1e-12);
}

TEST(PlayBallPlugin, WalksAroundTheBall) {
  Instance behaviour(Loaded(REGISTA_PLUGIN_FILE, "play_ball"), EnvironmentBuilder{}.own(3));
  const regista_action action = behaviour.act(striker().build(), BodyBuilder{}.at(2.5, 0).task(0).sees_ball());
  EXPECT_EQ(action.motion, REGISTA_MOTION_WALK_TO);
  ASSERT_EQ(action.avoid_count, 1u);
  EXPECT_EQ(action.avoid[0].x, 2.0);
  EXPECT_EQ(action.avoid[0].y, 0.0);
  EXPECT_NEAR(action.avoid[0].radius, 0.35, 1e-12);
}

TEST(PlayBallPlugin, CreepsInTheRobotsFrame) {
  Instance behaviour(Loaded(REGISTA_PLUGIN_FILE, "play_ball"), EnvironmentBuilder{}.own(3));
  const regista_action action = behaviour.act(striker().build(), BodyBuilder{}.at(1.7, 0).task(0).sees_ball());
  EXPECT_EQ(action.motion, REGISTA_MOTION_WALK_TO);
  EXPECT_EQ(action.walk, std::uint32_t{REGISTA_WALK_CREEP});
  EXPECT_NEAR(action.velocity[0], 0.12, 1e-12);
  EXPECT_EQ(action.velocity[1], 0.0);
}

TEST(PlayBallPlugin, LooksForABallThatIsLost) {
  Instance behaviour(Loaded(REGISTA_PLUGIN_FILE, "play_ball"), EnvironmentBuilder{}.own(3));
  for (const Scene& scene : {striker().no_ball().build(), striker().ball_age(5.0).build()}) {
    const regista_action away = behaviour.act(scene, behind_ball());
    EXPECT_EQ(away.motion, REGISTA_MOTION_WALK_TO);
    EXPECT_EQ(away.pose[0], 1.0);
    const regista_action there = behaviour.act(scene, BodyBuilder{}.at(1.2, 0).task(0));
    EXPECT_EQ(there.motion, REGISTA_MOTION_VELOCITY);
    EXPECT_EQ(there.velocity[2], -0.6);
  }
}

// Supporting, it keeps away from the ball of the opponent's set play; one that plays the ball may stand in the goal
// area.
TEST(PlayBallPlugin, SupportsWhileItMustNotTouchTheBall) {
  Instance behaviour(Loaded(REGISTA_PLUGIN_FILE, "play_ball"), EnvironmentBuilder{}.own(3));
  const regista_action away = behaviour.act(striker().set_play(REGISTA_SET_PLAY_KICK_IN, false).build(), behind_ball());
  EXPECT_EQ(away.kick, REGISTA_NO_KICK);
  EXPECT_EQ(away.motion, REGISTA_MOTION_WALK_TO);
  EXPECT_NEAR(away.pose[0], 0.9, 1e-12) << "1.1 m from the ball";
  Instance cannot(Loaded(REGISTA_PLUGIN_FILE, "play_ball"), EnvironmentBuilder{}.own(3).no_kicks());
  const regista_action stays = cannot.act(striker().at(-4.4, 0).build(), behind_ball());
  EXPECT_EQ(stays.motion, REGISTA_MOTION_WALK_TO);
  EXPECT_EQ(stays.pose[0], -4.4);
}

// Teammate 5 stands beside the ball, and its news are fresh.
TEST(PlayBallPlugin, LeavesTheBallToWhoIsSurelyFirstAndSaysSo) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "play_ball");
  const Scene scene = striker().robot(5).at(1.7, 0.1).age(0.2).build();
  const BodyBuilder far = BodyBuilder{}.at(0, 0).task(0).sees_ball();
  Instance by_role(plugin, EnvironmentBuilder{}.own(3));
  EXPECT_EQ(by_role.act(scene, far).flags, 0u);
  EXPECT_NEAR(by_role.act(scene, far).pose[0], 1.79, 0.01) << "behind the ball";
  Instance claims(plugin, EnvironmentBuilder{}.own(3), Values(plugin).set("nearest_plays", 1));
  const regista_action leaves = claims.act(scene, far);
  EXPECT_EQ(leaves.flags, std::uint32_t{REGISTA_ACTION_TARGET});
  EXPECT_NEAR(leaves.target[0], 0.8, 1e-9) << "1.2 m behind the ball";
  EXPECT_NEAR(leaves.pose[0], 0.8, 1e-9);
  EXPECT_EQ(claims.act(striker().robot(5).at(-1, 0).age(0.2).build(), far).flags, 0u);
}

// The goal is shut; teammate 5 stands free beside it.
TEST(PlayBallPlugin, SaysForWhomAKickIsMeant) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "play_ball");
  Instance behaviour(plugin, EnvironmentBuilder{}.own(3), Values(plugin).set("kick_rule", "expected_gain"));
  FrameBuilder scene =
      FrameBuilder{}.own(3).robot(3).task("striker").ball(2, -2).time(2.0).robot(5).at(2.6, 1.2).age(0.2);
  for (const double x : {2.5, 2.7, 2.9}) scene.opponent(x, -1.7 + (x - 2.5));
  scene.opponent(4.1, 0.0);
  const BodyBuilder body = BodyBuilder{}.at(1.96, -2.2).heading(std::atan2(0.2, 0.04)).task(0).sees_ball();
  EXPECT_NE(behaviour.act(scene.build(), body).kick, REGISTA_NO_KICK);
  EXPECT_EQ(behaviour.host().receivers, std::vector<std::int32_t>{5});
  Instance shoots(plugin, EnvironmentBuilder{}.own(3), Values(plugin).set("kick_rule", "expected_gain"));
  EXPECT_NE(shoots.act(striker().build(), behind_ball()).kick, REGISTA_NO_KICK);
  EXPECT_TRUE(shoots.host().receivers.empty()) << "a shot is for nobody";
}

// An opponent right before the ball makes left and right equally good; a little more room on one side decides, and from
// then on the choice stays until the match is over.
TEST(PlayBallPlugin, KeepsItsChoiceUntilTheNextMatch) {
  Instance behaviour(Loaded(REGISTA_PLUGIN_FILE, "play_ball"), EnvironmentBuilder{}.own(3));
  const auto scene = [](double y) {
    return FrameBuilder{}.own(3).robot(3).task("striker").ball(-2, 0).opponent(-0.5, y).time(2.0).build();
  };
  const BodyBuilder body = BodyBuilder{}.at(-3, 0).task(0).sees_ball();
  const double left = behaviour.act(scene(-0.05), body).pose[2];
  EXPECT_GT(left, 0.1);
  EXPECT_EQ(behaviour.act(scene(0.05), body).pose[2], left);
  behaviour.reset(1);
  EXPECT_LT(behaviour.act(scene(0.05), body).pose[2], -0.1);
}

REGISTA_CONDUCT_TESTS("play_ball", REGISTA_BEHAVIOUR_PLAYS_BALL);

}  // namespace
