// SPDX-License-Identifier: MIT
// The plugin delaunay_formation in scenes, and the contract of positioners.
#include <gtest/gtest.h>

#include <string>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

namespace {

using namespace regista::testkit;

// For a field of 105 x 68. Number 1 stays; number 2 stands where the ball is; number 3 is beyond the goal line.
const std::string file = R"({"method": "DelaunayTriangulation", "data": [
  {"ball": {"x": -52.5, "y": -34}, "1": {"x": -50, "y": 0}, "2": {"x": -52.5, "y": -34}, "3": {"x": 900, "y": -900}},
  {"ball": {"x":  52.5, "y": -34}, "1": {"x": -50, "y": 0}, "2": {"x":  52.5, "y": -34}, "3": {"x": 900, "y": -900}},
  {"ball": {"x": -52.5, "y":  34}, "1": {"x": -50, "y": 0}, "2": {"x": -52.5, "y":  34}, "3": {"x": 900, "y": -900}},
  {"ball": {"x":  52.5, "y":  34}, "1": {"x": -50, "y": 0}, "2": {"x":  52.5, "y":  34}, "3": {"x": 900, "y": -900}}
]})";

void base(Values& values) { values.set("file", file).set("roles", "goalkeeper: 1, striker: 2, supporter: 3"); }

struct Case {
  Loaded plugin{REGISTA_PLUGIN_FILE, "delaunay_formation"};
  Values values{plugin};
  Case() { base(values); }
  std::string refusal() {
    try {
      Instance instance(plugin, EnvironmentBuilder{}.own(2), values);
    } catch (const CallFailed& failure) {
      return failure.what();
    }
    return "created";
  }
};

TEST(DelaunayFormation, PointsAreScaledTurnedBoundAndOnTheGround) {
  Case c;
  Instance positioner(c.plugin, EnvironmentBuilder{}.own(2), c.values);
  const Scene scene = FrameBuilder{}
                          .own(2)
                          .robot(2)
                          .ball(1.5, 2.0)
                          .task("sweeper")
                          .task("supporter")
                          .task("striker")
                          .task("goalkeeper")
                          .build()
                          .before_placing();
  const Placed placed = positioner.place(scene);
  ASSERT_EQ(placed.points.size(), 3u);
  EXPECT_EQ(placed.points[0].task, 1);
  EXPECT_DOUBLE_EQ(placed.points[0].x, 4.5 + 0.7);
  EXPECT_DOUBLE_EQ(placed.points[0].y, 3.0 + 0.7);
  EXPECT_EQ(placed.points[1].task, 2);
  EXPECT_NEAR(placed.points[1].x, 1.5, 1e-12);
  EXPECT_NEAR(placed.points[1].y, 2.0, 1e-12);
  EXPECT_EQ(placed.points[2].task, 3);
  EXPECT_NEAR(placed.points[2].x, -50.0 * 9.0 / 105.0, 1e-12);
  for (const regista_waypoint& point : placed.points) EXPECT_EQ(point.robot, 0);
}

TEST(DelaunayFormation, AnUnknownBallIsAtTheCentre) {
  Case c;
  Instance positioner(c.plugin, EnvironmentBuilder{}.own(2), c.values);
  const Placed placed =
      positioner.place(FrameBuilder{}.own(2).robot(2).no_ball().task("striker").build().before_placing());
  ASSERT_EQ(placed.points.size(), 1u);
  EXPECT_NEAR(placed.points[0].x, 0.0, 1e-12);
  EXPECT_NEAR(placed.points[0].y, 0.0, 1e-12);
}

// What was asked before does not matter: robots that agree on the ball agree on the formation.
TEST(DelaunayFormation, HistoryDoesNotMatter) {
  Case c;
  Instance used(c.plugin, EnvironmentBuilder{}.own(2), c.values);
  for (int i = 0; i < 500; ++i) {
    const double x = 0.013 * i - 3.0, y = 2.5 - 0.01 * ((i * 7) % 500);
    const Scene scene = FrameBuilder{}.own(2).robot(2).ball(x, y).task("striker").build().before_placing();
    Instance fresh(c.plugin, EnvironmentBuilder{}.own(2), c.values);
    const Placed a = used.place(scene), b = fresh.place(scene);
    ASSERT_EQ(a.points.size(), 1u);
    EXPECT_EQ(a.points[0].x, b.points[0].x);
    EXPECT_EQ(a.points[0].y, b.points[0].y);
  }
}

TEST(DelaunayFormation, Refused) {
  Case c;
  EXPECT_EQ(c.refusal(), "created");
  c.values.set("roles", "strikr: 2");
  EXPECT_EQ(c.refusal(), "create: roles: line 1: no role \"strikr\"; the nearest is \"striker\"");
  c.values.set("roles", "");
  EXPECT_EQ(c.refusal(),
            "create: formation: has 3 positions, but the team has 7 robots; name in `roles` which role takes which "
            "position");
  c.values.set("file", "{}");
  EXPECT_EQ(c.refusal(), "create: formation: the file has no \"method\"");
  c.values.set("file", "");
  EXPECT_EQ(c.refusal(), "create: file: none is named, or it is empty; a formation file is needed");
}

REGISTA_POSITIONER_CONTRACT(REGISTA_PLUGIN_FILE, "delaunay_formation", {.base = base});

}  // namespace
