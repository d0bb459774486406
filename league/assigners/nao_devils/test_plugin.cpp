// SPDX-License-Identifier: MIT
// The plugin in scenes: who makes a new map and when, who plays which, and what is said.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "../negotiation/told_map.hpp"

namespace {

using namespace regista::testkit;
using Rows = std::vector<std::int32_t>;
using Bytes = std::vector<std::uint8_t>;
using scram::away, scram::idle;

const Loaded& plugin() {
  static const Loaded loaded(REGISTA_PLUGIN_FILE, "nao_devils");
  return loaded;
}

int id(std::string_view role) {
  const auto& roles = usual_roles();
  return static_cast<int>(std::find(roles.begin(), roles.end(), role) - roles.begin());
}

// What a robot says that broadcasts this map. tasks: of robots 1, 2, ...; the rest of the seven does not play.
Bytes said(std::uint8_t serial, std::vector<std::int32_t> tasks) {
  tasks.resize(7, away);
  Bytes bytes;
  negotiation::BitWriter writer(bytes);
  writer.put(serial, 8);
  scram::MapCode(7, usual_roles().size()).write(tasks, writer);
  return bytes;
}

// Robots 1 to 3 at x = 0, 1, 2; striker, supporter, jolly at x = 1, 2, 3: the best map is 1 m for all. The other way
// round it is 3 m for robot 1.
FrameBuilder line(int own) {
  FrameBuilder frame;
  frame.own(own).time(100.0).robot(1).at(0, 0).robot(2).at(1, 0).robot(3).at(2, 0);
  frame.task("striker").at(1, 0).task("supporter").at(2, 0).task("jolly").at(3, 0);
  return frame;
}
const Rows best{0, 1, 2}, other_way{2, 1, 0};
std::vector<std::int32_t> other_way_map() { return {id("jolly"), id("supporter"), id("striker")}; }

struct Robot {
  int own;
  Instance instance;
  explicit Robot(int number, double margin = 1.0)
      : own(number), instance(plugin(), EnvironmentBuilder{}.own(number), Values(plugin()).set("margin", margin)) {}
  Rows assign(const Scene& scene) {
    return instance.assign(scene, Matrix(static_cast<unsigned>(scene.rows()), static_cast<unsigned>(scene.columns())));
  }
  void hear(int sender, const Bytes& bytes) { instance.receive(sender, bytes, 99.0, 99.1); }
  // What it has offered last, if that was not withdrawn.
  const RecordingHost::Offered* pending() {
    const auto& offers = instance.host().offers;
    return offers.empty() || !offers.back().waits() ? nullptr : &offers.back();
  }
  bool makes_a_map() { return pending() != nullptr && pending()->urgency == 1.0; }
};

TEST(NaoDevils, WithoutAMapAnyoneMakesOneAndPlaysItsOwn) {
  for (const int own : {1, 2, 3}) {
    Robot robot(own);
    EXPECT_EQ(robot.assign(line(own).build()), best);
    ASSERT_TRUE(robot.makes_a_map());
    EXPECT_EQ(robot.pending()->bytes, said(1, {id("striker"), id("supporter"), id("jolly")}));
    EXPECT_EQ(robot.pending()->bytes.size(), 5u);  // 8 and 7 x 4 bits
  }
}

TEST(NaoDevils, OnlyTheChaserOfTheLastMessageMakesANewOne) {
  // By the map robot 3 is the striker. Who says so in its last packet?
  const auto makes = [](int own, std::vector<std::pair<int, double>> claims) {
    Robot robot(own);
    robot.hear(2, said(1, other_way_map()));
    const Scene scene = line(own)
                            .common([&](WorldBuilder& world) {
                              for (const auto& [number, since] : claims)
                                world.robot(number).role("striker").since(since);
                            })
                            .build();
    EXPECT_EQ(robot.assign(scene), other_way);  // the new one is played when it is out
    return robot.makes_a_map();
  };
  EXPECT_TRUE(makes(3, {{3, 50.0}}));
  EXPECT_FALSE(makes(3, {}));
  EXPECT_FALSE(makes(3, {{3, 50.0}, {1, 60.0}}));
  EXPECT_TRUE(makes(3, {{3, 50.0}, {1, 40.0}}));
  EXPECT_FALSE(makes(3, {{3, 50.0}, {1, 50.0}}));  // at once: the lower number
  EXPECT_FALSE(makes(1, {{1, 50.0}}));
  EXPECT_FALSE(makes(2, {{3, 50.0}}));
}

TEST(NaoDevils, TheAuthorPlaysItsMapFromWhenItIsSentAndRepeatsIt) {
  Robot robot(3);
  robot.hear(2, said(7, other_way_map()));
  const Scene scene = line(3).common([](WorldBuilder& world) { world.robot(3).role("striker"); }).build();
  EXPECT_EQ(robot.assign(scene), other_way);
  EXPECT_EQ(robot.assign(scene), other_way);
  const Bytes map = said(8, {id("striker"), id("supporter"), id("jolly")});
  ASSERT_TRUE(robot.makes_a_map());
  EXPECT_EQ(robot.pending()->bytes, map);
  const auto handle = robot.pending()->handle;
  robot.instance.transmitted(handle);
  EXPECT_EQ(robot.assign(scene), best);
  ASSERT_NE(robot.pending(), nullptr);
  EXPECT_NE(robot.pending()->handle, handle);
  EXPECT_EQ(robot.pending()->urgency, 0.0);
  EXPECT_EQ(robot.pending()->bytes, map);
  robot.hear(1, said(9, other_way_map()));
  EXPECT_EQ(robot.assign(line(3).build()), other_way);
  EXPECT_EQ(robot.pending(), nullptr);  // it is no longer the author of the newest
}

TEST(NaoDevils, WhatIsDroppedWasNotBroadcast) {
  Robot robot(3);
  robot.hear(2, said(7, other_way_map()));
  const Scene scene = line(3).common([](WorldBuilder& world) { world.robot(3).role("striker"); }).build();
  robot.assign(scene);
  robot.instance.dropped(robot.pending()->handle);
  EXPECT_EQ(robot.assign(scene), other_way);
  EXPECT_TRUE(robot.makes_a_map());
}

// Against all permutations, up to six robots: a new map is made just when the last one's longest walk is more than the
// margin above the least possible.
TEST(NaoDevils, TheMapIsKeptIffItsLongestWalkIsWithinTheMargin) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(-4.5, 4.5), y(-3.0, 3.0);
  std::map<std::size_t, Robot> robots;
  int kept = 0, given_up = 0;
  for (int round = 0; round < 3000; ++round) {
    const std::size_t n = 1 + random() % 6;
    std::vector<double> rx(n), ry(n), tx(n), ty(n);
    std::vector<std::int32_t> tasks(n);
    for (std::size_t j = 0; j < n; ++j) {
      rx[j] = x(random), ry[j] = y(random), tx[j] = x(random), ty[j] = y(random);
      tasks[j] = id("striker") + static_cast<int>(j);
    }
    std::vector<std::int32_t> last = tasks, trial = tasks;
    std::shuffle(last.begin(), last.end(), random);
    const auto longest = [&](const std::vector<std::int32_t>& map) {
      double walk = 0.0;
      for (std::size_t i = 0; i < n; ++i) {
        const auto j = static_cast<std::size_t>(map[i] - tasks[0]);
        walk = std::max(walk, std::hypot(rx[i] - tx[j], ry[i] - ty[j]));
      }
      return walk;
    };
    double least = longest(trial);
    while (std::next_permutation(trial.begin(), trial.end())) least = std::min(least, longest(trial));
    const auto holder = static_cast<int>(std::find(last.begin(), last.end(), tasks[0]) - last.begin()) + 1;
    FrameBuilder frame;
    frame.own(holder);
    for (std::size_t i = 0; i < n; ++i) {
      frame.robot(static_cast<int>(i + 1)).at(rx[i], ry[i]);
      if (static_cast<int>(i + 1) == holder) frame.role("striker");
    }
    for (std::size_t j = 0; j < n; ++j) frame.task(tasks[j]).at(tx[j], ty[j]);
    Robot& robot = robots.try_emplace(static_cast<std::size_t>(holder), holder).first->second;
    robot.instance.reset(1);
    robot.instance.host().offers.clear();
    robot.hear(7, said(1, [&] {
                 std::vector<std::int32_t> map = last;
                 map.resize(7, away);
                 return map;
               }()));
    robot.assign(frame.build());
    const bool keeps = longest(last) <= least + 1.0;
    ASSERT_EQ(robot.makes_a_map(), !keeps) << "round " << round;
    (keeps ? kept : given_up) += 1;
  }
  EXPECT_GT(kept, 500);
  EXPECT_GT(given_up, 500);
}

