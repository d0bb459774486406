// SPDX-License-Identifier: MIT
// Against bearings computed with atan2, and the claims that the algorithm's head makes.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using bearing_utility::Form;
using bearing_utility::Pose;

constexpr double pi = std::numbers::pi;

double one(const Pose& robot, double x, double y, Form form) {
  double out = -1.0;
  const auto placed = bearing_utility::robot_at(robot);
  bearing_utility::score({&placed, 1}, {{&x, 1}, {&y, 1}}, form, &out, 1);
  return out;
}

TEST(Bearing, AgreesWithTheAngleByAtan2) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> anywhere(-5.0, 5.0), any_heading(-pi, pi);
  for (int round = 0; round < 10000; ++round) {
    const Pose robot{anywhere(random), anywhere(random), any_heading(random)};
    const double x = anywhere(random), y = anywhere(random);
    const double error = std::abs(std::remainder(std::atan2(y - robot.y, x - robot.x) - robot.heading, 2.0 * pi));
    EXPECT_NEAR(one(robot, x, y, Form::angle), (pi - error) / pi, 1e-7);
    EXPECT_NEAR(one(robot, x, y, Form::cosine), (1.0 + std::cos(error)) / 2.0, 1e-12);
  }
}

TEST(Bearing, BothFormsMeetAheadAsideAndBehind) {
  const Pose robot{1.0, 2.0, pi / 2.0};
  for (const Form form : {Form::cosine, Form::angle}) {
    EXPECT_NEAR(one(robot, 1.0, 5.0, form), 1.0, 1e-7);
    EXPECT_NEAR(one(robot, 4.0, 2.0, form), 0.5, 1e-12);
    EXPECT_NEAR(one(robot, -4.0, 2.0, form), 0.5, 1e-12);
    EXPECT_NEAR(one(robot, 1.0, -3.0, form), 0.0, 1e-7);
  }
}

TEST(Bearing, FormsDifferByAtMostWhatIsDocumented) {
  double largest = 0.0;
  for (int step = 0; step <= 10000; ++step) {
    const double cosine = std::cos(pi * step / 10000.0);
    largest = std::max(largest, std::abs(bearing_utility::from_cosine<Form::cosine>(cosine) -
                                         bearing_utility::from_cosine<Form::angle>(cosine)));
  }
  EXPECT_LT(largest, 0.1055);
  EXPECT_GT(largest, 0.1045);
}

TEST(Bearing, ADirectionIsThatOfItsLastHeading) {
  bearing_utility::Direction direction;
  EXPECT_EQ(direction.x(), std::cos(0.0));
  EXPECT_EQ(direction.y(), std::sin(0.0));
  for (const double heading : {-0.0, 0.0, 1.0, 1.0, -2.5, 0.0}) {
    direction.turn(heading);
    EXPECT_EQ(direction.x(), std::cos(heading));
    EXPECT_EQ(direction.y(), std::sin(heading));
    EXPECT_EQ(std::signbit(direction.y()), std::signbit(std::sin(heading)));
  }
}

TEST(Bearing, ARobotOnTheSpotNeedNotTurn) {
  EXPECT_EQ(one({1.0, 1.0, 2.0}, 1.0, 1.0, Form::cosine), 1.0);
  EXPECT_EQ(one({1.0, 1.0, 2.0}, 1.0, 1.0, Form::angle), 1.0);
}

// Rows are computed two entries at a time where the processor can: to the last bit as one entry at a time, whatever the
// number of targets and the place in the row.
TEST(Bearing, ARowIsItsEntries) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-5.0, 5.0), any_heading(-pi, pi);
  for (std::size_t columns = 1; columns <= 13; ++columns) {
    std::vector<double> x(columns), y(columns), out(3 * 16, -1.0);
    for (std::size_t j = 0; j < columns; ++j) {
      x[j] = anywhere(random);
      y[j] = anywhere(random);
    }
    std::vector<Pose> robots(3);
    for (Pose& robot : robots) robot = {anywhere(random), anywhere(random), any_heading(random)};
    robots[1] = {x[0], y[0], 0.3};  // on the spot
    for (const Form form : {Form::cosine, Form::angle}) {
      std::vector<bearing_utility::Robot> placed;
      for (const Pose& robot : robots) placed.push_back(bearing_utility::robot_at(robot));
      bearing_utility::score(placed, {x, y}, form, out.data(), 16);
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < columns; ++j) EXPECT_EQ(out[i * 16 + j], one(robots[i], x[j], y[j], form));
        EXPECT_EQ(out[i * 16 + columns], -1.0) << "wrote behind the row";
      }
    }
  }
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

TEST(BearingPlugin, FacesTheTaskOrTheGoal) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "bearing");
  const Scene scene = FrameBuilder{}
                          .own(2)
                          .robot(2)
                          .at(0, 0)
                          .heading(pi / 2)
                          .task("striker")
                          .at(0, 3)
                          .task("supporter")
                          .at(0, -3)
                          .build();
  Instance task(plugin, EnvironmentBuilder{}, Values(plugin).set("form", "angle"));
  EXPECT_NEAR(task.score(scene)(0, 0), 1.0, 1e-7);
  EXPECT_NEAR(task.score(scene)(0, 1), 0.0, 1e-7);
  Instance goal(plugin, EnvironmentBuilder{}, Values(plugin).set("form", "angle").set("towards", "opponent_goal"));
  EXPECT_NEAR(goal.score(scene)(0, 0), 0.5, 1e-12);
  EXPECT_NEAR(goal.score(scene)(0, 1), 0.5, 1e-12);
}

REGISTA_UTILITY_CONTRACT(REGISTA_PLUGIN_FILE, "bearing", {.order_of_opponents_is_irrelevant = true});

}  // namespace
