// SPDX-License-Identifier: MIT
// The plugin in scenes: groups come from the roles, and which of the held tasks is played.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

namespace {

using namespace regista::testkit;
using Rows = std::vector<std::int32_t>;
constexpr std::int32_t unknown = REGISTA_UNKNOWN_TASK;

const Loaded& plugin() {
  static const Loaded loaded(REGISTA_PLUGIN_FILE, "precedence_auction");
  return loaded;
}
Values settings(double tasks_per_robot, double order) {
  Values values(plugin());
  values.set("step", 0.01).set("epsilon", 0.05).set("tasks_per_robot", tasks_per_robot).set("order", order);
  return values;
}

// Robots 1 and 2; jolly has no group.
FrameBuilder frame(int own, double time, double x = 0.0) {
  FrameBuilder out;
  out.own(own).time(time).robot(1).at(x, 0).robot(2).at(1, 0);
  out.task("jolly").at(3, 0).task("supporter").at(1, 0).group(2).task("striker").at(2, 0).group(1);
  return out;
}
Matrix utilities(double jolly, double supporter, double striker, std::size_t row = 0) {
  Matrix out(2, 3);
  out(row, 0) = jolly;
  out(row, 1) = supporter;
  out(row, 2) = striker;
  return out;
}
std::string said(Instance& instance) { return instance.describe(instance.host().offers.back().bytes); }

TEST(PrecedenceAuctionPlugin, TheBestGroupOrTheFirst) {
  Instance sum(plugin(), EnvironmentBuilder{}.own(1), settings(1, 0)),
      first(plugin(), EnvironmentBuilder{}.own(1), settings(1, 1));
  EXPECT_EQ(sum.assign(frame(1, 1.0).build(), utilities(0.9, 0.5, 0.2)), (Rows{0, unknown}));
  EXPECT_EQ(said(sum), "epoch 0: jolly 1 for 0.450");
  EXPECT_EQ(first.assign(frame(1, 1.0).build(), utilities(0.9, 0.5, 0.2)), (Rows{2, unknown}));
  EXPECT_EQ(said(first), "epoch 0: striker 1 for 0.260");
}

TEST(PrecedenceAuctionPlugin, OfTheTasksThatItHoldsTheFirstIsPlayed) {
  Instance one(plugin(), EnvironmentBuilder{}.own(1), settings(2, 0));
  EXPECT_EQ(one.assign(frame(1, 1.0).build(), utilities(0.9, 0.5, 0.2)), (Rows{1, unknown}));
  EXPECT_EQ(said(one), "epoch 0: supporter 1 for 0.350, jolly 1 for 0.750");
}

TEST(PrecedenceAuctionPlugin, ALaterGroupBeginsWhenTheEarlierOnesAreDone) {
  const Values values = settings(2, 1).set("done_within", 0.5);
  Instance one(plugin(), EnvironmentBuilder{}.own(1), values), two(plugin(), EnvironmentBuilder{}.own(2), values);
  const Matrix own = utilities(0.1, 0.5, 0.5);
  EXPECT_EQ(one.assign(frame(1, 1.0).build(), own), (Rows{2, unknown}));  // striker first, supporter then
  one.transmitted(one.host().offers.back().handle);
  EXPECT_EQ(one.assign(frame(1, 2.0, 1.7).build(), own)[0], unknown);  // it is there, and soon goes on
  EXPECT_EQ(said(one), "epoch 0: striker 1 for 0.560 (done), supporter 1 for 0.560");
  one.transmitted(one.host().offers.back().handle);
  one.assign(frame(1, 2.1, 1.7).build(), own);
  EXPECT_EQ(one.assign(frame(1, 5.0, 1.7).build(), own)[0], 1);
  two.receive(1, one.host().offers.back().bytes, 5.0, 5.0);
  EXPECT_EQ(two.assign(frame(2, 5.0).build(), utilities(0.5, 0.1, 0.1, 1)), (Rows{1, 0}));
}

TEST(PrecedenceAuctionPlugin, RolesOfSoccerAreNeverDone) {
  Instance one(plugin(), EnvironmentBuilder{}.own(1), settings(2, 1));
  for (double time = 1.0; time < 20.0; time += 1.0) {
    EXPECT_EQ(one.assign(frame(1, time, 2.0).build(), utilities(0.1, 0.5, 0.5))[0], 2);
    one.transmitted(one.host().offers.back().handle);
  }
}

TEST(PrecedenceAuctionPlugin, WarnsOnceOfGroupsThatNoRobotCanTake) {
  EnvironmentBuilder environment;
  environment.own(1).team_size(2);
  Instance one(plugin(), environment, settings(1, 0)), two(plugin(), environment, settings(2, 0));
  for (Instance* each : {&one, &two}) {
    each->assign(frame(1, 1.0).team_size(2).build(), utilities(0.9, 0.5, 0.2));
    each->assign(frame(1, 1.1).team_size(2).build(), utilities(0.9, 0.5, 0.2));
  }
  ASSERT_EQ(one.host().log.size(), 1u);
  EXPECT_NE(one.host().log[0].text.find("more groups"), std::string::npos);
  EXPECT_TRUE(two.host().log.empty());
}

TEST(PrecedenceAuctionPlugin, AtTheReserveRolesGoByRank) {
  Instance one(plugin(), EnvironmentBuilder{}.own(1), settings(1, 0));
  one.host().budget.packets_left = 30;
  EXPECT_EQ(one.assign(frame(1, 1.0).build(), utilities(0.1, 0.5, 0.9)), (Rows{0, 1}));
  EXPECT_TRUE(one.host().offers.empty());
}

// What robot `own` says when it is set up, in a team of two whose page has roles in these groups.
std::vector<RecordingHost::Line> says_of_groups(const std::vector<std::int32_t>& groups, int own, double each_takes) {
  RecordingHost host;
  for (const std::int32_t group : groups) {
    host.roles.emplace_back().size = sizeof(regista_role_facts);
    host.roles.back().group = group;
  }
  EnvironmentBuilder environment;
  environment.team_size(2).own(own).roles({"striker", "supporter", "jolly"}).role("searcher", 0, "searching");
  const Setting setting = environment.build();
  const std::vector<regista_value> values = settings(each_takes, 0).raw();
  regista_error error{};
  void* const instance = plugin().descriptor().create(
      &setting.raw(), host.raw(),
      {values.data(), static_cast<std::uint32_t>(values.size()), static_cast<std::uint32_t>(sizeof(regista_value))},
      &error);
  EXPECT_NE(instance, nullptr) << error.text;
  plugin().descriptor().destroy(instance);
  return host.log;
}

TEST(PrecedenceAuctionPlugin, SaysAtSetupWhatIsOddAboutGroups) {
  EXPECT_TRUE(says_of_groups({1, 2, 1, -1}, 1, 1).empty());
  EXPECT_TRUE(says_of_groups({-1, -1, -1, -1}, 1, 1).empty());  // the plain auction
  const auto many = says_of_groups({1, 2, 3, -1}, 1, 1);
  ASSERT_EQ(many.size(), 1u);
  EXPECT_EQ(many[0].level, REGISTA_LOG_WARNING);
  EXPECT_EQ(many[0].text, "roles playing: 3 groups, and the team can do tasks of 2: some stay without a robot");
  EXPECT_TRUE(says_of_groups({1, 2, 3, -1}, 1, 2).empty());
  EXPECT_TRUE(says_of_groups({1, 2, 3, -1}, 2, 1).empty());  // robot 1 has said it
  const auto without = says_of_groups({-1, 1, -1, -1}, 1, 1);
  ASSERT_EQ(without.size(), 1u);
  EXPECT_EQ(without[0].level, REGISTA_LOG_DEBUG);
  EXPECT_EQ(without[0].text, "roles playing: without a group, and so in the last one: striker, jolly");
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "precedence_auction");

}  // namespace
