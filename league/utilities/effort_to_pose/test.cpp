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

using effort_to_pose::Direction, effort_to_pose::Point, effort_to_pose::Settings;
constexpr double pi = std::numbers::pi, close = 1e-9;

struct PoseOf {
  double x, y, heading;
};

std::vector<double> scores(const PoseOf& robot, const std::vector<PoseOf>& poses, const std::vector<Point>& robots = {},
                           const Settings& settings = {}) {
  std::vector<double> x, y, facing_x, facing_y, other_x, other_y, out(poses.size());
  for (const PoseOf& pose : poses) {
    const Direction facing = Direction::of(pose.heading);
    x.push_back(pose.x);
    y.push_back(pose.y);
    facing_x.push_back(facing.x);
    facing_y.push_back(facing.y);
  }
  for (const Point& each : robots) {
    other_x.push_back(each.x - robot.x);
    other_y.push_back(each.y - robot.y);
  }
  effort_to_pose::score_row({robot.x, robot.y}, Direction::of(robot.heading), {x, y, facing_x, facing_y},
                            {other_x, other_y}, settings, out.data());
  return out;
}

double score(const PoseOf& robot, const PoseOf& pose, const std::vector<Point>& robots = {},
             const Settings& settings = {}) {
  return scores(robot, {pose}, robots, settings)[0];
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

// What is left out beforehand would not have counted; also where a disc just touches the way.
TEST(EffortToPose, AsManyAreInTheWayAsOneByOne) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> anywhere(-3.0, 3.0);
  const auto place = [&](bool in_tenths) {
    const Point p{anywhere(random), anywhere(random)};
    return in_tenths ? Point{std::round(10.0 * p.x) / 10.0, std::round(10.0 * p.y) / 10.0} : p;
  };
  int most = 0;
  for (int round = 0; round < 5000; ++round) {
    const bool in_tenths = round % 2 == 0;
    const double radius = in_tenths ? 0.1 * (round % 7) : std::abs(anywhere(random)) / 3.0;
    Point way = place(in_tenths);
    if (round % 5 == 0) way.y = 0.0;
    if (round % 35 == 0) way.x = 0.0;
    std::vector<double> x, y;
    int truth = 0;
    for (int k = 0; k < 12; ++k) {
      const Point at = place(in_tenths);
      x.push_back(at.x);
      y.push_back(at.y);
      truth += effort_to_pose::in_the_way(at, way.x, way.y, radius) ? 1 : 0;
    }
    const auto count = [&](double enough) {
      return effort_to_pose::count_in_the_way({x, y}, way.x, way.y, radius, enough);
    };
    ASSERT_EQ(count(100.0), truth) << round;
    ASSERT_EQ(std::min(1.0, count(2.5) / 2.5), std::min(1.0, truth / 2.5)) << round;
    most = std::max(most, truth);
  }
  EXPECT_GT(most, 4);
}

// Several at once or each alone: the same bits.
TEST(EffortToPose, ARowIsItsGoalsOneByOne) {
  std::mt19937 random(22);
  std::uniform_real_distribution<double> x(-4.5, 4.5), y(-3.0, 3.0), angle(-pi, pi);
  for (int round = 0; round < 500; ++round) {
    const PoseOf robot{x(random), y(random), angle(random)};
    std::vector<PoseOf> poses{robot};  // on the spot
    for (int k = 0; k < round % 13; ++k) poses.push_back({x(random), y(random), angle(random)});
    std::vector<Point> robots;
    for (int k = 0; k < round % 14; ++k) robots.push_back({x(random), y(random)});
    const std::vector<double> row = scores(robot, poses, robots);
    for (std::size_t j = 0; j < poses.size(); ++j) ASSERT_EQ(row[j], score(robot, poses[j], robots)) << round;
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
