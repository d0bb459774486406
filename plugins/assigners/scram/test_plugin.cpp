// SPDX-License-Identifier: MIT
// The plugin in scenes: distances or utilities, forbidden pairs, and the vote among teammates.
#include <gtest/gtest.h>

#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"
#include "vote.hpp"

namespace {

using namespace regista::testkit;
using Rows = std::vector<std::int32_t>;
constexpr double forbidden = -std::numeric_limits<double>::infinity();

const Loaded& scram_plugin() {
  static const Loaded plugin(REGISTA_PLUGIN_FILE, "scram");
  return plugin;
}

// Robots 1 to 3 at x = 0, 1, 2; tasks at x = 1, 2, 3.
FrameBuilder line() {
  FrameBuilder frame;
  frame.own(2).time(100.0).robot(1).at(0, 0).robot(2).at(1, 0).robot(3).at(2, 0);
  frame.task("striker").at(1, 0).priority(0).task("supporter").at(2, 0).priority(1).task("jolly").at(3, 0).priority(2);
  return frame;
}

TEST(ScramPlugin, WalksAreMeasuredFromTheFrameNotTheUtilities) {
  Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2));
  EXPECT_EQ(assigner.assign(line().build(), Matrix(3, 3)), (Rows{0, 1, 2}));
  Matrix utilities(3, 3);
  utilities(0, 0) = utilities(1, 1) = utilities(2, 2) = forbidden;
  // Two ways are left: walks of 2, 2 and 1, or of 3, 0 and 0.
  EXPECT_EQ(assigner.assign(line().build(), utilities), (Rows{1, 2, 0}));
}

TEST(ScramPlugin, TheOffsetPlaceCounts) {
  SceneData data = line().build().data();
  data.tasks[0].after[0] = 3.0;
  data.tasks[2].after[0] = 1.0;
  Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2));
  EXPECT_EQ(assigner.assign(Scene(data), Matrix(3, 3)), (Rows{2, 1, 0}));
}

TEST(ScramPlugin, UtilitiesInsteadOfDistances) {
  Matrix utilities(2, 2);
  utilities(0, 0) = 9;
  utilities(0, 1) = 5;
  utilities(1, 0) = 6;
  utilities(1, 1) = 0;
  FrameBuilder frame;
  frame.own(2).robot(1).at(0, 0).robot(2).at(1, 0).task("striker").at(0, 0).task("supporter").at(1, 0);
  for (const int criterion : {0, 1}) {
    Values values(scram_plugin());
    values.set("cost", 1.0).set("criterion", static_cast<double>(criterion));
    Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2), values);
    EXPECT_EQ(assigner.assign(frame.build(), utilities), (Rows{1, 0})) << criterion;  // nobody below 5
  }
}

TEST(ScramPlugin, TheLeastImportantTaskStaysOpenUnlessItIsRequired) {
  Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2));
  SceneData data = line().build().data();
  data.mine.robots[0].flags &= ~std::uint32_t{REGISTA_ROBOT_ACTIVE};
  EXPECT_EQ(assigner.assign(Scene(data), Matrix(2, 3)), (Rows{0, 1}));
  data.tasks[2].flags |= REGISTA_TASK_REQUIRED;
  EXPECT_EQ(assigner.assign(Scene(data), Matrix(2, 3)), (Rows{0, 2}));
}

// --- The vote --------------------------------------------------------------------------------------------------

Values voting() {
  Values values(scram_plugin());
  values.set("vote", 1.0);
  return values;
}

TEST(ScramPlugin, WithoutVoteNothingIsOffered) {
  Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2));
  assigner.assign(line().build(), Matrix(3, 3));
  EXPECT_TRUE(assigner.host().offers.empty());
}

// What a robot that sees the line the other way round would send: the real bytes of another instance.
std::vector<std::uint8_t> vote_of_a_mirrored_robot(int own) {
  SceneData data = line().own(own).build().data();
  std::swap(data.mine.robots[0].pose[0], data.mine.robots[2].pose[0]);
  Instance other(scram_plugin(), EnvironmentBuilder{}.own(own), voting());
  EXPECT_EQ(other.assign(Scene(data), Matrix(3, 3)), (Rows{2, 1, 0}));
  EXPECT_EQ(other.host().offers.size(), 1u);
  return other.host().offers.front().bytes;
}

