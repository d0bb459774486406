// SPDX-License-Identifier: MIT
// Against triangles with whole sides, and the invariants of a distance.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using distance_utility::Point;

TEST(Distance, PythagoreanTriangles) {
  const std::vector<Point> robots{{0.0, 0.0}, {3.0, 4.0}};
  const std::vector<double> x{3.0, 0.0, -5.0}, y{4.0, 0.0, 12.0};
  std::vector<double> out(8, -1.0);
  distance_utility::score(robots, {x, y}, 10.0, out.data(), 4);
  EXPECT_DOUBLE_EQ(out[0], 0.5);  // 5 m of 10
  EXPECT_DOUBLE_EQ(out[1], 1.0);  // there
  EXPECT_DOUBLE_EQ(out[2], 0.0);  // 13 m: out of reach
  EXPECT_DOUBLE_EQ(out[3], -1.0) << "wrote between the rows";
  EXPECT_DOUBLE_EQ(out[4], 1.0);
  EXPECT_DOUBLE_EQ(out[5], 0.5);
  EXPECT_DOUBLE_EQ(out[6], 0.0);  // (8, 8): 11.3 m
  EXPECT_DOUBLE_EQ(out[7], -1.0);
}

TEST(Distance, NearerIsNeverWorseAndAllIsInRange) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-6.0, 6.0);
  for (int round = 0; round < 1000; ++round) {
    const std::vector<Point> robot{{anywhere(random), anywhere(random)}};
    std::vector<double> x(2), y(2), out(2);
    for (int j = 0; j < 2; ++j) {
      x[static_cast<std::size_t>(j)] = anywhere(random);
      y[static_cast<std::size_t>(j)] = anywhere(random);
    }
    distance_utility::score(robot, {x, y}, 11.0, out.data(), 2);
    const double d0 = std::hypot(x[0] - robot[0].x, y[0] - robot[0].y);
    const double d1 = std::hypot(x[1] - robot[0].x, y[1] - robot[0].y);
    if (d0 < d1) {
      EXPECT_GE(out[0], out[1]);
    } else {
      EXPECT_LE(out[0], out[1]);
    }
    for (const double value : out) {
      EXPECT_GE(value, 0.0);
      EXPECT_LE(value, 1.0);
    }
  }
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

TEST(DistancePlugin, ActiveRobotsAgainstTasksAfterTheirOffset) {
  Instance utility(Loaded(REGISTA_PLUGIN_FILE, "distance"), EnvironmentBuilder{}.own(2));
  const Scene scene = FrameBuilder{}
                          .own(2)
                          .robot(2)
                          .at(0, 0)
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
  const Matrix out = utility.score(scene);
  ASSERT_EQ(out.rows(), 2u);
  EXPECT_DOUBLE_EQ(out(0, 0), 6.0 / 11.0);
  EXPECT_DOUBLE_EQ(out(0, 1), 1.0);
  EXPECT_DOUBLE_EQ(out(1, 0), 1.0);
  EXPECT_DOUBLE_EQ(out(1, 1), 6.0 / 11.0);
}

REGISTA_UTILITY_CONTRACT(REGISTA_PLUGIN_FILE, "distance", {.order_of_opponents_is_irrelevant = true});

}  // namespace
