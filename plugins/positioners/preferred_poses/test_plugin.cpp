// SPDX-License-Identifier: MIT
// The plugin in scenes: which robots repel which role, whose target is the last pose, which tasks have a field.
#include <gtest/gtest.h>

#include <cmath>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

namespace {

using namespace regista::testkit;

Placed place(const FrameBuilder& frame) {
  static const Loaded plugin(REGISTA_PLUGIN_FILE, "preferred_poses");
  Instance positioner(plugin, EnvironmentBuilder{}.own(2));
  return positioner.place(frame.build().before_placing());
}

FrameBuilder two_tasks() {
  return FrameBuilder{}.own(2).robot(2).at(-4, -2).task("supporter").at(0, 0).task("jolly").at(2, 1);
}

TEST(PreferredPosesPlugin, APointForEachTaskThatAnyRobotMayTake) {
  const Placed placed = place(two_tasks().task("goalkeeper").at(-4, 0).only_for(1).task("libero").at(-2, 0));
  ASSERT_EQ(placed.points.size(), 3u);
  const int tasks[] = {0, 1, 3};
  const double x[] = {0.0, 2.0, -2.0};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(placed.points[k].task, tasks[k]);
    EXPECT_EQ(placed.points[k].x, x[k]);
  }
}

// Where robot 3 stands matters to the roles that it does not play, and while it plays one.
TEST(PreferredPosesPlugin, WhoPlaysARoleRepelsTheOthers) {
  const auto with = [](const char* role) {
    FrameBuilder frame = two_tasks().robot(3).at(0, 0);
    if (role != nullptr) frame.role(role);
    return place(frame).points[0];
  };
  EXPECT_EQ(with("supporter").x, 0.0);
  EXPECT_EQ(with(nullptr).x, 0.0);     // plays none yet
  EXPECT_EQ(with("search_1").x, 0.0);  // none of these
  EXPECT_NEAR(std::abs(with("jolly").x), 0.75, 1e-12);
}

TEST(PreferredPosesPlugin, OpponentsOfTheChosenWorldRepel) {
  const FrameBuilder frame = two_tasks().opponent(0, 0);
  EXPECT_NEAR(std::abs(place(frame).points[0].x), 0.75, 1e-12);
  EXPECT_EQ(place(two_tasks().opponent(0, 0).weight(0.4)).points[0].x, 0.0);
  const auto nobody = [](WorldBuilder& world) { world.no_opponents(); };
  EXPECT_EQ(place(FrameBuilder(frame).common(nobody).knowledge(REGISTA_COMMON)).points[0].x, 0.0);
}

TEST(PreferredPosesPlugin, TheLastPoseIsWhatTheRolesRobotSaid) {
  const auto with = [](const char* role) {
    return place(two_tasks().robot(3).at(3, -2).role(role).target(0.08, 0.0)).points[0].x;
  };
  EXPECT_EQ(with("supporter"), 0.08);
  EXPECT_EQ(with("jolly"), 0.0);
}

TEST(PreferredPosesPlugin, PlacesOffTheFieldComeBackToIt) {
  const Placed placed = place(FrameBuilder{}.own(2).robot(2).task("supporter").at(7, -9));
  ASSERT_EQ(placed.points.size(), 1u);
  EXPECT_LE(placed.points[0].x, 4.5);
  EXPECT_GE(placed.points[0].x, 3.75);
  EXPECT_GE(placed.points[0].y, -3.0);
  EXPECT_LE(placed.points[0].y, -2.25);
}

REGISTA_POSITIONER_CONTRACT(REGISTA_PLUGIN_FILE, "preferred_poses");

}  // namespace
