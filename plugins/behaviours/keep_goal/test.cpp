// SPDX-License-Identifier: MIT
// When the keeper plays the ball, when it goes for a shot, and where it stands otherwise.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "../test_conduct.hpp"
#include "../test_situations.hpp"
#include "algorithm.hpp"

namespace {

using namespace behaviours;

Situation keeper(double x, double y) {
  Situation out = standing(x, y);
  out.duty = Duty::keeps_goal;
  return out;
}

// 1.65 m of penalty area and 0.2 m from the goal's centre at (-4.5, 0), or 1 m from the robot.
TEST(Keeper, PlaysABallThatLiesNear) {
  const auto plays = [](const Situation& situation) { return keep_goal::plays_ball(situation, {}); };
  EXPECT_TRUE(plays(with_ball(keeper(-4.2, 0), {-2.66, 0})));
  EXPECT_FALSE(plays(with_ball(keeper(-4.2, 0), {-2.64, 0})));
  EXPECT_TRUE(plays(with_ball(keeper(-4.2, 0), {-4.5, 1.84})));
  EXPECT_FALSE(plays(with_ball(keeper(-4.2, 0), {-4.5, 1.86})));
  EXPECT_TRUE(plays(with_ball(keeper(0, 0), {0.99, 0})));
  EXPECT_FALSE(plays(with_ball(keeper(0, 0), {1.01, 0})));
}

TEST(Keeper, DoesNotPlayAFastALostOrTheOpponentsBall) {
  const auto plays = [](const Situation& situation) { return keep_goal::plays_ball(situation, {}); };
  EXPECT_TRUE(plays(with_ball(keeper(-4.2, 0), {-4, 0}, {0.3, 0.39})));
  EXPECT_FALSE(plays(with_ball(keeper(-4.2, 0), {-4, 0}, {0.3, 0.41})));
  Situation lost = with_ball(keeper(-4.2, 0), {-4, 0});
  lost.ball_trusted = false;
  EXPECT_FALSE(plays(lost));
  const Situation near = with_ball(keeper(-4.2, 0), {-4, 0});
  EXPECT_TRUE(plays(in_set_play(near, SetPlay::goal_kick, true)));
  EXPECT_FALSE(plays(in_set_play(near, SetPlay::corner_kick, false)));
}

// A ball of 1 m/s rolls 1 / (2 * 0.32) = 1.5625 m.
TEST(Keeper, GoesForTheLineOfAShot) {
  const Situation shot = with_ball(keeper(-4, 0), {-3, 0.5}, {-1, 0});
  const auto walk = std::get<WalkTo>(keep_goal::guard(shot, {}, {}, {}));
  EXPECT_NEAR(walk.target.x, -4.0, 1e-12);
  EXPECT_NEAR(walk.target.y, 0.5, 1e-12);
  EXPECT_NEAR(walk.target.heading, std::atan2(0.5, 1.0), 1e-12) << "faces the ball";
  EXPECT_TRUE(walk.brisk && walk.straight);

  const auto stays = [](const Situation& situation) {
    return !std::get<WalkTo>(keep_goal::guard(situation, {}, {}, {})).straight;
  };
  EXPECT_TRUE(stays(with_ball(keeper(-4, 0), {-3, 0.5}, {1, 0}))) << "it leaves";
  EXPECT_TRUE(stays(with_ball(keeper(-2, 0), {-3, 0.5}, {1, 0}))) << "away from the goal";
  EXPECT_TRUE(stays(with_ball(keeper(-4, 0), {-3, 1.6}, {-1, 0}))) << "it passes too far away";
  EXPECT_FALSE(stays(with_ball(keeper(-4, 0), {-3, 1.4}, {-1, 0})));
  EXPECT_TRUE(stays(in_set_play(shot, SetPlay::kick_in, false))) << "nobody may touch it";
}

TEST(Keeper, StandsAtItsPlaceInTheGoalArea) {
  Situation situation = with_ball(keeper(-2, 0), {3, 0});
  situation.target = {-4.3, 0.1, 0.2};
  const auto walk = std::get<WalkTo>(keep_goal::guard(situation, {}, {}, {}));
  EXPECT_EQ(walk.target.x, -4.3);
  EXPECT_EQ(walk.target.y, 0.1);
  EXPECT_EQ(walk.target.heading, 0.2);
  EXPECT_FALSE(walk.brisk || walk.straight);
}

// The goal is 1.5 m wide and its line at -4.5. From the place, both posts are seen under the same angle as from the
// ball.
TEST(Keeper, ComesOutToCoverTheAngle) {
  const keep_goal::Settings out{.narrow_angle = 1.2, .share = 0.4};
  const auto place = [&](const Vector2d& ball) {
    return *keep_goal::covering_place(with_ball(keeper(-4.2, 0), ball), out);
  };
  EXPECT_NEAR(place({-2.5, 0}).x, -4.5 + 0.4 * 2.0, 1e-12) << "0.4 of the way to the ball";
  EXPECT_NEAR(place({-2.5, 0}).y, 0.0, 1e-12);
  EXPECT_NEAR(place({2, 0}).x, -4.5 + 1.2, 1e-12) << "no farther than it may";
  for (const Vector2d& ball : {Vector2d(-2.5, 2), Vector2d(-3.9, -1.5), Vector2d(0, 2.5)}) {
    const Pose stand = place(ball);
    const Vector2d there = Vector2d(stand.x, stand.y) - ball;
    const auto angle_to = [&](double post) {
      return std::abs(wrap(angle_of(Vector2d(-4.5, post) - ball) - angle_of(there)));
    };
    EXPECT_NEAR(angle_to(0.75), angle_to(-0.75), 1e-12);
    EXPECT_GT(stand.x, -4.5);
    EXPECT_NEAR(wrap(stand.heading - angle_of(-there)), 0.0, 1e-12) << "it faces the ball";
  }
  EXPECT_FALSE(keep_goal::covering_place(with_ball(keeper(-4.2, 0), {-2.5, 0}), {})) << "only where it is asked to";
  EXPECT_FALSE(keep_goal::covering_place(with_ball(keeper(-4.2, 0), {-4.6, 2}), out)) << "no angle to cover";
  EXPECT_FALSE(keep_goal::covering_place(keeper(-4.2, 0), out)) << "nobody knows the ball";
  const auto guard = std::get<WalkTo>(keep_goal::guard(with_ball(keeper(-4.2, 0), {-2.5, 0}), out, {}, {}));
  EXPECT_NEAR(guard.target.x, -3.7, 1e-12);
}

// A ball 1.2 m from the keeper, at which it is after 4 s; the opponent needs (distance - 0.2) / 0.25.
TEST(Keeper, LeavesABallAtWhichAnOpponentIsMuchSooner) {
  const auto late = [](double opponent_away, double weight, double seconds) {
    const std::vector<Blocker> opponents{{{-3 + opponent_away, 0}, weight}};
    return keep_goal::comes_too_late(with_ball(keeper(-4.2, 0), {-3, 0}), {.leave_lost_ball = seconds}, opponents);
  };
  EXPECT_TRUE(late(0.9, 1.0, 1.0));   // after 2.8 s
  EXPECT_FALSE(late(1.0, 1.0, 1.0));  // after 3.2 s
  EXPECT_FALSE(late(0.2, 1.0, 60.0));
  EXPECT_FALSE(late(0.2, 0.4, 1.0)) << "hardly believed in";
  EXPECT_FALSE(keep_goal::comes_too_late(with_ball(keeper(-4.2, 0), {-3, 0}), {.leave_lost_ball = 0.0}, {}));
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

TEST(KeepGoalPlugin, ClearsABallThatLiesBeforeIt) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "keep_goal");
  const FrameBuilder base = FrameBuilder{}.own(1).robot(1).task("goalkeeper").at(-4.3, 0);
  const Scene near = FrameBuilder(base).ball(-3.8, 0).build(), far = FrameBuilder(base).ball(1, 0).build();
  const BodyBuilder behind = BodyBuilder{}.at(-4, 0).task(0).sees_ball();
  Instance behaviour(plugin, EnvironmentBuilder{}.own(1));
  const regista_action kick = behaviour.act(near, behind);
  EXPECT_GE(kick.kick, 0);
  EXPECT_LE(std::abs(kick.kick_direction), 0.3);
  const regista_action guard = behaviour.act(far, behind);
  EXPECT_EQ(guard.kick, REGISTA_NO_KICK);
  EXPECT_EQ(guard.motion, REGISTA_MOTION_WALK_TO);
  EXPECT_EQ(guard.pose[0], -4.3) << "a keeper may stand in its goal area";
  Instance cannot_kick(plugin, EnvironmentBuilder{}.own(1).no_kicks());
  EXPECT_EQ(cannot_kick.act(near, behind).pose[0], -4.3);
}

