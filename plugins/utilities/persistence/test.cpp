// SPDX-License-Identifier: MIT
// The algorithm by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using persistence_utility::Holder;
using persistence_utility::no_role;

TEST(Persistence, GrowsToOneWhereTheRoleIsHeldAndNowhereElse) {
  const std::vector<Holder> rows{{7, 2.5}, {no_role, 99.0}, {3, 10.0}, {5, 1e6}, {42, 3.0}, {9, -1.0}};
  const std::vector<int> tasks{3, 5, 7, 9};
  std::vector<double> out(6 * 5, 0.0), expected(6 * 5, 0.0);
  persistence_utility::score(rows, tasks, {10.0}, out.data(), 5);
  expected[0 * 5 + 2] = 0.25;
  expected[2 * 5 + 0] = 1.0;
  expected[3 * 5 + 1] = 1.0;
  EXPECT_EQ(out, expected);
}

TEST(Persistence, NothingToScore) {
  double nothing = -1.0;
  persistence_utility::score({}, {}, {10.0}, &nothing, 0);
  EXPECT_EQ(nothing, -1.0);
}

// SPQR 2023: p = 0.5 for the role held, times 0.9 each second; the weight is the team's.
TEST(Persistence, FadesEachSecondAsPublished) {
  const persistence_utility::Settings of_2023{0.0, 0.9};
  double p = 0.5;
  for (int second = 0; second < 60; ++second) {
    for (const double within : {0.0, 0.3, 0.999}) {
      EXPECT_NEAR(0.5 * persistence_utility::value(second + within, of_2023), p, 1e-15) << second;
    }
    p *= 0.9;
  }
  EXPECT_EQ(persistence_utility::value(-3.0, of_2023), 1.0);
  EXPECT_EQ(persistence_utility::value(1e300, of_2023), 0.0);
}

TEST(Persistence, FadesToNothingAndNotBelow) {
  for (double held = 0.0; held < 1e4; held += 7.3) {
    const double value = persistence_utility::value(held, {0.0, 0.9});
    EXPECT_TRUE(value == 0.0 || value >= 1e-12) << held;
    EXPECT_NEAR(value, std::pow(0.9, std::floor(held)), 1e-12);
  }
  EXPECT_EQ(persistence_utility::value(0.9, {0.0, 0.0}), 1.0);
  EXPECT_EQ(persistence_utility::value(1.0, {0.0, 0.0}), 0.0);
  EXPECT_EQ(persistence_utility::value(1e9, {0.0, 1.0}), 1.0);
}

TEST(Persistence, GrowsAndFadesAtOnce) {
  EXPECT_DOUBLE_EQ(persistence_utility::value(2.5, {5.0, 0.5}), 0.5 * 0.25);
  EXPECT_DOUBLE_EQ(persistence_utility::value(6.0, {5.0, 0.5}), 1.0 / 64.0);
}

// Without fading it is what it was before it could fade, to the last bit.
TEST(Persistence, WithoutFadingItIsTheRampAlone) {
  for (double held = -1.0; held < 200.0; held += 0.0371) {
    for (const double ramp_seconds : {0.1, 10.0, 120.0}) {
      EXPECT_EQ(persistence_utility::value(held, {ramp_seconds}), std::clamp(held / ramp_seconds, 0.0, 1.0));
    }
  }
}

TEST(Persistence, IsAStepWhereWholeNumbersMakeItOne) {
  const persistence_utility::Settings of_2022{10.0, 1.0, true};
  for (int tenths = -10; tenths < 300; ++tenths) {
    const int seconds = tenths / 10;
    const double published = seconds * 50 <= 500 ? seconds / 10 : 1;
    EXPECT_EQ(persistence_utility::value(tenths / 10.0, of_2022), published) << tenths;
  }
  EXPECT_EQ(persistence_utility::value(3.0, {0.0, 1.0, true}), 1.0);
  EXPECT_EQ(persistence_utility::value(12.0, {10.0, 0.5, true}), 1.0 / 4096.0);
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

// Robot 2 is the observer: it has taken the role of striker 4 s ago, but has last told of supporter, 9 s old.
Scene roles(int knowledge) {
  return FrameBuilder{}
      .own(2)
      .time(20.0)
      .knowledge(knowledge)
      .robot(2)
      .role("striker")
      .since(16.0)
      .robot(3)
      .role("supporter")
      .since(15.0)
      .previous(2, "striker")
      .task("striker")
      .task("supporter")
      .common([](WorldBuilder& world) { world.robot(2).role("supporter").since(11.0); })
      .build();
}

std::vector<double> entries(const char* rows, int knowledge) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "persistence");
  Instance utility(plugin, EnvironmentBuilder{}.own(2), Values(plugin).set("for_robots", rows));
  const Matrix out = utility.score(roles(knowledge));
  return {out(0, 0), out(0, 1), out(1, 0), out(1, 1)};
}

TEST(PersistencePlugin, OwnRowOrAllAndPrivateOrCommon) {
  EXPECT_EQ(entries("all", REGISTA_MINE), (std::vector<double>{0.4, 0.0, 0.0, 0.5}));
  EXPECT_EQ(entries("own", REGISTA_MINE), (std::vector<double>{0.4, 0.0, 0.0, 0.0}));
  EXPECT_EQ(entries("all", REGISTA_COMMON), (std::vector<double>{0.0, 0.9, 0.0, 0.5}));
  EXPECT_EQ(entries("own", REGISTA_COMMON), (std::vector<double>{0.0, 0.9, 0.0, 0.0}));
}

TEST(PersistencePlugin, TheUtilityOf2023) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "persistence");
  Instance utility(plugin, EnvironmentBuilder{}.own(2),
                   Values(plugin).set("for_robots", "own").set("ramp_seconds", 0.0).set("fade", 0.9));
  const Matrix out = utility.score(roles(REGISTA_MINE));
  EXPECT_NEAR(out(0, 0), 0.9 * 0.9 * 0.9 * 0.9, 1e-15);
  EXPECT_EQ(out(0, 1), 0.0);
  EXPECT_EQ(out(1, 1), 0.0);
}

TEST(PersistencePlugin, TheUtilityOf2022) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "persistence");
  for (const double ramp_seconds : {5.0, 4.0}) {  // the roles are 4 and 5 s old
    Instance utility(plugin, EnvironmentBuilder{}.own(2),
                     Values(plugin).set("ramp_seconds", ramp_seconds).set("step", true));
    const Matrix out = utility.score(roles(REGISTA_MINE));
    EXPECT_EQ(out(0, 0), ramp_seconds == 4.0 ? 1.0 : 0.0);
    EXPECT_EQ(out(1, 1), 1.0);
  }
}

REGISTA_UTILITY_CONTRACT(REGISTA_PLUGIN_FILE, "persistence", {.order_of_opponents_is_irrelevant = true});

}  // namespace
