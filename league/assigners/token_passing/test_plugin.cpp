// SPDX-License-Identifier: MIT
// The plugin in scenes: capabilities from distances or utilities, tokens by the ids of roles, packets that end.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

namespace {

using namespace regista::testkit;
using Rows = std::vector<std::int32_t>;
constexpr double forbidden = -std::numeric_limits<double>::infinity();
constexpr std::int32_t none = REGISTA_NO_TASK, unknown = REGISTA_UNKNOWN_TASK;

const Loaded& plugin() {
  static const Loaded loaded(REGISTA_PLUGIN_FILE, "token_passing");
  return loaded;
}

// Robots 1 to 3 at x = 0, 1, 2; tasks at x = 2, 1, -3. The first column is not the first id.
FrameBuilder line(int own, double time = 100.0) {
  FrameBuilder frame;
  frame.own(own).time(time).robot(1).at(0, 0).robot(2).at(1, 0).robot(3).at(2, 0);
  frame.task("jolly").at(2, 0).priority(0).task("striker").at(1, 0).priority(1).task("supporter").at(-3, 0).priority(2);
  return frame;
}

const std::vector<std::uint8_t>& last_said(Instance& instance) { return instance.host().offers.back().bytes; }

TEST(TokenPassingPlugin, TheCreatorKeepsAndPassesAndTheOthersTake) {
  Instance first(plugin(), EnvironmentBuilder{}.own(1)), third(plugin(), EnvironmentBuilder{}.own(3));
  // 0.82 for the most important task: able enough. The others go to who is nearest of the free ones.
  EXPECT_EQ(first.assign(line(1).build(), Matrix(3, 3)), (Rows{0, 1, 2}));
  EXPECT_EQ(first.describe(last_said(first)), "1 does jolly, striker with 2, supporter with 3 at 0.50");
  EXPECT_EQ(first.host().offers.back().urgency, 1.0);
  EXPECT_EQ(third.assign(line(3).build(), Matrix(3, 3)), (Rows{unknown, unknown, none}));  // waits for lower numbers
  third.receive(1, last_said(first), 100.0, 100.1);
  EXPECT_EQ(third.assign(line(3, 100.1).build(), Matrix(3, 3)), (Rows{0, 1, 2}));
  EXPECT_EQ(third.describe(last_said(third)), "3 does supporter at 0.50");
  EXPECT_EQ(third.host().offers.back().urgency, 0.0) << "an answer rides along";
}

TEST(TokenPassingPlugin, ForbiddenPairsAreNotAble) {
  Instance assigner(plugin(), EnvironmentBuilder{}.own(1));
  Matrix utilities(3, 3);
  utilities(0, 0) = utilities(0, 1) = utilities(1, 0) = forbidden;
  EXPECT_EQ(assigner.assign(line(1).build(), utilities), (Rows{2, 1, 0}));
}

TEST(TokenPassingPlugin, TheOffsetPlaceCounts) {
  SceneData data = line(1).build().data();
  std::swap(data.tasks[0].after[0], data.tasks[2].after[0]);
  Instance assigner(plugin(), EnvironmentBuilder{}.own(1));
  EXPECT_EQ(assigner.assign(Scene(data), Matrix(3, 3)), (Rows{0, 1, 2}));
  data.tasks[0].after[0] = -3.5;  // 0.68 < 0.7, and none is better: kept when the threshold has fallen
  EXPECT_EQ(Instance(plugin(), EnvironmentBuilder{}.own(1)).assign(Scene(data), Matrix(3, 3)), (Rows{0, 1, 2}));
}

TEST(TokenPassingPlugin, UtilitiesInsteadOfDistances) {
  Values values(plugin());
  values.set("capability", 1.0).set("full_utility", 0.5);
  Matrix utilities(3, 3);
  utilities(0, 0) = 0.34;  // 0.68: not able enough
  utilities(1, 0) = 0.36;  // 0.72
  utilities(2, 0) = 0.5;
  utilities(0, 1) = 0.35;  // 0.7
  utilities(1, 2) = 3.0;   // as 1
  Instance assigner(plugin(), EnvironmentBuilder{}.own(1), values);
  EXPECT_EQ(assigner.assign(line(1).build(), utilities), (Rows{1, 2, 0}));
}

TEST(TokenPassingPlugin, APassIsSaidUntilItIsAnswered) {
  Instance first(plugin(), EnvironmentBuilder{}.own(1)), second(plugin(), EnvironmentBuilder{}.own(2));
  const auto says = [&](const std::string& what) {
    return first.describe(last_said(first)).find(what) != std::string::npos;
  };
  for (int tick = 0; tick < 5; ++tick) {
    first.assign(line(1, 100.0 + tick).build(), Matrix(3, 3));
    EXPECT_TRUE(says("striker with 2")) << tick;
    first.transmitted(first.host().offers.back().handle);
  }
  second.receive(1, last_said(first), 104.0, 104.1);
  second.assign(line(2, 104.2).build(), Matrix(3, 3));
  first.receive(2, last_said(second), 104.2, 104.3);
  first.assign(line(1, 104.3).build(), Matrix(3, 3));
  EXPECT_FALSE(says("striker"));
  EXPECT_TRUE(says("supporter with 3"));
}

// Robot 2 speaks, and has no tokens.
TEST(TokenPassingPlugin, WhoDoesNotAnswerIsPassedOver) {
  Instance first(plugin(), EnvironmentBuilder{}.own(1));
  const auto with_2 = [&] { return first.describe(last_said(first)).find("striker with 2") != std::string::npos; };
  const auto two_tasks = [](double time) {
    SceneData data = line(1, time).build().data();
    data.tasks.pop_back();  // so that robot 3 is free
    return Scene(data);
  };
  for (int tick = 0; tick < 3; ++tick) {
    first.assign(two_tasks(100.0 + tick), Matrix(3, 2));
    first.transmitted(first.host().offers.back().handle);
  }
  EXPECT_TRUE(with_2());
  first.host().told.resize(2);
  regista_told_packet& packet = first.host().told[1].emplace();
  packet.size = sizeof packet;
  packet.time_sent = 104.0;
  first.assign(two_tasks(104.1), Matrix(3, 2));
  EXPECT_FALSE(with_2());
}

TEST(TokenPassingPlugin, AtTheReserveRolesGoByRank) {
  Instance third(plugin(), EnvironmentBuilder{}.own(3)), first(plugin(), EnvironmentBuilder{}.own(1));
  Matrix utilities(3, 3);
  utilities(0, 0) = forbidden;
  EXPECT_EQ(first.assign(line(1).build(), utilities), (Rows{1, 2, 0}));
  third.receive(1, last_said(first), 100.0, 100.1);
  EXPECT_EQ(third.assign(line(3, 100.1).build(), utilities), (Rows{1, 2, 0}));
  for (Instance* each : {&first, &third}) {
    each->host().budget.packets_left = 30;
    EXPECT_EQ(each->assign(line(3, 100.2).build(), utilities), (Rows{1, 0, 2}));
    EXPECT_FALSE(each->host().offers.back().waits());
    each->host().budget.packets_left = 1200;
  }
  EXPECT_EQ(third.assign(line(3, 100.3).build(), utilities)[2], none);  // it holds nothing any more
  first.assign(line(1, 100.3).build(), utilities);
  EXPECT_EQ(first.assign(line(1, 103.0).build(), utilities), (Rows{1, 2, 0}));
}

TEST(TokenPassingPlugin, WrongBytesAndSendersAreIgnored) {
  Instance first(plugin(), EnvironmentBuilder{}.own(1)), second(plugin(), EnvironmentBuilder{}.own(2));
  first.assign(line(1).build(), Matrix(3, 3));
  const std::vector<std::uint8_t> good = last_said(first);
  std::vector<std::uint8_t> longer = good, shorter(good.begin(), good.end() - 1);
  longer.push_back(0);
  for (const int sender : {-1, 0, 2, 8, 1000}) second.receive(sender, good, 100.0, 100.1);
  second.receive(1, longer, 100.0, 100.1);
  second.receive(1, {}, 100.0, 100.1);
  second.receive(1, std::vector<std::uint8_t>(200, 255), 100.0, 100.1);
  second.receive(3, good, 100.0, 100.1);  // robot 3 cannot say what robot 1 does
  EXPECT_EQ(second.assign(line(2, 100.2).build(), Matrix(3, 3)), (Rows{unknown, none, unknown}));
  second.receive(1, good, 100.0, 100.3);
  EXPECT_EQ(second.assign(line(2, 100.4).build(), Matrix(3, 3)), (Rows{0, 1, 2}));
  EXPECT_EQ(second.describe(shorter), "no tokens of this team");
}

// 64 tasks and one robot that knows of nobody: it holds all tokens, and tells those that fit.
TEST(TokenPassingPlugin, SaysWhatAPacketTakes) {
  std::vector<std::string> names;
  for (int id = 0; id < 64; ++id) names.push_back("role_" + std::to_string(id));
  for (const unsigned size : {7u, 22u}) {
    Instance assigner(plugin(), EnvironmentBuilder{}.team_size(size).own(5).roles(names));
    FrameBuilder frame;
    frame.team_size(static_cast<int>(size)).own(5).time(10.0).robot(5);
    SceneData data = frame.build().data();
    for (int id = 0; id < 64; ++id) {
      regista_task task{};
      task.id = id;
      task.priority = id;
      data.tasks.push_back(task);
    }
    EXPECT_EQ(assigner.assign(Scene(data), Matrix(1, 64)), (Rows{0}));
    EXPECT_EQ(assigner.host().refused, 0u);
    ASSERT_EQ(assigner.host().offers.size(), 1u);
    EXPECT_LE(last_said(assigner).size(), 62u);
    EXPECT_GT(last_said(assigner).size(), 50u);
  }
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "token_passing");

}  // namespace