TEST(NaoDevils, AllPlayTheNewestMapInWhicheverOrderTheyHearThem) {
  std::mt19937 random(4);
  Robot robot(2);
  const Scene scene = line(2).build();
  for (int round = 0; round < 1000; ++round) {
    robot.instance.reset(1);
    std::map<std::pair<int, int>, Rows> maps;  // by serial and author, the lower of two authors last
    std::vector<std::pair<int, Bytes>> packets;
    for (int k = 0; k < 6; ++k) {
      Rows columns{0, 1, 2};
      std::shuffle(columns.begin(), columns.end(), random);
      const int serial = 200 + static_cast<int>(random() % 90), author = random() % 2 == 0 ? 1 : 3;
      if (!maps.try_emplace({serial, -author}, columns).second) continue;
      std::vector<std::int32_t> tasks;
      for (const std::int32_t column : columns)
        tasks.push_back(scene.data().tasks[static_cast<std::size_t>(column)].id);
      packets.emplace_back(author, said(static_cast<std::uint8_t>(serial), tasks));
    }
    std::shuffle(packets.begin(), packets.end(), random);
    for (const auto& [author, bytes] : packets) robot.hear(author, bytes);
    ASSERT_EQ(robot.assign(scene), maps.rbegin()->second);
  }
}

