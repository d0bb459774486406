// SPDX-License-Identifier: MIT
// Against triangles with whole sides, the C library's atan2, and the published formula.
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

using inverse_distance::angle_between;
using inverse_distance::Pose;
using inverse_distance::Settings;

constexpr double pi = std::numbers::pi;

double one(const Pose& robot, double x, double y, const Settings& settings) {
  double out = -1.0;
  inverse_distance::score({&robot, 1}, {{&x, 1}, {&y, 1}}, settings, &out, 1);
  return out;
}

TEST(InverseDistance, PythagoreanTriangles) {
  const std::vector<Pose> robots{{0.0, 0.0, 1.0}, {3.0, 4.0, 2.0}};
  const std::vector<double> x{3.0, 0.0, -5.0}, y{4.0, 0.0, 12.0};
  std::vector<double> out(8, -1.0);
  inverse_distance::score(robots, {x, y}, {0.5, 0.0}, out.data(), 4);
  EXPECT_DOUBLE_EQ(out[0], 1.0 / 5.5);
  EXPECT_DOUBLE_EQ(out[1], 2.0);
  EXPECT_DOUBLE_EQ(out[2], 1.0 / 13.5);
  EXPECT_DOUBLE_EQ(out[3], -1.0) << "wrote between the rows";
  EXPECT_DOUBLE_EQ(out[4], 2.0);
  EXPECT_DOUBLE_EQ(out[5], 1.0 / 5.5);
  EXPECT_DOUBLE_EQ(out[6], 1.0 / (std::sqrt(128.0) + 0.5));
  EXPECT_DOUBLE_EQ(out[7], -1.0);
}

TEST(InverseDistance, AtTheTaskItIsThePublishedBound) {
  EXPECT_DOUBLE_EQ(one({1.0, 2.0, 0.5}, 1.0, 2.0, {}), 1e10);
  EXPECT_DOUBLE_EQ(one({1.0, 2.0, 0.5}, 1.0, 2.0, {1e-10, 0.01}), 1.01e10);
  EXPECT_DOUBLE_EQ(one({1.0, 2.0, 0.5}, 1.0, 2.0, {1e-10, 10.0}), 1.1e11);  // the ends of the ranges: below 1e12
  EXPECT_NEAR(one({0.0, 0.0, 0.0}, 4.0, 0.0, {1e-10, 0.01}), 0.25 + 1e8, 1e-7);
}

TEST(InverseDistance, TheAngleIsThatOfTheCLibrary) {
  for (int step = 0; step <= 200000; ++step) {
    const double angle = pi * step / 200000.0, length = 1e-3 * (1 + step % 9973);
    const double dot = length * std::cos(angle), cross = (step % 2 == 0 ? 1.0 : -1.0) * length * std::sin(angle);
    const double expected = std::atan2(std::abs(cross), dot);
    const double found = angle_between(dot, cross, length);
    ASSERT_NEAR(found, expected, expected <= pi / 2.0 ? 1e-10 * expected : 2e-10) << angle;
    ASSERT_GE(found, 0.0);
    ASSERT_LE(found, pi);
  }
  EXPECT_EQ(angle_between(0.0, 0.0, 0.0), 0.0);
  EXPECT_EQ(angle_between(3.0, 0.0, 3.0), 0.0);
  EXPECT_EQ(angle_between(-3.0, 0.0, 3.0), pi);
  EXPECT_NEAR(angle_between(1.0, 1e-12, 1.0), 1e-12, 1e-22);
}

// Random pairs of a robot and a target: the formula with atan2, and the same in a field mirrored in y.
TEST(InverseDistance, ThePublishedFormula) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> anywhere(-5.0, 5.0), any_heading(-pi, pi);
  for (int round = 0; round < 10000; ++round) {
    const Pose robot{anywhere(random), anywhere(random), any_heading(random)};
    const double x = anywhere(random), y = anywhere(random);
    const double d = std::hypot(x - robot.x, y - robot.y);
    const double a = std::abs(std::remainder(std::atan2(y - robot.y, x - robot.x) - robot.heading, 2.0 * pi));
    for (const double w : {0.0, 0.01, 1.0}) {
      const double expected = 1.0 / (d + 1e-10) + w / (a + 1e-10);
      const double found = one(robot, x, y, {1e-10, w});
      EXPECT_NEAR(found, expected, 1e-9 * expected);
      EXPECT_EQ(one({robot.x, -robot.y, -robot.heading}, x, -y, {1e-10, w}), found) << "not mirrored";
    }
  }
}

// Rows are computed two entries at a time where the processor can: to the last bit as one entry at a time.
TEST(InverseDistance, ARowIsItsEntries) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> anywhere(-5.0, 5.0);
  for (std::size_t columns = 1; columns <= 13; ++columns) {
    std::vector<double> x(columns), y(columns), out(columns + 1, -1.0);
    for (std::size_t j = 0; j < columns; ++j) {
      x[j] = anywhere(random);
      y[j] = anywhere(random);
    }
    const Pose robot{x[0], y[0], 0.7};
    for (const double w : {0.0, 0.01}) {
      inverse_distance::score({&robot, 1}, {x, y}, {1e-10, w}, out.data(), columns + 1);
      for (std::size_t j = 0; j < columns; ++j) EXPECT_EQ(out[j], one(robot, x[j], y[j], {1e-10, w}));
      EXPECT_EQ(out[columns], -1.0) << "wrote behind the row";
    }
  }
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

TEST(InverseDistancePlugin, ActiveRobotsAgainstTasksAfterTheirOffset) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "inverse_distance");
  const Scene scene = FrameBuilder{}
                          .own(2)
                          .robot(2)
                          .at(0, 0)
                          .heading(pi / 2)
                          .robot(4)
                          .at(4, 0)
                          .penalised()
                          .robot(5)
                          .at(3, 4)
                          .task("striker")
                          .at(9, 9)
                          .after(3, 4)
                          .task("supporter")
                          .at(0, 0)
                          .build();
  Instance of_2023(plugin, EnvironmentBuilder{});
  const Matrix out = of_2023.score(scene);
  ASSERT_EQ(out.rows(), 2u);
  EXPECT_DOUBLE_EQ(out(0, 0), 1.0 / (5.0 + 1e-10));
  EXPECT_DOUBLE_EQ(out(0, 1), 1e10);
  EXPECT_DOUBLE_EQ(out(1, 0), 1e10);
  EXPECT_DOUBLE_EQ(out(1, 1), 1.0 / (5.0 + 1e-10));
  Instance of_2024(plugin, EnvironmentBuilder{}, Values(plugin).set("bearing_weight", 0.01));
  EXPECT_NEAR(of_2024.score(scene)(0, 0), 0.2 + 0.01 / std::atan(0.75), 1e-9);
}

REGISTA_UTILITY_CONTRACT(REGISTA_PLUGIN_FILE, "inverse_distance", {.order_of_opponents_is_irrelevant = true});

}  // namespace
