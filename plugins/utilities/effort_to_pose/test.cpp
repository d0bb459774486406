// SPDX-License-Identifier: MIT
// Scores by hand, obstacles against points sampled along the way, and what must hold of any scene.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using effort_to_pose::Direction, effort_to_pose::Point, effort_to_pose::Settings, effort_to_pose::Target;
constexpr double pi = std::numbers::pi, close = 1e-9;

struct PoseOf {
  double x, y, heading;
};

double score(const PoseOf& robot, const PoseOf& pose, const std::vector<Point>& robots = {},
             const Settings& settings = {}) {
  return effort_to_pose::effort_to_pose({robot.x, robot.y}, Direction::of(robot.heading),
                                        {{pose.x, pose.y}, Direction::of(pose.heading)}, robots, settings);
}

TEST(EffortToPose, ByHand) {
  EXPECT_NEAR(score({0, 0, 0}, {0, 0, 0}), 1.0, close);
  EXPECT_NEAR(score({0, 0, 0}, {5.5, 0, 0}), 1.0 - 0.55 / 2, close);
  EXPECT_NEAR(score({0, 0, 0}, {20, 0, 0}), 0.45, close);  // farther than the longest way
  EXPECT_NEAR(score({0, 0, pi / 2}, {1.1, 0, 0}), 1.0 - 0.055 - 0.15 / 2, close);
  EXPECT_NEAR(score({0, 0, 0}, {1.1, 0, pi / 2}), 1.0 - 0.055 - 0.15 / 2, close);
  EXPECT_NEAR(score({0, 0, pi}, {1.1, 0, pi}), 1.0 - 0.055 - 0.3, close);  // about, and about again
  EXPECT_NEAR(score({0, 0, 0}, {1.1, 0, 0}, {{0.5, 0.2}}), 1.0 - 0.055 - 0.075, close);
  EXPECT_NEAR(score({0, 0, 0}, {1.1, 0, 0}, {{0.5, 0.2}, {1, 0}, {0.1, 0.1}}), 1.0 - 0.055 - 0.15, close);
  EXPECT_NEAR(score({0, 0, 0}, {1.1, 0, 0}, {{0.5, 0.31}, {-0.31, 0}, {1.41, 0}}), 1.0 - 0.055, close);
}

// On the spot the way has no direction: what is left is the turn to the pose's heading.
TEST(EffortToPose, OnTheSpotOneTurnIsLeft) {
  EXPECT_NEAR(score({1, 1, 0.3}, {1, 1, 0.3}), 1.0, close);
  EXPECT_NEAR(score({1, 1, 0}, {1, 1, pi / 2}), 1.0 - 0.15 / 2, close);
  // Halfway there: half of either.
  EXPECT_NEAR(score({0, 0, 0}, {-0.15, 0, 0}), 1.0 - 0.55 * 0.15 / 11 - 0.15 / 2 - 0.15 / 2, close);
  for (const double angle : {0.0, 1.0, 2.0, 3.0, -2.5}) {  // no jump at the pose
    EXPECT_NEAR(score({0, 0, 0.4}, {1e-7 * std::cos(angle), 1e-7 * std::sin(angle), 2.0}),
                score({0, 0, 0.4}, {0, 0, 2.0}), 1e-6);
  }
}

TEST(EffortToPose, AnySceneAgainstTheDefinition) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> x(-4.5, 4.5), y(-3.0, 3.0), angle(-pi, pi);
  for (int round = 0; round < 2000; ++round) {
    const PoseOf robot{x(random), y(random), angle(random)}, pose{x(random), y(random), angle(random)};
    std::vector<Point> robots;
    for (int k = 0; k < 1 + round % 13; ++k) robots.push_back({x(random), y(random)});
    const double distance = std::hypot(pose.x - robot.x, pose.y - robot.y);
    const double course = std::atan2(pose.y - robot.y, pose.x - robot.x);
    const double walks = std::min(1.0, distance / 0.3);
    const auto between = [](double a, double b) { return std::abs(std::remainder(a - b, 2 * pi)); };
    int obstacles = 0, doubtful = 0;
    for (const Point& each : robots) {
      double least = 1e9;
      for (int step = 0; step <= 4000; ++step) {
        const double s = step / 4000.0;
        least = std::min(
            least, std::hypot(robot.x + s * (pose.x - robot.x) - each.x, robot.y + s * (pose.y - robot.y) - each.y));
      }
      obstacles += least < 0.3 ? 1 : 0;
      doubtful += std::abs(least - 0.3) < 1e-4 ? 1 : 0;
    }
    if (doubtful > 0) continue;
    const double truth =
        0.55 * std::max(0.0, 1.0 - distance / 11.0) + 0.15 * (1.0 - walks * between(course, robot.heading) / pi) +
        0.15 * (1.0 -
                (walks * between(course, pose.heading) + (1.0 - walks) * between(robot.heading, pose.heading)) / pi) +
        0.15 * (1.0 - std::min(1.0, obstacles / 2.0));
    const double found = score(robot, pose, robots);
    ASSERT_NEAR(found, truth, 1e-8) << round;
    ASSERT_GE(found, 0.0);
    ASSERT_LE(found, 1.0);
    for (Point& each : robots) each.y = -each.y;
    ASSERT_NEAR(score({robot.x, -robot.y, -robot.heading}, {pose.x, -pose.y, -pose.heading}, robots), found, 1e-12);
  }
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

TEST(EffortToPosePlugin, PosesAfterTheOffsetAndRobotsOfBothTeams) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "effort_to_pose");
  Instance utility(plugin, EnvironmentBuilder{}.own(2));
  const FrameBuilder frame = FrameBuilder{}
                                 .own(2)
                                 .robot(2)
                                 .at(0, 0)
                                 .heading(0)
                                 .robot(3)
                                 .at(1, 0)
                                 .heading(0)
                                 .robot(4)
                                 .at(0.5, 0)
                                 .penalised()
                                 .task("striker")
                                 .at(3, 3)
                                 .after(2.2, 0);
  const Matrix out = utility.score(frame.build());
  ASSERT_EQ(out.rows(), 2u);
  EXPECT_NEAR(out(0, 0), 1.0 - 0.55 * 0.2 - 0.075, 1e-9);  // robot 3 is in the way; the penalised one is not there
  EXPECT_NEAR(out(1, 0), 1.0 - 0.55 * 1.2 / 11, 1e-9);
  EXPECT_NEAR(utility.score(FrameBuilder(frame).opponent(1.5, 0.1).build())(1, 0), 1.0 - 0.55 * 1.2 / 11 - 0.075, 1e-9);
  EXPECT_NEAR(utility.score(FrameBuilder(frame).opponent(1.5, 0.1).weight(0.3).build())(1, 0), 1.0 - 0.55 * 1.2 / 11,
              1e-9);
  EXPECT_NEAR(utility.score(FrameBuilder(frame).task("jolly").at(2.2, 0).heading(pi / 2).build())(0, 1),
              1.0 - 0.55 * 0.2 - 0.075 - 0.075, 1e-9);
}

REGISTA_UTILITY_CONTRACT(REGISTA_PLUGIN_FILE, "effort_to_pose", {.order_of_opponents_is_irrelevant = true});

}  // namespace
