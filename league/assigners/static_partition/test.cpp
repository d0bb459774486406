// SPDX-License-Identifier: MIT
// What is static about it: neither where robots are, nor who is missing, nor which tasks were filtered away, changes
// the role of a robot.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using Rows = std::vector<std::int32_t>;
using static_partition::forbidden;

Rows by_number(const std::vector<double>& values, const Rows& numbers, const Rows& places) {
  Rows out(numbers.size(), -7);
  static_partition::by_number({values.data(), numbers.size(), places.size(), places.size()}, numbers, places, out);
  return out;
}

Rows moving_up(const std::vector<double>& values, std::size_t rows, const std::vector<std::uint32_t>& order) {
  Rows out(rows, -7);
  static_partition::moving_up({values.data(), rows, order.size(), order.size()}, order, out);
  return out;
}

TEST(StaticPartition, RobotNTakesTheNthRole) {
  EXPECT_EQ(by_number(std::vector<double>(9, 0.5), {1, 2, 3}, {0, 1, 2}), (Rows{0, 1, 2}));
  EXPECT_EQ(by_number(std::vector<double>(9, 0.5), {1, 2, 3}, {2, 0, 1}), (Rows{1, 2, 0}));
}

TEST(StaticPartition, TheTaskOfAMissingRobotStaysOpen) {
  EXPECT_EQ(by_number(std::vector<double>(8, 0.5), {2, 4}, {0, 1, 2, 3}), (Rows{1, 3}));
}

TEST(StaticPartition, ARobotWhoseTaskIsMissingOrForbiddenStaysIdle) {
  EXPECT_EQ(by_number({0.5, 0.5, 0.5, forbidden}, {1, 3}, {0, 2}), (Rows{0, -1}));
  EXPECT_EQ(by_number(std::vector<double>(4, 0.5), {1, 2}, {0, 5}), (Rows{0, -1}));
}

TEST(StaticPartition, MovingUpLeavesTheLeastImportantOpen) {
  EXPECT_EQ(moving_up(std::vector<double>(6, 0.5), 2, {0, 1, 2}), (Rows{0, 1}));
  EXPECT_EQ(moving_up(std::vector<double>(6, 0.5), 2, {2, 1, 0}), (Rows{2, 1}));
  // The goalkeeper's task is for the goalkeeper only, who is out.
  EXPECT_EQ(moving_up({forbidden, 0.5, 0.5, forbidden, 0.5, 0.5}, 2, {0, 1, 2}), (Rows{1, 2}));
  EXPECT_EQ(moving_up(std::vector<double>(6, 0.5), 3, {0, 1}), (Rows{0, 1, -1}));
}

TEST(StaticPartition, NoRobotChangesWhatAnotherGets) {
  std::mt19937 random(14);
  for (int round = 0; round < 2000; ++round) {
    Rows numbers, places;
    for (std::int32_t n = 1; n <= 7; ++n) {
      if (random() % 4 != 0) numbers.push_back(n);
    }
    for (std::int32_t place = 0; place < 10; ++place) {
      if (random() % 3 != 0) places.push_back(place);
    }
    std::vector<double> values(numbers.size() * places.size());
    for (double& each : values) each = random() % 5 == 0 ? forbidden : static_cast<double>(random() % 100);
    const Rows together = by_number(values, numbers, places);
    for (std::size_t row = 0; row < numbers.size(); ++row) {
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(row * places.size());
      const std::vector<double> own(begin, begin + static_cast<std::ptrdiff_t>(places.size()));
      EXPECT_EQ(by_number(own, {numbers[row]}, places), (Rows{together[row]}));
      if (together[row] < 0) continue;
      EXPECT_EQ(places[static_cast<std::size_t>(together[row])], numbers[row] - 1);
    }
  }
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

Scene three_tasks_without_robot_two() {
  return FrameBuilder{}
      .own(3)
      .robot(1)
      .robot(3)
      .task("jolly")
      .priority(2)
      .task("striker")
      .priority(0)
      .task("supporter")
      .priority(1)
      .build();
}

TEST(StaticPartitionPlugin, ThePlaceInTheListCounts) {
  Instance assigner(Loaded(REGISTA_PLUGIN_FILE, "static_partition"), EnvironmentBuilder{}.own(3));
  EXPECT_EQ(assigner.assign(three_tasks_without_robot_two(), Matrix(2, 3)), (Rows{1, 0}));
}

TEST(StaticPartitionPlugin, OthersMoveUpWhenAsked) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "static_partition");
  Instance assigner(plugin, EnvironmentBuilder{}.own(3), Values(plugin).set("fill", 1.0));
  EXPECT_EQ(assigner.assign(three_tasks_without_robot_two(), Matrix(2, 3)), (Rows{1, 2}));
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "static_partition", {.may_idle = true});

}  // namespace