TEST(ScramPlugin, TheRecentMajorityIsPlayed) {
  Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2), voting());
  const auto at = [](double time) { return line().time(time).build(); };
  EXPECT_EQ(assigner.assign(at(100.0), Matrix(3, 3)), (Rows{0, 1, 2}));
  for (const int sender : {1, 3}) assigner.receive(sender, vote_of_a_mirrored_robot(sender), 100.0, 100.1);
  EXPECT_EQ(assigner.assign(at(101.0), Matrix(3, 3)), (Rows{2, 1, 0}));
  EXPECT_EQ(assigner.assign(at(111.0), Matrix(3, 3)), (Rows{0, 1, 2}));  // the votes are too old
  assigner.reset(1);
  EXPECT_EQ(assigner.assign(at(101.0), Matrix(3, 3)), (Rows{0, 1, 2}));
}

TEST(ScramPlugin, AForbiddenMajorityIsNotPlayed) {
  Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2), voting());
  for (const int sender : {1, 3}) assigner.receive(sender, vote_of_a_mirrored_robot(sender), 100.0, 100.1);
  Matrix utilities(3, 3);
  utilities(0, 2) = forbidden;
  EXPECT_EQ(assigner.assign(line().build(), utilities), (Rows{0, 1, 2}));
  EXPECT_EQ(assigner.assign(line().build(), Matrix(3, 3)), (Rows{2, 1, 0}));
  SceneData data = line().build().data();
  data.mine.robots[0].flags &= ~std::uint32_t{REGISTA_ROBOT_ACTIVE};  // robot 1, which the ballots name
  EXPECT_EQ(assigner.assign(Scene(data), Matrix(2, 3)), (Rows{0, 1}));
}

TEST(ScramPlugin, OtherTasksMakeVotesVoid) {
  Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2), voting());
  assigner.assign(line().build(), Matrix(3, 3));
  for (const int sender : {1, 3}) assigner.receive(sender, vote_of_a_mirrored_robot(sender), 100.0, 100.1);
  EXPECT_EQ(assigner.assign(line().build(), Matrix(3, 3)), (Rows{2, 1, 0}));
  SceneData other = line().build().data();
  other.tasks[2].id = 11;
  EXPECT_EQ(assigner.assign(Scene(other), Matrix(3, 3)), (Rows{0, 1, 2}));
  EXPECT_EQ(assigner.assign(line().build(), Matrix(3, 3)), (Rows{0, 1, 2}));
}

TEST(ScramPlugin, SaysWhatAVoteIsFor) {
  Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2), voting());
  const std::string said = assigner.describe(vote_of_a_mirrored_robot(1));
  EXPECT_EQ(said.substr(0, 24), "vote for tasks of print ");
  EXPECT_EQ(said.substr(25), ": 3 2 1");
  EXPECT_EQ(assigner.describe(std::vector<std::uint8_t>(40)), "no vote of this team");
  EXPECT_EQ(assigner.describe({}), "no vote");
}

TEST(ScramPlugin, OneVoteIsPendingAlways) {
  Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2), voting());
  assigner.assign(line().build(), Matrix(3, 3));
  assigner.assign(line().build(), Matrix(3, 3));
  ASSERT_EQ(assigner.host().offers.size(), 1u);
  EXPECT_EQ(assigner.host().offers[0].bytes.size(), scram::ballot_bytes(3, 7));
  EXPECT_EQ(assigner.host().offers[0].expiry, 110.0);
  assigner.transmitted(assigner.host().offers[0].handle);
  assigner.assign(line().build(), Matrix(3, 3));
  ASSERT_EQ(assigner.host().offers.size(), 2u);
  EXPECT_EQ(assigner.host().offers[1].replaces, 0u);
  SceneData mirrored = line().build().data();
  std::swap(mirrored.mine.robots[0].pose[0], mirrored.mine.robots[2].pose[0]);
  assigner.assign(Scene(mirrored), Matrix(3, 3));
  ASSERT_EQ(assigner.host().offers.size(), 3u);
  EXPECT_EQ(assigner.host().offers[2].replaces, assigner.host().offers[1].handle);
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "scram");

}  // namespace
