// SPDX-License-Identifier: MIT
// From actions to commands: each motion and mark of abi.h does what is said there.
#include "mind/body/walking.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace regista::mind {
namespace {

class CarryOut : public ::testing::Test {
 protected:
  Command done(const regista_action& action) const {
    return carry_out({rules, robot, world, 1, pose, Frame2(pose), near}, action);
  }
  static regista_action walk_to_pose(double x, double y, double heading) {
    regista_action out = stand();
    out.motion = REGISTA_MOTION_WALK_TO;
    out.pose[0] = x;
    out.pose[1] = y;
    out.pose[2] = heading;
    return out;
  }
  static regista_action stand() {
    regista_action out{};
    out.kick = REGISTA_NO_KICK;
    return out;
  }

  config::Rules rules;
  config::Robot robot;
  DistributedWorldModel world{7};
  Pose pose{};
  std::vector<Vector2d> near;
};

TEST_F(CarryOut, StandsAndLooks) {
  regista_action action = stand();
  action.gaze = 0.7;
  const Command command = done(action);
  EXPECT_EQ(command.walk.forward, 0.0);
  EXPECT_EQ(command.walk.sideways, 0.0);
  EXPECT_EQ(command.walk.turn, 0.0);
  EXPECT_EQ(command.head_yaw, 0.7);
  EXPECT_FALSE(command.kick);
}

TEST_F(CarryOut, VelocitiesAreLimitedToWhatTheWalkCanDo) {
  regista_action action = stand();
  action.motion = REGISTA_MOTION_VELOCITY;
  action.velocity[0] = 0.1;
  action.velocity[1] = -0.05;
  action.velocity[2] = 0.2;
  EXPECT_EQ(done(action).walk.forward, 0.1);
  EXPECT_EQ(done(action).walk.sideways, -0.05);
  EXPECT_EQ(done(action).walk.turn, 0.2);
  action.velocity[0] = 9.0;
  action.velocity[1] = 0.0;
  action.velocity[2] = -9.0;
  EXPECT_NEAR(done(action).walk.forward, robot.walk.forward, 1e-12);
  EXPECT_EQ(done(action).walk.turn, -robot.walk.turn);
}

TEST_F(CarryOut, WalksAroundWhoStandsInTheWay) {
  const regista_action straight = walk_to_pose(3.0, 0.0, 0.0);
  EXPECT_NEAR(done(straight).walk.turn, 0.0, 1e-12);
  near.push_back({0.8, 0.05});
  EXPECT_LT(done(straight).walk.turn, -0.1) << "to the right of a robot that stands to the left";
  regista_action through = straight;
  through.walk = REGISTA_WALK_STRAIGHT;
  EXPECT_NEAR(done(through).walk.turn, 0.0, 1e-12);
}

TEST_F(CarryOut, WalksAroundDiscs) {
  regista_action action = walk_to_pose(3.0, 0.0, 0.0);
  action.walk = REGISTA_WALK_STRAIGHT;
  action.avoid[0] = {0.8, -0.05, 0.3};
  EXPECT_NEAR(done(action).walk.turn, 0.0, 1e-12) << "none is counted";
  action.avoid_count = 1;
  EXPECT_GT(done(action).walk.turn, 0.1);
}

TEST_F(CarryOut, BriskDoesNotSlowDownOnArrival) {
  regista_action action = walk_to_pose(0.1, 0.0, 0.0);
  const double slow = done(action).walk.forward;
  action.walk = REGISTA_WALK_BRISK;
  EXPECT_LT(slow, 0.2);
  EXPECT_NEAR(done(action).walk.forward, robot.walk.forward, 1e-9);
}

TEST_F(CarryOut, CreepsWithItsOwnVelocityAndTurnsTowardsThePose) {
  regista_action action = walk_to_pose(0.3, 0.0, 0.5);
  const double turn = done(action).walk.turn;
  action.walk = REGISTA_WALK_CREEP;
  action.velocity[0] = 0.06;
  action.velocity[1] = 0.02;
  action.velocity[2] = 99.0;  // not used
  const Command command = done(action);
  EXPECT_EQ(command.walk.forward, 0.06);
  EXPECT_EQ(command.walk.sideways, 0.02);
  EXPECT_EQ(command.walk.turn, turn);
  EXPECT_GT(turn, 0.1);
}

TEST_F(CarryOut, WhoKicksDoesNotWalk) {
  regista_action action = walk_to_pose(1.0, 0.0, 0.0);
  action.kick = 2;
  action.kick_direction = -0.3;
  action.kick_distance = 0.8;
  const Command command = done(action);
  ASSERT_TRUE(command.kick);
  EXPECT_EQ(command.kick->kind, 2);
  EXPECT_EQ(command.kick->direction, -0.3);
  EXPECT_EQ(command.kick->distance, 0.8);
  EXPECT_EQ(command.walk.forward, 0.0);
}

}  // namespace
}  // namespace regista::mind
