// SPDX-License-Identifier: MIT
// Who was seen a moment ago is remembered, once, where it was on the field.
#include "mind/body/walking.hpp"

#include <gtest/gtest.h>

namespace regista::mind {
namespace {

class RobotMemoryTest : public testing::Test {
 protected:
  // Robots seen at `time`, in the robot frame of a robot that stands at `own`.
  void see(double time, const std::vector<Vector2d>& seen, const Pose& own = {}) {
    Percepts given;
    given.time = time;
    for (const Vector2d& each : seen) given.robots.push_back({each, 0.1, 0.1, false});
    memory.update(given, Frame2(own), 0.3);
  }
  RobotMemory memory;
};

TEST_F(RobotMemoryTest, RemembersForASecond) {
  see(1.0, {{1.0, 0.0}});
  see(1.9, {});
  ASSERT_EQ(memory.positions().size(), 1u);
  see(2.1, {});
  EXPECT_TRUE(memory.positions().empty());
}

TEST_F(RobotMemoryTest, PlacesAreOfTheField) {
  see(1.0, {{1.0, 0.5}}, {2.0, 1.0, pi / 2});
  see(1.1, {}, {0.0, 0.0, 0.0});
  ASSERT_EQ(memory.positions().size(), 1u);
  EXPECT_LT((memory.positions()[0] - Vector2d(1.5, 2.0)).norm(), 1e-12);
}

TEST_F(RobotMemoryTest, OneRobotIsRememberedOnceAndTwoTwice) {
  see(1.0, {{1.0, 0.0}});
  see(1.1, {{1.1, 0.0}});
  ASSERT_EQ(memory.positions().size(), 1u);
  EXPECT_EQ(memory.positions()[0], Vector2d(1.1, 0.0));
  see(1.2, {{1.1, 0.0}, {1.1, 0.3}});
  EXPECT_EQ(memory.positions().size(), 2u) << "both seen at once";
  see(1.3, {{1.1, 0.7}});
  EXPECT_EQ(memory.positions().size(), 3u);
}

TEST_F(RobotMemoryTest, WhoIsFarIsNotInTheWay) {
  see(1.0, {{1.9, 0.0}, {2.1, 0.0}});
  EXPECT_EQ(memory.positions().size(), 1u);
}

TEST_F(RobotMemoryTest, ForgetsTheOldestOfTooMany) {
  for (int k = 0; k < 20; ++k) see(1.0 + 0.01 * k, {{0.4 * (k % 5) - 0.8, 0.4 * (k / 5) - 0.6}});
  ASSERT_EQ(memory.positions().size(), 16u);
  EXPECT_LT((memory.positions().back() - Vector2d(0.8, 0.6)).norm(), 1e-12);
  EXPECT_LT((memory.positions().front() - Vector2d(0.8, -0.6)).norm(), 1e-12) << "the first four are gone";
}

}  // namespace
}  // namespace regista::mind