TEST(NaoDevils, WhenARobotLeavesAnyoneMakesANewMap) {
  Robot robot(2);
  robot.hear(3, said(1, other_way_map()));
  EXPECT_EQ(robot.assign(line(2).build()), other_way);
  EXPECT_FALSE(robot.makes_a_map());
  SceneData data = line(2).build().data();
  data.mine.robots[2].flags &= ~std::uint32_t{REGISTA_ROBOT_ACTIVE};
  data.tasks.pop_back();
  EXPECT_EQ(robot.assign(Scene(data)), (Rows{0, 1}));  // its own best
  ASSERT_TRUE(robot.makes_a_map());
  EXPECT_EQ(robot.pending()->bytes, said(2, {id("striker"), id("supporter")}));
  robot.hear(1, said(2, {id("supporter"), id("striker")}));  // who was faster
  EXPECT_EQ(robot.assign(Scene(data)), (Rows{1, 0}));
  EXPECT_EQ(robot.pending(), nullptr);
}

TEST(NaoDevils, AnotherListOfRolesNeedsAnotherMap) {
  Robot robot(2);
  robot.hear(3, said(1, other_way_map()));
  EXPECT_EQ(robot.assign(line(2).build()), other_way);
  SceneData data = line(2).build().data();
  data.tasks[1].id = id("search_1");
  // Robot 2 has lost its task: it makes a new map. Another robot takes what is open and waits for it.
  EXPECT_EQ(robot.assign(Scene(data)), best);
  EXPECT_TRUE(robot.makes_a_map());
  Robot third(3);
  third.hear(1, said(1, other_way_map()));
  SceneData of_third = data;
  of_third.own_number = 3;
  EXPECT_EQ(third.assign(Scene(of_third)), other_way);
  EXPECT_FALSE(third.makes_a_map());
  of_third.tasks[2].id = id("search_2");
  third.assign(line(3).build());
  EXPECT_EQ(third.assign(Scene(of_third)), best);
  EXPECT_TRUE(third.makes_a_map());
}

TEST(NaoDevils, ARobotThatDoesNotPlaySaysNothing) {
  Robot robot(2);
  SceneData data = line(2).build().data();
  data.mine.robots[1].flags &= ~std::uint32_t{REGISTA_ROBOT_ACTIVE};
  robot.assign(Scene(data));
  EXPECT_EQ(robot.pending(), nullptr);
}

TEST(NaoDevils, AtFivePacketsRolesGoByRank) {
  Robot robot(3);
  robot.hear(2, said(7, other_way_map()));
  const Scene scene = line(3).common([](WorldBuilder& world) { world.robot(3).role("striker"); }).build();
  robot.instance.host().budget.packets_left = 6;
  EXPECT_EQ(robot.assign(scene), other_way);
  EXPECT_TRUE(robot.makes_a_map());
  robot.instance.host().budget.packets_left = 5;
  EXPECT_EQ(robot.assign(scene), best);
  EXPECT_EQ(robot.pending(), nullptr);
  robot.instance.host().budget.packets_left = 6;
  EXPECT_EQ(robot.assign(scene), other_way);
}

TEST(NaoDevils, SaysWhatAMapIs) {
  Robot robot(2);
  EXPECT_EQ(robot.instance.describe(said(12, {id("goalkeeper"), idle, id("striker")})),
            "map 12: 1 goalkeeper, 2 idle, 3 striker");
  EXPECT_EQ(robot.instance.describe({}), "no map of this team");
  EXPECT_EQ(robot.instance.describe(Bytes(40)), "no map of this team");
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "nao_devils");

}  // namespace
