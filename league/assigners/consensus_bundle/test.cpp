// SPDX-License-Identifier: MIT
// The plugin in scenes: whom it believes, what it plays until it could tell, and what becomes of the claims of those
// who leave, fall silent or are unheard.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "segment.hpp"

namespace {

using namespace regista::testkit;
using consensus_bundle::Claim;
using consensus_bundle::never;
using consensus_bundle::Segment;
using consensus_bundle::tick_of;
using Rows = std::vector<std::int32_t>;
constexpr std::int32_t nothing = REGISTA_NO_TASK, unknown = REGISTA_UNKNOWN_TASK;

const Loaded& plugin() {
  static const Loaded loaded(REGISTA_PLUGIN_FILE, "consensus_bundle");
  return loaded;
}

// Three robots, of which number 2 is the own one; tasks "goalkeeper", "striker", "supporter" with ids 0, 1, 2.
const std::vector<std::string> names{"goalkeeper", "striker", "supporter"};
EnvironmentBuilder three() { return EnvironmentBuilder{}.team_size(3).own(2).roles(names); }
FrameBuilder frame_at(double time) {
  FrameBuilder frame;
  frame.roles(names).team_size(3).own(2).time(time).robot(1).robot(2).robot(3);
  for (const std::string& each : names) frame.task(each);
  return frame;
}

// The own row; others are never looked at.
Matrix own_row(double goalkeeper, double striker, double supporter, std::uint32_t rows = 3, std::uint32_t row = 1) {
  Matrix out(rows, 3);
  out(row, 0) = goalkeeper;
  out(row, 1) = striker;
  out(row, 2) = supporter;
  return out;
}

struct Say {
  int sender = 3;
  double sent = 0.0;
  std::vector<Claim> claims = std::vector<Claim>(3);
  std::vector<std::int64_t> stamps{never, never, never};
  std::uint8_t epoch = 0;
};

void hear(Instance& assigner, const Say& say, double delay = 0.05) {
  Segment segment;
  segment.setup(3, 3);
  std::vector<std::uint8_t> bytes;
  segment.write(say.epoch, say.sender, tick_of(say.sent), say.claims, say.stamps, bytes);
  assigner.receive(say.sender, bytes, say.sent, say.sent + delay);
}

// What it offers now, as another robot reads it.
consensus_bundle::Told offered(Instance& assigner, double time, std::uint8_t* epoch = nullptr) {
  Segment segment;
  segment.setup(3, 3);
  consensus_bundle::Told told;
  std::uint8_t number = 0;
  EXPECT_TRUE(segment.read(assigner.host().offers.back().bytes, 2, tick_of(time), number, told));
  if (epoch != nullptr) *epoch = number;
  return told;
}

void tell(Instance& assigner) { assigner.transmitted(assigner.host().offers.back().handle); }

TEST(ConsensusBundlePlugin, TakesItsBestTaskAndBidsInSteps) {
  Instance assigner(plugin(), three());
  EXPECT_EQ(assigner.assign(frame_at(5.0).build(), own_row(0.1, 0.5, 0.4)), (Rows{unknown, 1, unknown}));
  const auto told = offered(assigner, 5.0);
  EXPECT_EQ(told.claims, (std::vector<Claim>{{}, {2, 1001}, {}}));  // 0.5 in steps of 0.0005, and one
  EXPECT_EQ(told.sent, 50);
}

TEST(ConsensusBundlePlugin, TheHigherBidWinsAndEqualOnesGoToTheLowerNumber) {
  Instance assigner(plugin(), three());
  assigner.assign(frame_at(5.0).build(), own_row(0.1, 0.5, 0.4));
  hear(assigner, {3, 5.1, {{}, {3, 1001}, {}}});
  EXPECT_EQ(assigner.assign(frame_at(5.2).build(), own_row(0.1, 0.5, 0.4)), (Rows{unknown, 1, nothing}));
  hear(assigner, {1, 5.3, {{}, {1, 1001}, {}}});
  EXPECT_EQ(assigner.assign(frame_at(5.4).build(), own_row(0.1, 0.5, 0.4)), (Rows{1, 2, nothing}));
}

TEST(ConsensusBundlePlugin, ATaskThatIsWorthNothingIsTakenWhenNoneIsLeft) {
  Instance assigner(plugin(), three());
  hear(assigner, {3, 4.0, {{1, 900}, {3, 900}, {}}, {40, never, 40}});
  EXPECT_EQ(assigner.assign(frame_at(4.1).build(), own_row(0.3, 0.3, 0.0)), (Rows{0, 2, 1}));
}

TEST(ConsensusBundlePlugin, ForbiddenAndUnknownTasksAreNotTaken) {
  Instance assigner(plugin(), three());
  const double forbidden = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(assigner.assign(frame_at(4.0).build(), own_row(forbidden, forbidden, 0.1))[1], 2);
  FrameBuilder frame;  // it does not know the goalkeeper's task; columns are others
  frame.roles(names).team_size(3).own(2).time(4.1).robot(1).robot(2).robot(3).task("supporter").task("striker");
  hear(assigner, {3, 4.0, {{3, 900}, {1, 700}, {}}, {39, never, 40}});
  Matrix utilities(3, 2);
  utilities(1, 0) = 0.2;
  utilities(1, 1) = 0.3;
  EXPECT_EQ(assigner.assign(frame.build(), utilities), (Rows{1, 0, unknown}));
  EXPECT_EQ(offered(assigner, 4.1).claims[0], (Claim{3, 900}));  // and tells of it all the same
}

TEST(ConsensusBundlePlugin, PlaysWhatItHasToldUntilItHasToldAnother) {
  Instance assigner(plugin(), three());
  EXPECT_EQ(assigner.assign(frame_at(5.0).build(), own_row(0.1, 0.5, 0.4))[1], 1);
  EXPECT_EQ(assigner.assign(frame_at(5.1).build(), own_row(0.1, 0.5, 0.7))[1], 2);  // nothing was told yet
  tell(assigner);
  EXPECT_EQ(assigner.assign(frame_at(5.2).build(), own_row(0.1, 0.9, 0.7))[1], 2);
  EXPECT_EQ(offered(assigner, 5.2).claims, (std::vector<Claim>{{}, {2, 1801}, {}}));
  tell(assigner);
  EXPECT_EQ(assigner.assign(frame_at(5.3).build(), own_row(0.1, 0.9, 0.7))[1], 1);
  hear(assigner, {3, 5.3, {{}, {3, 1900}, {}}});
  EXPECT_EQ(assigner.assign(frame_at(5.4).build(), own_row(0.1, 0.9, 0.7))[1], 2);  // at once
}

TEST(ConsensusBundlePlugin, SmallChangesDoNotMoveTheBid) {
  Instance assigner(plugin(), three());
  const auto bid_after = [&](double utility, double time) {
    assigner.assign(frame_at(time).build(), own_row(0.1, utility, 0.4));
    return offered(assigner, time).claims[1].bid;
  };
  EXPECT_EQ(bid_after(0.5, 5.0), 1001u);
  EXPECT_EQ(bid_after(0.515, 5.1), 1001u);
  EXPECT_EQ(bid_after(0.525, 5.2), 1051u);
  EXPECT_EQ(bid_after(0.51, 5.3), 1051u);
}

TEST(ConsensusBundlePlugin, ValueFallsWithThePlaceInTheList) {
  Instance assigner(plugin(), three(), Values(plugin()).set("kept_per_place", 0.5));
  EXPECT_EQ(assigner.assign(frame_at(5.0).build(), own_row(0.2, 0.5, 0.9))[1], 1);
  EXPECT_EQ(offered(assigner, 5.0).claims[1], (Claim{2, 501}));
}

TEST(ConsensusBundlePlugin, WhatAPenalisedRobotHadIsFreeAndOldNewsDoNotBringItBack) {
  Instance assigner(plugin(), three());
  const Matrix utilities = own_row(0.1, 0.5, 0.4), alone = own_row(0.1, 0.5, 0.4, 2);
  hear(assigner, {3, 5.0, {{}, {3, 1500}, {}}});
  EXPECT_EQ(assigner.assign(frame_at(5.1).build(), utilities), (Rows{unknown, 2, 1}));
  const auto without_3 = [&](double time) { return frame_at(time).robot(3).penalised().build(); };
  EXPECT_EQ(assigner.assign(without_3(6.0), alone), (Rows{unknown, 1}));
  // Robot 1 tells of a packet of robot 3 that this robot had not heard; then that packet itself arrives.
  hear(assigner, {1, 6.1, {{}, {3, 1500}, {}}, {never, never, 55}});
  hear(assigner, {3, 5.5, {{}, {3, 1500}, {}}}, 1.0);
  EXPECT_EQ(assigner.assign(without_3(6.6), alone), (Rows{nothing, 1}));
  // It is back, and what was said before still counts for nothing.
  EXPECT_EQ(assigner.assign(frame_at(20.0).build(), utilities), (Rows{nothing, 1, nothing}));
  hear(assigner, {1, 20.1, {{}, {3, 1500}, {}}, {never, never, 59}});
  EXPECT_EQ(assigner.assign(frame_at(20.2).build(), utilities), (Rows{nothing, 1, nothing}));
  hear(assigner, {3, 20.3, {{}, {3, 1500}, {}}});
  EXPECT_EQ(assigner.assign(frame_at(20.4).build(), utilities), (Rows{nothing, 2, 1}));
}

TEST(ConsensusBundlePlugin, OfEachSenderTheNewestPacketCounts) {
  Instance assigner(plugin(), three());
  const Matrix utilities = own_row(0.1, 0.5, 0.4);
  hear(assigner, {3, 5.04, {{}, {}, {3, 1500}}});
  hear(assigner, {3, 5.01, {{}, {3, 1500}, {}}});  // in the same tick, and overtaken
  EXPECT_EQ(assigner.assign(frame_at(5.2).build(), utilities), (Rows{unknown, 1, 2}));
  hear(assigner, {3, 5.3, {{}, {3, 1500}, {}}}, -0.1);  // heard before it was sent
  EXPECT_EQ(assigner.assign(frame_at(5.4).build(), utilities), (Rows{unknown, 1, 2}));
}

TEST(ConsensusBundlePlugin, WhoIsGivenUpHoldsNothing) {
  Instance assigner(plugin(), three());
  hear(assigner, {3, 5.0, {{}, {3, 1500}, {}}});
  EXPECT_EQ(assigner.assign(frame_at(5.1).build(), own_row(0.1, 0.5, 0.4))[1], 2);
  const Scene scene = frame_at(5.2).robot(3).inactive().build();
  EXPECT_EQ(assigner.assign(scene, own_row(0.1, 0.5, 0.4, 2)), (Rows{unknown, 1}));
}

TEST(ConsensusBundlePlugin, AClaimLapsesWhenNothingIsHeardOfItsHolder) {
  Instance assigner(plugin(), three());
  const Matrix utilities = own_row(0.1, 0.5, 0.4);
  hear(assigner, {3, 5.0, {{}, {3, 1500}, {}}});
  EXPECT_EQ(assigner.assign(frame_at(29.9).build(), utilities)[1], 2);
  // Robot 1 has heard of it at 10 s.
  hear(assigner, {1, 30.0, {{}, {3, 1500}, {}}, {never, never, 100}});
  EXPECT_EQ(assigner.assign(frame_at(34.9).build(), utilities)[1], 2);
  EXPECT_EQ(assigner.assign(frame_at(35.1).build(), utilities)[1], 1);
}

TEST(ConsensusBundlePlugin, ALaterEpochMakesItBidAnew) {
  Instance assigner(plugin(), three());
  const auto bid_and_epoch = [&](double utility, double time) {
    assigner.assign(frame_at(time).build(), own_row(0.1, utility, 0.4));
    std::uint8_t epoch = 0;
    const std::uint32_t bid = offered(assigner, time, &epoch).claims[1].bid;
    return std::pair(static_cast<int>(epoch), bid);
  };
  EXPECT_EQ(bid_and_epoch(0.5, 5.0), std::pair(0, 1001u));
  EXPECT_EQ(bid_and_epoch(0.51, 5.1), std::pair(0, 1001u));
  hear(assigner, {3, 5.2, std::vector<Claim>(3), {never, never, never}, 4});
  EXPECT_EQ(bid_and_epoch(0.51, 5.3), std::pair(4, 1021u));
  // One that still speaks in an earlier epoch is believed, too: stamps tell what is out of date.
  hear(assigner, {1, 5.4, {{}, {1, 1500}, {}}, {never, never, never}, 2});
  EXPECT_EQ(assigner.assign(frame_at(5.5).build(), own_row(0.1, 0.51, 0.4)), (Rows{1, 2, nothing}));
}

TEST(ConsensusBundlePlugin, OtherRobotsBeginAnEpoch) {
  Instance assigner(plugin(), three());
  std::uint8_t epoch = 0;
  const auto bid = [&](const Scene& scene, double utility, double time, std::uint32_t rows) {
    assigner.assign(scene, own_row(0.1, utility, 0.4, rows));
    return offered(assigner, time, &epoch).claims[1].bid;
  };
  EXPECT_EQ(bid(frame_at(5.0).build(), 0.5, 5.0, 3), 1001u);
  EXPECT_EQ(bid(frame_at(5.1).robot(3).inactive().build(), 0.51, 5.1, 2), 1001u);  // unheard is not penalised
  EXPECT_EQ(epoch, 0);
  EXPECT_EQ(bid(frame_at(5.2).robot(3).penalised().build(), 0.51, 5.2, 2), 1021u);
  EXPECT_EQ(epoch, 1);
}

TEST(ConsensusBundlePlugin, WhoDoesNotPlayClaimsNothing) {
  Instance assigner(plugin(), three());
  assigner.assign(frame_at(5.0).build(), own_row(0.1, 0.5, 0.4));
  tell(assigner);
  const Scene away = frame_at(5.1).robot(2).penalised().build();
  EXPECT_EQ(assigner.assign(away, Matrix(2, 3)), (Rows{unknown, unknown}));
  EXPECT_EQ(offered(assigner, 5.1).claims, std::vector<Claim>(3));
  EXPECT_EQ(assigner.assign(frame_at(50.0).build(), own_row(0.9, 0.5, 0.4))[1], 0);  // and not what it told before
}

TEST(ConsensusBundlePlugin, ABundlePlaysItsFirstTask) {
  Instance assigner(plugin(), three(), Values(plugin()).set("bundle", 2.0));
  EXPECT_EQ(assigner.assign(frame_at(5.0).build(), own_row(0.1, 0.5, 0.9))[1], 2);
  const auto told = offered(assigner, 5.0);
  EXPECT_EQ(told.claims[2].winner, 2);
  EXPECT_EQ(told.claims[1].winner, 2);
  EXPECT_LT(told.claims[1].bid, told.claims[2].bid);
  hear(assigner, {3, 5.1, {{}, {}, {3, 1900}}});
  EXPECT_EQ(assigner.assign(frame_at(5.2).build(), own_row(0.1, 0.5, 0.9)), (Rows{unknown, 1, 2}));
}

// What the bundle becomes where packets have room for 64 bytes, as seen by what a robot that is alone on the air says.
struct Large {
  std::size_t says = 0;  // tasks that it wins
  std::size_t bytes = 0;
  unsigned refused = 0;
  std::vector<std::string> log;
};
Large large(int robots, int roles, double bundle) {
  EnvironmentBuilder environment;
  environment.team_size(static_cast<unsigned>(robots)).own(2);
  std::vector<std::string> many;
  for (int k = 0; k < roles; ++k) many.push_back("role_" + std::to_string(k));
  environment.roles(many);
  Instance assigner(plugin(), environment, Values(plugin()).set("bundle", bundle));
  FrameBuilder frame;
  frame.roles(many).team_size(robots).own(2).time(5.0);
  for (int number = 1; number <= robots; ++number) frame.robot(number);
  for (const std::string& each : many) frame.task(each);
  Matrix utilities(static_cast<std::uint32_t>(robots), static_cast<std::uint32_t>(roles));
  for (std::size_t column = 0; column < many.size(); ++column) {
    utilities(1, column) = 0.01 * static_cast<double>(column);
  }
  EXPECT_EQ(assigner.assign(frame.build(), utilities)[1], roles - 1);
  Large out;
  for (const auto& line : assigner.host().log) {
    EXPECT_EQ(line.level, REGISTA_LOG_WARNING);
    out.log.push_back(line.text);
  }
  out.refused = assigner.host().refused;
  if (assigner.host().offers.empty()) return out;
  Segment segment;
  segment.setup(static_cast<std::size_t>(robots), many.size());
  out.bytes = assigner.host().offers.back().bytes.size();
  while (segment.bytes(out.says) < out.bytes) ++out.says;
  return out;
}

TEST(ConsensusBundlePlugin, TheBundleFitsIntoAPacket) {
  const Large fits = large(11, 27, 2.0);  // 22 tasks in 60 bytes
  EXPECT_EQ(fits.says, 2u);
  EXPECT_TRUE(fits.log.empty());
  const Large shorter = large(15, 27, 2.0);  // 27 tasks in 74 bytes, 15 in 50
  EXPECT_EQ(shorter.says, 1u);
  EXPECT_EQ(shorter.refused, 0u);
  EXPECT_EQ(shorter.log, std::vector<std::string>{"a packet has room for 64 bytes of bids: bundle is 1 and not 2"});
  EXPECT_EQ(large(11, 27, 16.0).says, 2u);
  EXPECT_TRUE(large(7, 64, 1.0).log.empty());
}

TEST(ConsensusBundlePlugin, SaysWhenNoBundleFits) {
  const Large team = large(22, 27, 1.0);
  EXPECT_EQ(team.log, std::vector<std::string>{"a packet has room for 64 bytes of bids, and a task for each robot may "
                                               "take 74: what does not fit is not sent"});
  EXPECT_EQ(team.says, 1u);  // as long as it knows of few claims it is heard
  EXPECT_EQ(team.refused, 0u);
}

TEST(ConsensusBundlePlugin, AtTheReserveRolesGoByRank) {
  Instance assigner(plugin(), three());
  const Matrix utilities = own_row(0.1, 0.5, 0.4);
  hear(assigner, {3, 5.0, {{}, {3, 1500}, {}}});
  EXPECT_EQ(assigner.assign(frame_at(5.1).build(), utilities), (Rows{unknown, 2, 1}));
  tell(assigner);
  assigner.host().budget.packets_left = 30;
  EXPECT_EQ(assigner.assign(frame_at(5.2).build(), utilities), (Rows{0, 1, 2}));
  EXPECT_EQ(assigner.host().offers.size(), 1u);  // nothing new
  assigner.host().budget.packets_left = 31;      // what the others have won still counts
  EXPECT_EQ(assigner.assign(frame_at(5.3).build(), utilities), (Rows{unknown, 2, 1}));
}

TEST(ConsensusBundlePlugin, SaysInWordsWhatItSays) {
  Instance assigner(plugin(), three());
  hear(assigner, {3, 4.9, {{}, {3, 1500}, {}}});
  assigner.assign(frame_at(5.0).build(), own_row(0.1, 0.5, 0.4));
  EXPECT_EQ(assigner.describe(assigner.host().offers.back().bytes),
            "epoch 0: striker 3 with 1500, supporter 2 with 801");
  EXPECT_EQ(assigner.describe(std::vector<std::uint8_t>(3, 255)), "no claims of this team");
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "consensus_bundle");

}  // namespace
