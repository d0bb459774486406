// SPDX-License-Identifier: MIT
// The plugin in scenes: which robots repel which role, whose target is the last pose, which tasks have a field.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>
#include <regista/testkit/recording_host.hpp>

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

// The host tells when the instance is made, so this one is made by hand.
TEST(PreferredPosesPlugin, NoPointForARoleThatTheOffsetLeavesAlone) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "preferred_poses");
  const regista_descriptor& descriptor = plugin.descriptor();
  const Setting setting = EnvironmentBuilder{}.own(2).roles({"goalkeeper", "striker", "jolly"}).build();
  RecordingHost host;
  const auto facts = [](int moves) {
    regista_role_facts out{};
    out.size = sizeof out;
    out.moves = moves;
    return out;
  };
  host.roles = {facts(1), facts(0), facts(1)};
  const Values values(plugin);
  const std::vector<regista_value> raw = values.raw();
  regista_error error{};
  void* const instance = descriptor.create(
      &setting.raw(), host.raw(), {raw.data(), static_cast<std::uint32_t>(raw.size()), sizeof(regista_value)}, &error);
  ASSERT_NE(instance, nullptr) << error.text;
  const Scene scene =
      FrameBuilder{}.own(2).robot(2).at(-4, -2).task(0).at(-4, 0).task(1).at(0, 0).task(2).at(2, 1).build();
  std::vector<regista_waypoint> points(256);
  regista_placement out{};
  out.size = sizeof out;
  out.points = {points.data(), 256, 0, sizeof(regista_waypoint), 0};
  const auto* calls = static_cast<const regista_positioner*>(descriptor.table(REGISTA_KIND_POSITIONER));
  EXPECT_EQ(calls->place(instance, &scene.before_placing().raw(), &out, &error), REGISTA_OK) << error.text;
  ASSERT_EQ(out.points.count, 2u);
  EXPECT_EQ(points[0].task, 0);
  EXPECT_EQ(points[1].task, 2);
  EXPECT_EQ(points[1].x, 2.0);
  descriptor.destroy(instance);
}

REGISTA_POSITIONER_CONTRACT(REGISTA_PLUGIN_FILE, "preferred_poses");

}  // namespace
