// SPDX-License-Identifier: MIT
// The plugin in scenes: what it says, shows and plays, and what it makes of what it hears.
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "price_table.hpp"

namespace {

using namespace regista::testkit;
using Rows = std::vector<std::int32_t>;
constexpr double forbidden = -std::numeric_limits<double>::infinity();
constexpr std::int32_t unknown = REGISTA_UNKNOWN_TASK;

const Loaded& plugin() {
  static const Loaded loaded(REGISTA_PLUGIN_FILE, "distributed_auction");
  return loaded;
}
Values settings() {
  Values values(plugin());
  values.set("step", 0.01).set("epsilon", 0.05).set("threshold", 0.05).set("largest", 2.0);
  return values;
}

// Robots 1 and 2; the column of a task is not its id.
Scene scene(int own, double time, std::vector<std::string> tasks = {"supporter", "striker"}) {
  FrameBuilder frame;
  frame.own(own).time(time).robot(1).at(0, 0).robot(2).at(1, 0);
  for (const std::string& each : tasks) frame.task(each);
  return frame.build();
}
Matrix utilities(double supporter_1, double striker_1, double supporter_2, double striker_2) {
  Matrix out(2, 2);
  out(0, 0) = supporter_1;
  out(0, 1) = striker_1;
  out(1, 0) = supporter_2;
  out(1, 1) = striker_2;
  return out;
}
std::vector<std::uint8_t> last_said(Instance& instance) { return instance.host().offers.back().bytes; }

TEST(DistributedAuctionPlugin, TwoRobotsAgreeByWhatTheySay) {
  Instance one(plugin(), EnvironmentBuilder{}.own(1), settings()),
      two(plugin(), EnvironmentBuilder{}.own(2), settings());
  // Each knows its own row alone; the other is far better off in what they believe of it.
  const Matrix of_one = utilities(0.5, 0.9, 0.0, 0.0), of_two = utilities(0.0, 0.0, 0.2, 0.8);
  EXPECT_EQ(one.assign(scene(1, 1.0), of_one), (Rows{1, unknown}));
  EXPECT_EQ(one.describe(last_said(one)), "epoch 0: striker 1 for 0.450");
  two.receive(1, last_said(one), 1.0, 1.1);
  EXPECT_EQ(two.assign(scene(2, 1.1), of_two), (Rows{unknown, 1}));
  EXPECT_EQ(two.describe(last_said(two)), "epoch 0: striker 2 for 0.650");
  one.transmitted(one.host().offers.back().handle);
  one.receive(2, last_said(two), 1.1, 1.2);
  EXPECT_EQ(one.assign(scene(1, 1.2), of_one), (Rows{0, 1}));
  EXPECT_EQ(one.describe(last_said(one)), "epoch 0: striker 2 for 0.650, supporter 1 for 0.300");
  two.receive(1, last_said(one), 1.2, 1.3);
  EXPECT_EQ(two.assign(scene(2, 1.3), of_two), (Rows{0, 1}));
  two.reset(1);
  EXPECT_EQ(two.assign(scene(2, 1.3), of_two), (Rows{unknown, 1}));
}

TEST(DistributedAuctionPlugin, GoesOnWithWhatItGaveUpUntilTheNewBidIsOnTheAir) {
  Instance one(plugin(), EnvironmentBuilder{}.own(1), settings());
  EXPECT_EQ(one.assign(scene(1, 1.0), utilities(0.5, 0.6, 0, 0)), (Rows{1, unknown}));
  one.transmitted(one.host().offers.back().handle);
  const Matrix other = utilities(0.9, 0.5, 0, 0);
  EXPECT_EQ(one.assign(scene(1, 1.1), other), (Rows{unknown, unknown}));
  EXPECT_EQ(one.describe(last_said(one)), "epoch 0: striker given up at 0.150, supporter 1 for 0.600");
  EXPECT_EQ(one.assign(scene(1, 9.0), other), (Rows{unknown, unknown}));  // nobody has heard of it yet
  one.transmitted(one.host().offers.back().handle);
  EXPECT_EQ(one.assign(scene(1, 9.1), other), (Rows{unknown, unknown}));
  EXPECT_EQ(one.assign(scene(1, 11.2), other), (Rows{0, unknown}));
}

TEST(DistributedAuctionPlugin, LeavesATaskAtOnceThatAnotherHolds) {
  Instance one(plugin(), EnvironmentBuilder{}.own(1), settings()),
      two(plugin(), EnvironmentBuilder{}.own(2), settings());
  EXPECT_EQ(one.assign(scene(1, 1.0), utilities(0.5, 0.6, 0, 0)), (Rows{1, unknown}));
  one.transmitted(one.host().offers.back().handle);
  two.receive(1, last_said(one), 1.0, 1.0);
  two.assign(scene(2, 1.0), utilities(0, 0, 0.1, 0.9));
  one.receive(2, last_said(two), 1.0, 1.1);
  EXPECT_EQ(one.assign(scene(1, 1.1), utilities(0.5, 0.6, 0, 0)), (Rows{0, 1}));
}

TEST(DistributedAuctionPlugin, AHigherBidThatIsHeardBeforeTheOwnLeavesIsNotForgotten) {
  Instance one(plugin(), EnvironmentBuilder{}.own(1), settings()),
      two(plugin(), EnvironmentBuilder{}.own(2), settings());
  EXPECT_EQ(one.assign(scene(1, 1.0), utilities(0.5, 0.6, 0, 0)), (Rows{1, unknown}));
  two.assign(scene(2, 1.0), utilities(0, 0, 0.1, 0.9));
  EXPECT_EQ(two.describe(last_said(two)), "epoch 0: striker 2 for 0.850");
  one.receive(2, last_said(two), 1.0, 1.05);
  one.transmitted(one.host().offers.back().handle);  // it says: striker 1 for 0.150
  EXPECT_EQ(one.assign(scene(1, 1.1), utilities(0.5, 0.6, 0, 0)), (Rows{0, 1}));
}

TEST(DistributedAuctionPlugin, WithoutTasksItIsSilent) {
  Instance one(plugin(), EnvironmentBuilder{}.own(1), settings());
  one.assign(scene(1, 1.0), utilities(0.5, 0.6, 0, 0));
  EXPECT_EQ(one.assign(scene(1, 1.1, {}), Matrix(2, 0)).size(), 2u);
  EXPECT_FALSE(one.host().offers.back().waits());
  EXPECT_EQ(one.assign(scene(1, 1.2), utilities(0.5, 0.6, 0, 0)), (Rows{1, unknown}));
  EXPECT_TRUE(one.host().offers.back().waits());
}

TEST(DistributedAuctionPlugin, ANewBidIsUrgentNowAndThen) {
  Instance one(plugin(), EnvironmentBuilder{}.own(1), settings().set("urgent_every", 6.0));
  const auto urgency = [&](double time, double striker) {
    one.assign(scene(1, time), utilities(0.5, striker, 0, 0));
    return one.host().offers.back().urgency;
  };
  EXPECT_EQ(urgency(1.0, 0.6), 1.0);
  one.transmitted(one.host().offers.back().handle);
  EXPECT_EQ(urgency(1.1, 0.6), 0.0);  // nothing new
  EXPECT_EQ(urgency(1.2, 0.1), 0.0);  // new, but it has just spoken
  EXPECT_EQ(urgency(7.2, 0.1), 1.0);
}

TEST(DistributedAuctionPlugin, AtTheReserveRolesGoByRank) {
  Instance one(plugin(), EnvironmentBuilder{}.own(1), settings());
  const Matrix values = utilities(0.5, 0.9, 0.0, 0.0);
  EXPECT_EQ(one.assign(scene(1, 1.0), values), (Rows{1, unknown}));
  one.host().budget.packets_left = 30;
  EXPECT_EQ(one.assign(scene(1, 1.1), values), (Rows{0, 1}));
  EXPECT_FALSE(one.host().offers.back().waits());
  one.host().budget.packets_left = 31;
  EXPECT_EQ(one.assign(scene(1, 1.2), values), (Rows{1, unknown}));
  EXPECT_TRUE(one.host().offers.back().waits());
  Instance never(plugin(), EnvironmentBuilder{}.own(1), settings().set("stop_negotiating_at", -1.0));
  never.host().budget.packets_left = 0;
  EXPECT_EQ(never.assign(scene(1, 1.0), values), (Rows{1, unknown}));
}

TEST(DistributedAuctionPlugin, WhatItMustNotTakeItDoesNotBidFor) {
  Instance one(plugin(), EnvironmentBuilder{}.own(1), settings());
  EXPECT_EQ(one.assign(scene(1, 1.0), utilities(forbidden, forbidden, 0.5, 0.5)), (Rows{REGISTA_NO_TASK, unknown}));
  EXPECT_EQ(one.describe(last_said(one)), "epoch 0: no bids");
  EXPECT_EQ(one.assign(scene(1, 1.1), utilities(0.0, forbidden, 0.5, 0.5)), (Rows{0, unknown}));  // 0 is enough
}

TEST(DistributedAuctionPlugin, BearsWhateverItHears) {
  Instance one(plugin(), EnvironmentBuilder{}.own(1), settings());
  const Rows before = one.assign(scene(1, 1.0), utilities(0.5, 0.6, 0, 0));
  one.transmitted(one.host().offers.back().handle);
  std::vector<std::uint8_t> good = last_said(one);
  for (const int sender : {-3, 0, 1, 8, 99}) one.receive(sender, good, 1.0, 1.1);
  good.push_back(0);
  one.receive(2, good, 1.0, 1.1);
  one.receive(2, {}, 1.0, 1.1);
  one.receive(2, std::vector<std::uint8_t>(60, 0xff), 1.0, 1.1);
  EXPECT_EQ(one.assign(scene(1, 1.1), utilities(0.5, 0.6, 0, 0)), before);
  EXPECT_EQ(one.describe(std::vector<std::uint8_t>{1, 2, 3}), "no bids of this team");
}

// More roles than a message has room for: it is cut, and what it says changes from packet to packet.
TEST(DistributedAuctionPlugin, AMessageIsCutWhereItHasNoRoom) {
  std::vector<std::string> names;
  for (int k = 0; k < 64; ++k) names.push_back("role_" + std::to_string(k));
  EnvironmentBuilder environment;
  environment.team_size(22).own(1).roles(names);
  FrameBuilder frame;
  frame.team_size(22).own(1).roles(names).time(5.0);
  for (int number = 1; number <= 22; ++number) frame.robot(number).at(0, 0);
  for (const std::string& each : names) frame.task(each);
  Instance one(plugin(), environment);
  for (int number = 22; number >= 2; --number) {
    EnvironmentBuilder other = environment;
    Instance teammate(plugin(), other.own(number));
    FrameBuilder view = frame;
    Matrix utility(22, 64);
    for (std::size_t j = 0; j < 64; ++j)
      utility(static_cast<std::size_t>(number) - 1, j) = j == 2u * static_cast<unsigned>(number) ? 1.0 : 0.1;
    teammate.assign(view.own(number).build(), utility);
    one.receive(number, last_said(teammate), 5.0, 5.0);
  }
  Matrix utility(22, 64);
  utility(0, 63) = 1.0;
  const auction::Format format = auction::Format::fitting(22, 64, 2001 + 100, false, 60);
  ASSERT_LT(format.most_told, 22u);
  std::set<std::size_t> in_all;
  for (int packet = 0; packet < 64; ++packet) {
    EXPECT_EQ(one.assign(frame.build(), utility)[0], 63);
    std::uint8_t epoch = 0;
    std::vector<auction::Told> told;
    ASSERT_TRUE(read_message(format, last_said(one), epoch, told));
    EXPECT_EQ(told.size(), format.most_told);
    EXPECT_EQ(told.back().task, 63u);  // the own one
    for (const auction::Told& each : told) in_all.insert(each.task);
    one.transmitted(one.host().offers.back().handle);
  }
  EXPECT_EQ(in_all.size(), 22u);
  // What it gives up now goes before what others hold.
  utility(0, 62) = 2.0;
  utility(0, 63) = 0.0;  // or its price would be worth a new epoch
  one.assign(frame.build(), utility);
  std::uint8_t epoch = 0;
  std::vector<auction::Told> told;
  ASSERT_TRUE(read_message(format, last_said(one), epoch, told));
  ASSERT_EQ(told.size(), format.most_told);
  EXPECT_EQ(told.back().task, 63u);
  EXPECT_EQ(told.back().bid.bidder, auction::nobody);
  EXPECT_EQ(told[told.size() - 2].task, 62u);
  EXPECT_EQ(told[told.size() - 2].bid.bidder, 1);
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "distributed_auction");

}  // namespace