TEST(KeepGoalPlugin, LeavesTheBallToATeammateThatIsSurelyFirst) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "keep_goal");
  const Scene scene =
      FrameBuilder{}.own(1).robot(1).robot(3).at(-3.3, 0).age(0.2).ball(-3.1, 0).task("goalkeeper").at(-4.3, 0).build();
  const BodyBuilder body = BodyBuilder{}.at(-4.3, 0).task(0).sees_ball();
  Instance claims(plugin, EnvironmentBuilder{}.own(1), Values(plugin).set("nearest_plays", 1));
  EXPECT_EQ(claims.act(scene, body).pose[0], -4.3);
  Instance alone(plugin, EnvironmentBuilder{}.own(1));
  EXPECT_GT(alone.act(scene, body).pose[0], -3.6) << "otherwise it comes out";
}

TEST(KeepGoalPlugin, ThrowsItselfAtAShotPastEverybody) {
  Instance behaviour(Loaded(REGISTA_PLUGIN_FILE, "keep_goal"), EnvironmentBuilder{}.own(1));
  const Scene shot = FrameBuilder{}.own(1).robot(1).ball(-3, 0.5).ball_velocity(-1, 0).task("goalkeeper").build();
  const regista_action action = behaviour.act(shot, BodyBuilder{}.at(-4, 0).task(0).sees_ball());
  EXPECT_EQ(action.motion, REGISTA_MOTION_WALK_TO);
  EXPECT_EQ(action.walk, std::uint32_t{REGISTA_WALK_BRISK | REGISTA_WALK_STRAIGHT});
  EXPECT_NEAR(action.pose[1], 0.5, 1e-12);
}

