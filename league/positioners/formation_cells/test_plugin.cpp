// SPDX-License-Identifier: MIT
// The plugin in scenes: which tasks have cells, and to which task a point belongs.
#include <gtest/gtest.h>
#include <regista/testkit/count_allocations.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

namespace {

using namespace regista::testkit;

const Loaded& plugin() {
  static const Loaded loaded(REGISTA_PLUGIN_FILE, "formation_cells");
  return loaded;
}

// Four roles for the robots 1, 2 and 4; the goalkeeper is robot 1's.
FrameBuilder scene() {
  FrameBuilder frame;
  frame.own(2).robot(1).at(-4, 0).robot(2).at(3, 0).robot(4).at(-3, -1).ball(0, 0);
  frame.task("goalkeeper").at(-4, 0).only_for(1).task("striker").at(0, 0).required();
  frame.task("supporter").at(-2, 0).task("jolly").at(2, 1);
  return frame;
}

std::vector<int> tasks_of(const Placed& placed) {
  std::vector<int> out;
  for (const regista_waypoint& point : placed.points) out.push_back(point.task);
  return out;
}

Values all_positions() {
  Values values(plugin());
  values.set("all_positions", 1.0);
  return values;
}

// The others' places are theirs. Whose role has no cell has none either.
TEST(FormationCellsPlugin, ThePlaceOfTheOwnRole) {
  Instance positioner(plugin(), EnvironmentBuilder{}.own(2)),
      all(plugin(), EnvironmentBuilder{}.own(2), all_positions());
  EXPECT_EQ(tasks_of(positioner.place(scene().build().before_placing())), std::vector<int>{});
  const Scene holds = scene().robot(2).role("supporter").robot(4).role("goalkeeper").build().before_placing();
  const Placed own = positioner.place(holds), both = all.place(holds);
  ASSERT_EQ(tasks_of(own), (std::vector<int>{2}));
  EXPECT_EQ(own.points[0].x, both.points[1].x);
  EXPECT_EQ(own.points[0].y, both.points[1].y);
  EXPECT_EQ(tasks_of(positioner.place(scene().robot(2).role("striker").build().before_placing())), std::vector<int>{});
}

TEST(FormationCellsPlugin, AsManyPositionsAsRobots) {
  Instance positioner(plugin(), EnvironmentBuilder{}.own(2), all_positions());
  EXPECT_EQ(tasks_of(positioner.place(scene().build().before_placing())), (std::vector<int>{0, 2}));
  FrameBuilder four = scene();
  four.robot(3).at(0, 2);
  EXPECT_EQ(tasks_of(positioner.place(four.build().before_placing())), (std::vector<int>{0, 2, 3}));
  FrameBuilder without = scene();
  without.robot(1).penalised();
  EXPECT_EQ(tasks_of(positioner.place(without.build().before_placing())), (std::vector<int>{2}));
}

TEST(FormationCellsPlugin, RolesThatAreLeftOut) {
  Values values = all_positions();
  values.set("left_out", "goalkeeper  supporter");
  Instance positioner(plugin(), EnvironmentBuilder{}.own(2), values);
  EXPECT_EQ(tasks_of(positioner.place(scene().build().before_placing())), (std::vector<int>{1}));
}

// The base point is free, the robot far: it walks there. Near, it stays where it is.
TEST(FormationCellsPlugin, TheHolderStandsOrWalks) {
  Instance positioner(plugin(), EnvironmentBuilder{}.own(2));
  const auto point = [&](double x) {
    const Placed placed = positioner.place(scene().robot(2).at(x, 0.5).role("supporter").build().before_placing());
    return placed.points.back();
  };
  EXPECT_NEAR(point(3.0).x, -2.0, 1.0);
  EXPECT_EQ(point(-1.9).x, -1.9);
  EXPECT_EQ(point(-1.9).y, 0.5);
  EXPECT_GT(point(-1.9).score, 0.0);
}

TEST(FormationCellsPlugin, OneHistoryOneResult) {
  Instance a(plugin(), EnvironmentBuilder{}.own(2), all_positions()),
      b(plugin(), EnvironmentBuilder{}.own(4), all_positions());
  for (int tick = 0; tick < 200; ++tick) {
    FrameBuilder frame = scene();
    frame.robot(2).at(3.0 - 0.025 * tick, 0.01 * tick).role("supporter").ball(0.02 * tick, 1.0);
    const Placed first = a.place(frame.build().before_placing()), second = b.place(frame.build().before_placing());
    ASSERT_EQ(first.points.size(), second.points.size());
    for (std::size_t i = 0; i < first.points.size(); ++i) {
      ASSERT_EQ(first.points[i].x, second.points[i].x);
      ASSERT_EQ(first.points[i].y, second.points[i].y);
    }
  }
}

std::vector<double> kept;  // outside of functions, so that no compiler leaves an allocation out

TEST(FormationCellsPlugin, NothingIsAllocated) {
  std::map<std::string, RecordingHost::CallCosts> costs;
  EnvironmentBuilder environment;
  environment.team_size(22).own(2);
  std::vector<std::string> names;
  for (int k = 0; k < 64; ++k) names.push_back("role_" + std::to_string(k));
  Instance positioner(plugin(), environment.roles(names), all_positions());
  positioner.host().costs = &costs;
  positioner.host().allocated = [] { return allocations; };  // but for the testkit's own
  std::size_t most_points = 0;
  const std::size_t all = allocations_during([&] {
    kept = std::vector<double>(1000);
    for (int k = 0; k < 23; ++k) {
      FrameBuilder frame;
      frame.team_size(22).own(2).roles(names).ball(0.1 * k, 0);
      for (int number = 1; number <= 22; ++number) frame.robot(number).at(0.3 * number - 3.0, 0.1 * k);
      for (int number = 22; number > 22 - k; --number) frame.robot(number).penalised();
      for (std::size_t j = 0; j < names.size(); ++j) {
        frame.task(names[j]).at(0.1 * static_cast<double>(j) - 3.0, 0.2 * static_cast<double>(j % 9) - 1.0);
      }
      most_points = std::max(most_points, positioner.place(frame.build().before_placing()).points.size());
    }
  });
  EXPECT_GT(all, 0u);  // it does count
  EXPECT_EQ(most_points, 22u);
  EXPECT_EQ(costs["place"].allocations, std::vector<std::size_t>(23, 0));
}

REGISTA_POSITIONER_CONTRACT(REGISTA_PLUGIN_FILE, "formation_cells");

}  // namespace
