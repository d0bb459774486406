// SPDX-License-Identifier: MIT
// Against angles between vectors, by dot and cross product.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using goal_bearing::Form;
using goal_bearing::Pose;
using goal_bearing::value;

constexpr double pi = std::numbers::pi;
constexpr goal_bearing::Point goal{4.5, 0.0};

TEST(GoalBearing, AheadAsideAndBehind) {
  for (const Form form : {Form::angle, Form::cosine}) {
    EXPECT_NEAR(value({0.0, 0.0, 0.0}, goal, form), 1.0, 1e-15);
    EXPECT_NEAR(value({0.0, 0.0, pi / 2.0}, goal, form), 0.5, 1e-15);
    EXPECT_NEAR(value({0.0, 0.0, -pi / 2.0}, goal, form), 0.5, 1e-15);
    EXPECT_NEAR(value({0.0, 0.0, pi}, goal, form), 0.0, 1e-15);
    EXPECT_NEAR(value({6.0, 0.0, pi}, goal, form), 1.0, 1e-15);  // behind the goal line
    EXPECT_NEAR(value({4.5, -3.0, pi / 2.0}, goal, form), 1.0, 1e-15);
    EXPECT_EQ(value({4.5, 0.0, 2.0}, goal, form), 1.0);  // in the goal's middle
  }
  EXPECT_NEAR(value({0.0, 0.0, pi / 4.0}, goal, Form::angle), 0.75, 1e-15);
  EXPECT_NEAR(value({0.0, 0.0, pi / 3.0}, goal, Form::cosine), 0.75, 1e-15);
}

TEST(GoalBearing, AgreesWithTheAngleBetweenVectors) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(-5.0, 5.0), any_heading(-pi, pi);
  for (int round = 0; round < 10000; ++round) {
    const Pose robot{anywhere(random), anywhere(random), any_heading(random)};
    const double dx = goal.x - robot.x, dy = goal.y - robot.y;
    const double ax = std::cos(robot.heading), ay = std::sin(robot.heading);
    const double error = std::atan2(std::abs(ax * dy - ay * dx), ax * dx + ay * dy);
    EXPECT_NEAR(value(robot, goal, Form::angle), (pi - error) / pi, 1e-14);
    EXPECT_NEAR(value(robot, goal, Form::cosine), (1.0 + std::cos(error)) / 2.0, 1e-14);
    for (const Form form : {Form::angle, Form::cosine}) {
      EXPECT_EQ(value({robot.x, -robot.y, -robot.heading}, goal, form), value(robot, goal, form)) << "not mirrored";
      EXPECT_NEAR(value({robot.x, robot.y, robot.heading + 6.0 * pi}, goal, form), value(robot, goal, form), 1e-13);
    }
  }
}

TEST(GoalBearing, ARowHasOneValueAndNothingBehindIt) {
  const std::vector<Pose> robots{{0.0, 0.0, 0.0}, {0.0, 0.0, pi / 2.0}};
  std::vector<double> out(8, -1.0);
  goal_bearing::score(robots, goal, Form::angle, out.data(), 3, 4);
  EXPECT_EQ(out, (std::vector<double>{1.0, 1.0, 1.0, -1.0, 0.5, 0.5, 0.5, -1.0}));
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

TEST(GoalBearingPlugin, TheGoalIsThatOfTheField) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "goal_bearing");
  const FrameBuilder frame = FrameBuilder{}
                                 .own(2)
                                 .robot(2)
                                 .at(5, -5)
                                 .heading(pi / 2)
                                 .robot(3)
                                 .penalised()
                                 .robot(4)
                                 .at(0, 0)
                                 .task("striker")
                                 .task("supporter")
                                 .common([](WorldBuilder& world) { world.robot(2).heading(-pi / 2); });
  Instance small(plugin, EnvironmentBuilder{});
  const Matrix on_small = small.score(frame.build());
  ASSERT_EQ(on_small.rows(), 2u);
  EXPECT_NEAR(on_small(0, 0), 1.0 - std::atan2(0.5, 5.0) / pi, 1e-15);
  EXPECT_EQ(on_small(0, 0), on_small(0, 1));
  EXPECT_EQ(on_small(1, 0), 1.0);
  Instance large(plugin, EnvironmentBuilder{}.field(10, 7, 1), Values(plugin).set("form", "cosine"));
  EXPECT_NEAR(large.score(frame.build())(0, 0), 1.0, 1e-15);
  EXPECT_NEAR(large.score(FrameBuilder(frame).knowledge(REGISTA_COMMON).build())(0, 0), 0.0, 1e-15);
}

REGISTA_UTILITY_CONTRACT(REGISTA_PLUGIN_FILE, "goal_bearing", {.order_of_opponents_is_irrelevant = true});

}  // namespace