// So that teammates, and those who count, know that it goes for the ball.
TEST(KeepGoalPlugin, AnnouncesTheBallThatItTakes) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "keep_goal");
  const FrameBuilder base = FrameBuilder{}.own(1).robot(1).task("goalkeeper").at(-4.3, 0);
  const Scene near = FrameBuilder(base).ball(-3.1, 0.2).build(), far = FrameBuilder(base).ball(1, 0).build();
  const BodyBuilder body = BodyBuilder{}.at(-4.3, 0).task(0).sees_ball();
  Instance claims(plugin, EnvironmentBuilder{}.own(1), Values(plugin).set("nearest_plays", 1));
  const regista_action takes = claims.act(near, body);
  EXPECT_NE(takes.flags & REGISTA_ACTION_TARGET, 0u);
  EXPECT_EQ(takes.target[0], -3.1);
  EXPECT_EQ(takes.target[1], 0.2);
  EXPECT_EQ(claims.act(far, body).flags & REGISTA_ACTION_TARGET, 0u);
  Instance plain(plugin, EnvironmentBuilder{}.own(1));
  EXPECT_EQ(plain.act(near, body).flags & REGISTA_ACTION_TARGET, 0u) << "the paper's teams stay what they are";
}

TEST(KeepGoalPlugin, ComesOutOrLeavesTheBallAsItIsTold) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "keep_goal");
  const FrameBuilder base = FrameBuilder{}.own(1).robot(1).task("goalkeeper").at(-4.3, 0);
  const BodyBuilder body = BodyBuilder{}.at(-4.3, 0).task(0).sees_ball();
  Instance out(plugin, EnvironmentBuilder{}.own(1), Values(plugin).set("narrow_angle", 1).set("leave_lost_ball", 0.5));
  EXPECT_NEAR(out.act(FrameBuilder(base).ball(-2.0, 0).build(), body).pose[0], -3.5, 1e-12);
  const Scene near = FrameBuilder(base).ball(-3.0, 0).opponent(-2.7, 0).build();
  EXPECT_NEAR(out.act(near, body).pose[0], -3.9, 1e-12) << "the opponent is there first: it covers the angle";
  Instance plain(plugin, EnvironmentBuilder{}.own(1));
  EXPECT_GT(plain.act(near, body).pose[0], -3.9) << "it plays whatever lies near";
}

REGISTA_CONDUCT_TESTS("keep_goal", REGISTA_BEHAVIOUR_KEEPS_GOAL);

}  // namespace
