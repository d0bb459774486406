// SPDX-License-Identifier: MIT
// The plugin in scenes: which map is played, which votes are void, what is offered.
#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "../negotiation/told_map.hpp"

namespace {

using namespace regista::testkit;
using Rows = std::vector<std::int32_t>;
constexpr double forbidden = -std::numeric_limits<double>::infinity();

const Loaded& plugin() {
  static const Loaded loaded(REGISTA_PLUGIN_FILE, "scram_vote");
  return loaded;
}

// Robots 1 to 3 at x = 0, 1, 2; tasks at x = 1, 2, 3: alone a robot answers {0, 1, 2}.
FrameBuilder line() {
  FrameBuilder frame;
  frame.own(2).time(100.0).robot(1).at(0, 0).robot(2).at(1, 0).robot(3).at(2, 0);
  frame.task("striker").at(1, 0).priority(0).task("supporter").at(2, 0).priority(1).task("jolly").at(3, 0).priority(2);
  return frame;
}

std::unique_ptr<Instance> voter(int own = 2) {
  return std::make_unique<Instance>(plugin(), EnvironmentBuilder{}.own(own), Values(plugin()).set("vote_age", 10.0));
}

// What a robot that sees this would send: the real bytes of another instance.
std::vector<std::uint8_t> vote_cast(int own, const SceneData& data, const Rows& expected) {
  SceneData other = data;
  other.own_number = own;
  const auto instance = voter(own);
  const auto rows = static_cast<unsigned>(expected.size());
  EXPECT_EQ(instance->assign(Scene(other), Matrix(rows, static_cast<unsigned>(data.tasks.size()))), expected);
  EXPECT_EQ(instance->host().offers.size(), 1u);
  return instance->host().offers.front().bytes;
}

// That of a robot which sees the line the other way round.
std::vector<std::uint8_t> mirrored_vote(int own) {
  SceneData data = line().build().data();
  std::swap(data.mine.robots[0].pose[0], data.mine.robots[2].pose[0]);
  return vote_cast(own, data, {2, 1, 0});
}

TEST(ScramVotePlugin, TheRecentMajorityIsPlayed) {
  const auto assigner = voter();
  const auto at = [](double time) { return line().time(time).build(); };
  EXPECT_EQ(assigner->assign(at(100.0), Matrix(3, 3)), (Rows{0, 1, 2}));
  for (const int sender : {1, 3}) assigner->receive(sender, mirrored_vote(sender), 100.0, 100.1);
  EXPECT_EQ(assigner->assign(at(101.0), Matrix(3, 3)), (Rows{2, 1, 0}));
  EXPECT_EQ(assigner->assign(at(111.0), Matrix(3, 3)), (Rows{0, 1, 2}));  // the votes are too old
  EXPECT_EQ(assigner->assign(at(110.0), Matrix(3, 3)), (Rows{2, 1, 0}));
  assigner->reset(1);
  EXPECT_EQ(assigner->assign(at(101.0), Matrix(3, 3)), (Rows{0, 1, 2}));
}

TEST(ScramVotePlugin, OfTwoMapsThatOfTheLowerNumberIsPlayed) {
  for (const auto& [own, other, played] :
       {std::tuple{2, 1, Rows{2, 1, 0}}, {2, 3, Rows{0, 1, 2}}, {1, 3, Rows{0, 1, 2}}, {3, 1, Rows{2, 1, 0}}}) {
    const auto assigner = voter(own);
    assigner->receive(other, mirrored_vote(other), 100.0, 100.1);
    EXPECT_EQ(assigner->assign(line().own(own).build(), Matrix(3, 3)), played) << own << ' ' << other;
  }
}

TEST(ScramVotePlugin, VotesOfOtherMembersAreVoid) {
  const auto assigner = voter();
  for (const int sender : {1, 3}) assigner->receive(sender, mirrored_vote(sender), 100.0, 100.1);
  EXPECT_EQ(assigner->assign(line().build(), Matrix(3, 3)), (Rows{2, 1, 0}));
  SceneData without = line().build().data();  // robot 1, which the votes name, is out
  without.mine.robots[0].flags &= ~std::uint32_t{REGISTA_ROBOT_ACTIVE};
  EXPECT_EQ(assigner->assign(Scene(without), Matrix(2, 3)), (Rows{0, 1}));
  // Two that believe so are heard by one that does not.
  const auto vote = vote_cast(3, without, {0, 1});
  for (const int sender : {1, 3}) assigner->receive(sender, vote, 101.0, 101.1);
  EXPECT_EQ(assigner->assign(line().build(), Matrix(3, 3)), (Rows{0, 1, 2}));
}

TEST(ScramVotePlugin, VotesOfRobotsThatDoNotPlayAreVoid) {
  const auto assigner = voter();
  for (const int sender : {4, 5}) assigner->receive(sender, mirrored_vote(1), 100.0, 100.1);
  EXPECT_EQ(assigner->assign(line().build(), Matrix(3, 3)), (Rows{0, 1, 2}));
}

TEST(ScramVotePlugin, VotesAboutOtherTasksAreVoid) {
  const auto assigner = voter();
  for (const int sender : {1, 3}) assigner->receive(sender, mirrored_vote(sender), 100.0, 100.1);
  SceneData one = line().build().data();
  one.tasks[2].id = 11;
  // Robot 1 is to do the task that is not known here, robot 2 its own, robot 3 the first: 1 takes what is open.
  EXPECT_EQ(assigner->assign(Scene(one), Matrix(3, 3)), (Rows{2, 1, 0}));
  SceneData two = one;
  two.tasks[1].id = 12;
  EXPECT_EQ(assigner->assign(Scene(two), Matrix(3, 3)), (Rows{0, 1, 2}));  // another list
}

TEST(ScramVotePlugin, AForbiddenPairIsNotPlayed) {
  const auto assigner = voter();
  for (const int sender : {1, 3}) assigner->receive(sender, mirrored_vote(sender), 100.0, 100.1);
  Matrix utilities(3, 3);
  utilities(0, 2) = forbidden;
  EXPECT_EQ(assigner->assign(line().build(), utilities), (Rows{-1, 1, 0}));
}

TEST(ScramVotePlugin, AtTheReserveRolesGoByRank) {
  const auto assigner = voter();
  for (const int sender : {1, 3}) assigner->receive(sender, mirrored_vote(sender), 100.0, 100.1);
  EXPECT_EQ(assigner->assign(line().build(), Matrix(3, 3)), (Rows{2, 1, 0}));
  assigner->host().budget.packets_left = 30;
  EXPECT_EQ(assigner->assign(line().build(), Matrix(3, 3)), (Rows{0, 1, 2}));
  EXPECT_FALSE(assigner->host().offers.back().waits());
  assigner->host().budget.packets_left = 31;
  EXPECT_EQ(assigner->assign(line().build(), Matrix(3, 3)), (Rows{2, 1, 0}));
}

TEST(ScramVotePlugin, SaysWhatAVoteIsFor) {
  const auto assigner = voter();
  EXPECT_EQ(assigner->describe(mirrored_vote(1)), "vote: 1 jolly, 2 supporter, 3 striker");
  EXPECT_EQ(assigner->describe(std::vector<std::uint8_t>(40)), "no vote of this team");
  EXPECT_EQ(assigner->describe({}), "no vote of this team");
}

TEST(ScramVotePlugin, OneVoteIsPendingAlways) {
  const auto assigner = voter();
  auto& offers = assigner->host().offers;
  assigner->assign(line().build(), Matrix(3, 3));
  assigner->assign(line().build(), Matrix(3, 3));
  ASSERT_EQ(offers.size(), 1u);
  EXPECT_EQ(offers[0].bytes.size(), scram::MapCode(7, usual_roles().size()).bytes());
  assigner->transmitted(offers[0].handle);
  assigner->assign(line().build(), Matrix(3, 3));
  ASSERT_EQ(offers.size(), 2u);
  EXPECT_EQ(offers[1].replaces, 0u);
  SceneData mirrored = line().build().data();
  std::swap(mirrored.mine.robots[0].pose[0], mirrored.mine.robots[2].pose[0]);
  assigner->assign(Scene(mirrored), Matrix(3, 3));
  ASSERT_EQ(offers.size(), 3u);
  EXPECT_EQ(offers[2].replaces, offers[1].handle);
  assigner->dropped(offers[1].handle);
  assigner->dropped(offers[2].handle);
  assigner->assign(Scene(mirrored), Matrix(3, 3));
  ASSERT_EQ(offers.size(), 4u);
  EXPECT_EQ(offers[3].replaces, 0u);
  assigner->assign(FrameBuilder{}.own(2).time(100.0).robot(2).build(), Matrix(1, 0));
  EXPECT_TRUE(offers[3].withdrawn);  // there is nothing to vote on
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "scram_vote");

}  // namespace
