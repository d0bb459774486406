// SPDX-License-Identifier: MIT
// The plugin in scenes: what is offered and when a packet is worth it, what is shown of teammates, set tasks, contexts.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>
#include <regista/testkit/rehearsal.hpp>

#include "message.hpp"

namespace {

using namespace regista::testkit;
using Rows = std::vector<std::int32_t>;
using Bytes = std::vector<std::uint8_t>;
constexpr double forbidden = -std::numeric_limits<double>::infinity();
constexpr std::int32_t striker = 1, supporter = 2, jolly = 5;  // rows of usual_roles()

const Loaded& role_exchange_plugin() {
  static const Loaded plugin(REGISTA_PLUGIN_FILE, "role_exchange");
  return plugin;
}

// Robots 2 and 3, with the tasks striker and supporter.
FrameBuilder pair(double time) {
  return FrameBuilder{}
      .own(2)
      .time(time)
      .tick(static_cast<std::uint64_t>(10.0 * time))
      .robot(2)
      .robot(3)
      .task("striker")
      .task("supporter");
}

Matrix utilities(std::vector<double> values, std::uint32_t columns = 2) {
  Matrix out(static_cast<std::uint32_t>(values.size()) / columns, columns);
  for (std::size_t k = 0; k < values.size(); ++k) out(k / columns, k % columns) = values[k];
  return out;
}

Bytes statement(std::int32_t role, std::int32_t wish, std::int16_t as_striker, std::int16_t as_supporter) {
  role_exchange::Statement said;
  said.forget(usual_roles().size());
  said.role = role;
  said.wish = wish;
  said.utilities[striker] = as_striker;
  said.utilities[supporter] = as_supporter;
  Bytes bytes;
  role_exchange::write_statement(said, bytes);
  return bytes;
}

TEST(RoleExchangePlugin, StrangersAreGuessed) {
  Instance robot(role_exchange_plugin(), EnvironmentBuilder{}.own(2));
  EXPECT_EQ(robot.assign(pair(1.0).build(), utilities({0.5, 0.1, 0.9, 0.2})), (Rows{1, 0}));
}

TEST(RoleExchangePlugin, AnExchangeByPackets) {
  Instance robot(role_exchange_plugin(), EnvironmentBuilder{}.own(2));
  const Matrix at_first = utilities({0.9, 0.1, 0.1, 0.9}), later = utilities({0.1, 0.9, 0.1, 0.9});
  EXPECT_EQ(robot.assign(pair(1.0).build(), at_first), (Rows{0, 1}));
  robot.receive(3, statement(supporter, supporter, 25, 230), 1.0, 1.05);
  robot.transmitted(robot.host().offers.back().handle);
  // The own utilities change; the other one's packet said that it would do worse.
  EXPECT_EQ(robot.assign(pair(1.1).build(), later), (Rows{0, 1}));
  EXPECT_EQ(robot.host().offers.back().urgency, 0.0);
  robot.receive(3, statement(supporter, striker, 230, 25), 1.1, 1.15);
  EXPECT_EQ(robot.assign(pair(1.2).build(), later), (Rows{0, 1}));  // the other wishes; the own wish was not said
  ASSERT_EQ(robot.host().offers.back().urgency, 1.0);               // it completes the exchange
  EXPECT_EQ(robot.describe(robot.host().offers.back().bytes),
            "plays striker, wishes supporter; striker 0.15, supporter 0.90");
  robot.transmitted(robot.host().offers.back().handle);
  EXPECT_EQ(robot.assign(pair(1.3).build(), later), (Rows{1, 0}));
  EXPECT_EQ(robot.host().offers.back().urgency, 0.0);
  EXPECT_EQ(robot.describe(robot.host().offers.back().bytes),
            "plays supporter and stays; striker 0.10, supporter 0.95");
}

TEST(RoleExchangePlugin, WhatIsWorthAPacketIsAParameter) {
  for (const double urgent : {0.0, 1.0, 2.0}) {  // never, answers, wishes
    Instance robot(role_exchange_plugin(), EnvironmentBuilder{}.own(2),
                   Values(role_exchange_plugin()).set("urgent", urgent));
    robot.assign(pair(1.0).build(), utilities({0.9, 0.1, 0.1, 0.9}));
    robot.transmitted(robot.host().offers.back().handle);
    robot.receive(3, statement(supporter, supporter, 230, 25), 1.0, 1.05);
    robot.assign(pair(1.1).build(), utilities({0.1, 0.9, 0.1, 0.9}));
    EXPECT_EQ(robot.host().offers.back().urgency, urgent == 2.0 ? 1.0 : 0.0) << urgent;  // a wish, and no answer
  }
}

TEST(RoleExchangePlugin, TheOfferIsReplacedAndOfferedAgain) {
  Instance robot(role_exchange_plugin(), EnvironmentBuilder{}.own(2));
  robot.assign(pair(1.0).build(), utilities({0.9, 0.1, 0.1, 0.9}));
  robot.assign(pair(1.1).build(), utilities({0.9, 0.1, 0.1, 0.9}));
  ASSERT_EQ(robot.host().offers.size(), 1u);
  EXPECT_EQ(robot.host().offers[0].bytes.size(), role_exchange::message_bytes(usual_roles().size(), 2));
  robot.transmitted(robot.host().offers[0].handle);
  robot.assign(pair(1.2).build(), utilities({0.9, 0.1, 0.1, 0.9}));
  ASSERT_EQ(robot.host().offers.size(), 2u);
  robot.assign(pair(1.3).build(), utilities({0.7, 0.1, 0.1, 0.9}));
  ASSERT_EQ(robot.host().offers.size(), 3u);
  EXPECT_EQ(robot.host().offers[2].replaces, robot.host().offers[1].handle);
  EXPECT_EQ(robot.assign(pair(1.4).robot(2).penalised().build(), utilities({0.1, 0.9})), (Rows{0}));
  EXPECT_TRUE(robot.host().offers[2].withdrawn);
}

TEST(RoleExchangePlugin, APenalisedHolderIsReplacedAndItsReturnIsNoClaim) {
  Instance robot(role_exchange_plugin(), EnvironmentBuilder{}.own(2));
  const Matrix both = utilities({0.6, 0.5, 0.9, 0.1});
  robot.receive(3, statement(striker, striker, 230, 25), 0.9, 0.95);
  EXPECT_EQ(robot.assign(pair(1.0).build(), both), (Rows{1, 0}));
  EXPECT_EQ(robot.assign(pair(1.1).robot(3).penalised().build(), utilities({0.6, 0.5})), (Rows{0}));
  // With 230 steps for the striker it would keep that role, if what it said then still counted, in whatever way.
  EXPECT_EQ(robot.assign(pair(16.1).robot(3).penalised().build(), utilities({0.6, 0.5})), (Rows{0}));
  const auto back = pair(16.2).robot(3).role("striker").age(15.3).build();
  EXPECT_EQ(robot.assign(back, utilities({0.8, 0.1, 0.1, 0.9})), (Rows{0, 1}));
}

// Who does not play itself sees others come and go: what it takes them to do is of those that play now.
TEST(RoleExchangePlugin, ItsGuessesAreOfThoseThatPlayWhileItDoesNot) {
  Instance robot(role_exchange_plugin(), EnvironmentBuilder{}.own(2));
  EXPECT_EQ(robot.assign(pair(1.0).robot(3).penalised().build(), utilities({0.9, 0.1})), (Rows{0}));
  FrameBuilder many = pair(1.1).robot(2).penalised();
  for (int number = 4; number <= 7; ++number) many.robot(number);
  many.task("jolly").task("libero").task("goalkeeper");
  std::vector<double> all;
  for (std::size_t row = 0; row < 5; ++row) {
    for (std::size_t column = 0; column < 5; ++column) all.push_back((row + column) % 5 == 1 ? 0.9 : 0.1);
  }
  EXPECT_EQ(robot.assign(many.build(), utilities(all, 5)), (Rows{1, 0, 4, 3, 2}));
}

TEST(RoleExchangePlugin, ForbiddenPairsAndRequiredTasks) {
  Instance robot(role_exchange_plugin(), EnvironmentBuilder{}.own(2));
  EXPECT_EQ(robot.assign(pair(1.0).build(), utilities({forbidden, 0.1, 0.9, 0.9})), (Rows{1, 0}));
  Instance other(role_exchange_plugin(), EnvironmentBuilder{}.own(2));
  // Three tasks for two robots: the last is required, so the second stays open.
  EXPECT_EQ(other.assign(pair(1.0).task("jolly").required().build(), utilities({0.9, 0.9, 0.1, 0.1, 0.9, 0.2}, 3)),
            (Rows{0, 2}));
}

// Another context had the team in the meantime.
TEST(RoleExchangePlugin, RolesAreTakenOnFromAnotherContext) {
  Instance robot(role_exchange_plugin(), EnvironmentBuilder{}.own(2));
  const Matrix level = utilities({0.5, 0.5, 0.5, 0.5});
  EXPECT_EQ(robot.assign(pair(1.0).build(), level), (Rows{0, 1}));
  const auto after = [](double time) {
    return pair(time).previous(2, "supporter").robot(3).role("striker").age(0.3).build();
  };
  EXPECT_EQ(robot.assign(after(3.0), level), (Rows{1, 0}));
  // From a list of other tasks it comes back to what it did here, if that is not too long ago.
  const auto from_search = [](double time) { return pair(time).previous(2, "search_1").build(); };
  EXPECT_EQ(robot.assign(from_search(5.0), utilities({0.5, 0.4, 0.5, 0.4})), (Rows{1, 0}));
  EXPECT_EQ(robot.assign(from_search(60.0), utilities({0.9, 0.1, 0.1, 0.9})), (Rows{0, 1}));
}

TEST(RoleExchangePlugin, AtTheReserveRolesGoByRank) {
  Instance robot(role_exchange_plugin(), EnvironmentBuilder{}.own(2));
  const Matrix values = utilities({0.1, 0.9, 0.9, 0.1});
  const auto at = [](double time) { return pair(time).robot(1).penalised(); };
  EXPECT_EQ(robot.assign(at(1.0).build(), values), (Rows{1, 0}));
  robot.host().budget.packets_left = 30;
  EXPECT_EQ(robot.assign(at(1.1).build(), values), (Rows{0, 1}));
  EXPECT_TRUE(robot.host().offers.back().withdrawn);
  robot.host().budget.packets_left = 31;  // it goes on with what it plays
  const Matrix level = utilities({0.5, 0.5, 0.5, 0.5});
  EXPECT_EQ(robot.assign(at(1.2).previous(2, "striker").build(), level), (Rows{0, 1}));
  EXPECT_TRUE(robot.host().offers.back().waits());
}

TEST(RoleExchangePlugin, RobotsOutOfTheTableAndOtherTeamsAreIgnored) {
  Instance robot(role_exchange_plugin(), EnvironmentBuilder{}.own(2));
  const Matrix level = utilities({0.6, 0.5, 0.5, 0.6});
  robot.receive(99, statement(striker, striker, 255, 0), 0.9, 0.9);
  robot.receive(-4, statement(striker, striker, 255, 0), 0.9, 0.9);
  robot.receive(3, Bytes(7, 0xff), 0.9, 0.9);
  robot.receive(3, {}, 0.9, 0.9);
  EXPECT_EQ(robot.assign(pair(1.0).build(), level), (Rows{0, 1}));
  EXPECT_EQ(robot.describe(Bytes(7, 0xff)), "no statement about these roles");
}

TEST(RoleExchangePlugin, ASearcherIsNoHolderOfATask) {
  Instance robot(role_exchange_plugin(), EnvironmentBuilder{}.own(2));
  role_exchange::Statement said;
  said.forget(usual_roles().size());
  said.role = said.wish = jolly;  // of another list, as far as this robot is concerned
  said.utilities[jolly] = 200;
  Bytes bytes;
  role_exchange::write_statement(said, bytes);
  robot.receive(3, bytes, 0.9, 0.95);
  EXPECT_EQ(robot.assign(pair(1.0).build(), utilities({0.9, 0.1, 0.1, 0.9})), (Rows{0, 1}));  // guessed as a stranger
}

// The contract rehearses three and seven robots.
TEST(RoleExchangePlugin, ElevenRobotsAgreeToo) {
  RehearsalConditions conditions;
  conditions.robots = 11;
  conditions.radio.loss = 0.3;
  const Rehearsal rehearsal = rehearse(role_exchange_plugin(), Values(role_exchange_plugin()), conditions);
  EXPECT_TRUE(rehearsal.broken.empty());
  for (const Act& act : rehearsal.acts)
    EXPECT_TRUE(act.settled_after.has_value()) << act.name << ": " << act.disagreement;
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "role_exchange");

}  // namespace
