// SPDX-License-Identifier: MIT
// The plugin in scenes: which task is the striker's, who gets what by number, what is said, and a whole rehearsal of a
// team whose lists have no striker now and then.
#include <gtest/gtest.h>

#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>
#include <regista/testkit/rehearsal.hpp>

#include "word.hpp"

namespace {

using namespace regista::testkit;
using Rows = std::vector<std::int32_t>;
constexpr double forbidden = -std::numeric_limits<double>::infinity();

const Loaded& hulks_plugin() {
  static const Loaded plugin(REGISTA_PLUGIN_FILE, "hulks");
  return plugin;
}
Values named() { return Values(hulks_plugin()).set("striker", "striker"); }
std::size_t roles() { return usual_roles().size(); }
int id_of(const char* role) { return static_cast<int>(std::ranges::find(usual_roles(), role) - usual_roles().begin()); }

// Robots 1 to 4 at x = 0, 1, 2, 3; the ball at x = 2.
FrameBuilder scene(int own, double time) {
  FrameBuilder frame;
  frame.own(own).time(time).ball(2, 0);
  for (int number = 1; number <= 4; ++number) frame.robot(number).at(number - 1, 0);
  frame.task("goalkeeper").task("supporter").at(0, 2).task("striker").at(2, 0).task("jolly").at(1, 1);
  return frame;
}
std::vector<std::uint8_t> claim(double seconds, const char* role = "striker") {
  std::vector<std::uint8_t> bytes;
  hulks::write({true, static_cast<std::uint32_t>(1000.0 * seconds), id_of(role)}, roles(), bytes);
  return bytes;
}

TEST(HulksPlugin, TheHighestNumberBeginsAndTheRestGoesByNumber) {
  Instance assigner(hulks_plugin(), EnvironmentBuilder{}.own(2), named());
  EXPECT_EQ(assigner.assign(scene(2, 1.0).build(), Matrix(4, 4)), (Rows{0, 1, 3, 2}));
  EXPECT_TRUE(assigner.host().offers.empty());
}

TEST(HulksPlugin, WhoHearsAClaimAndNeedsLessTimeClaims) {
  const auto after_hearing = [](int own, double seconds) {
    Instance assigner(hulks_plugin(), EnvironmentBuilder{}.own(own), named());
    assigner.receive(4, claim(seconds), 0.9, 1.0);
    const Rows rows = assigner.assign(scene(own, 1.0).build(), Matrix(4, 4));
    return std::pair(rows, assigner.host().offers.size());
  };
  EXPECT_EQ(after_hearing(3, 4.0), std::pair(Rows({0, 1, 2, 3}), std::size_t{1}));  // it stands at the ball
  EXPECT_EQ(after_hearing(2, 4.0), std::pair(Rows({0, 2, 1, 3}), std::size_t{1}));  // so long, too: the lower number
  EXPECT_EQ(after_hearing(2, 3.9), std::pair(Rows({0, 1, 3, 2}), std::size_t{0}));
}

TEST(HulksPlugin, SaysItsClaimAtOnceAndKeepsItStanding) {
  Instance assigner(hulks_plugin(), EnvironmentBuilder{}.own(4), named());
  assigner.assign(scene(4, 1.0).build(), Matrix(4, 4));
  ASSERT_EQ(assigner.host().offers.size(), 1u);
  EXPECT_EQ(assigner.host().offers[0].bytes, claim(4.0));
  EXPECT_EQ(assigner.host().offers[0].urgency, 1.0);
  EXPECT_EQ(assigner.describe(assigner.host().offers[0].bytes), "claims striker, 4000 ms from the ball");
  assigner.transmitted(assigner.host().offers[0].handle);
  assigner.assign(scene(4, 1.1).build(), Matrix(4, 4));
  ASSERT_EQ(assigner.host().offers.size(), 2u);
  EXPECT_EQ(assigner.host().offers[1].urgency, 0.5);
  assigner.receive(3, claim(0.0), 1.1, 1.2);
  EXPECT_EQ(assigner.assign(scene(4, 1.2).build(), Matrix(4, 4)), (Rows{0, 1, 2, 3}));
  EXPECT_TRUE(assigner.host().offers[1].withdrawn);
}

TEST(HulksPlugin, SaysThatTheBallIsLost) {
  Instance assigner(hulks_plugin(), EnvironmentBuilder{}.own(4), named());
  assigner.assign(scene(4, 1.0).build(), Matrix(4, 4));
  assigner.transmitted(assigner.host().offers[0].handle);
  assigner.assign(scene(4, 2.5).ball_age(1.5).build(), Matrix(4, 4));
  ASSERT_EQ(assigner.host().offers.size(), 2u);
  EXPECT_EQ(assigner.describe(assigner.host().offers[1].bytes), "has lost the ball");
  EXPECT_EQ(assigner.host().offers[1].urgency, 1.0);
  EXPECT_EQ(assigner.describe(std::vector<std::uint8_t>(9)), "no word of this team");
}

TEST(HulksPlugin, OnlyTheOwnEyesLetASilentTeamClaim) {
  const auto claims_after_silence = [](bool sees) {
    Instance assigner(hulks_plugin(), EnvironmentBuilder{}.own(1), named());
    for (int tick = 0; tick <= 40; ++tick) {
      assigner.host().sees_ball = sees && tick < 5;  // it remembers for 3 s
      assigner.assign(scene(1, 1.0 + 0.1 * tick).build(), Matrix(4, 4));
    }
    return !assigner.host().offers.empty();
  };
  EXPECT_TRUE(claims_after_silence(true));
  EXPECT_FALSE(claims_after_silence(false));
}

TEST(HulksPlugin, InReadyEverythingGoesByNumber) {
  Instance assigner(hulks_plugin(), EnvironmentBuilder{}.own(3), named());
  assigner.receive(2, claim(0.5), 0.9, 1.0);
  EXPECT_EQ(assigner.assign(scene(3, 1.0).phase(REGISTA_PHASE_READY).build(), Matrix(4, 4)), (Rows{0, 1, 3, 2}));
  EXPECT_TRUE(assigner.host().offers.empty());
}

TEST(HulksPlugin, TheNextNumberKeepsTheGoalOfAKeeperThatPlaysTheBall) {
  Instance assigner(hulks_plugin(), EnvironmentBuilder{}.own(2), named());
  assigner.receive(1, claim(0.1), 0.9, 1.0);
  EXPECT_EQ(assigner.assign(scene(2, 1.0).build(), Matrix(4, 4)), (Rows{2, 0, 1, 3}));
}

TEST(HulksPlugin, AListWithoutTheRoleGoesByNumberAlone) {
  FrameBuilder frame;
  frame.own(1).time(1.0).robot(1).robot(2).robot(3).ball(0, 0);
  frame.task("search_1").task("goalkeeper").task("search_2");
  Instance by_name(hulks_plugin(), EnvironmentBuilder{}.own(1), named());
  EXPECT_EQ(by_name.assign(frame.build(), Matrix(3, 3)), (Rows{1, 0, 2}));
  Instance most_important(hulks_plugin(), EnvironmentBuilder{}.own(1));
  EXPECT_EQ(most_important.assign(frame.build(), Matrix(3, 3)), (Rows{1, 2, 0}));
}

TEST(HulksPlugin, ForbiddenPairsAreLeftAlone) {
  Instance assigner(hulks_plugin(), EnvironmentBuilder{}.own(4), named());
  Matrix utilities(4, 4);
  utilities(3, 2) = utilities(0, 0) = forbidden;
  EXPECT_EQ(assigner.assign(scene(4, 1.0).build(), utilities), (Rows{1, 0, 2, 3}));
  EXPECT_TRUE(assigner.host().offers.empty());
  assigner.receive(1, claim(0.0), 1.0, 1.1);
  utilities(0, 2) = forbidden;  // robot 1 does it all the same
  EXPECT_EQ(assigner.assign(scene(4, 1.1).build(), utilities), (Rows{REGISTA_UNKNOWN_TASK, 0, 1, 3}));
}

TEST(HulksPlugin, WhoPlaysATaskThatIsNotKnownHereKeepsIt) {
  Instance assigner(hulks_plugin(), EnvironmentBuilder{}.own(3), named());
  FrameBuilder frame = scene(3, 1.0);
  frame.robot(2).role("wing_left");
  EXPECT_EQ(assigner.assign(frame.build(), Matrix(4, 4)), (Rows{0, REGISTA_UNKNOWN_TASK, 1, 2}));
  frame.robot(2).age(30.0);  // too old to count
  EXPECT_EQ(assigner.assign(frame.build(), Matrix(4, 4)), (Rows{0, 1, 3, 2}));
}

// It may be one of a list that was played before.
TEST(HulksPlugin, AClaimOfATaskThatIsNotAmongTheseSeatsNobody) {
  Instance assigner(hulks_plugin(), EnvironmentBuilder{}.own(3), named());
  assigner.receive(2, claim(0.0, "wing_left"), 0.9, 1.0);
  FrameBuilder frame = scene(3, 1.0);
  frame.robot(2).role("supporter");
  EXPECT_EQ(assigner.assign(frame.build(), Matrix(4, 4)), (Rows{0, 1, 2, 3}));
}

TEST(HulksPlugin, ATeamAgreesWhoseListsHaveAStrikerNowAndThen) {
  for (const double loss : {0.0, 0.4}) {
    RehearsalConditions conditions;
    conditions.radio.loss = loss;
    conditions.seed = 40;
    const Rehearsal rehearsal = rehearse(hulks_plugin(), named(), conditions);
    EXPECT_TRUE(rehearsal.broken.empty());
    for (const Act& act : rehearsal.acts) {
      EXPECT_TRUE(act.settled_after) << loss << ", " << act.name << ": " << act.disagreement;
    }
  }
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "hulks");

}  // namespace
