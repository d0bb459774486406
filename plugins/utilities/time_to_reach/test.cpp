// SPDX-License-Identifier: MIT
// Both forms by hand, and who counts as sooner or later.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using time_to_reach::Form;
using time_to_reach::no_task;
using time_to_reach::Row;
using time_to_reach::Settings;

std::vector<double> scores(const std::vector<Row>& rows, const std::vector<double>& times, std::size_t columns,
                           const Settings& settings) {
  std::vector<double> out(rows.size() * (columns + 1), -1.0);
  time_to_reach::score(rows, columns, {times.data(), columns}, settings, {out.data(), columns + 1});
  return out;
}

TEST(TimeToReach, BothFormsByHand) {
  const std::vector<double> times{0.0, 20.0, 40.0, 80.0, 10.0, 1e9};
  EXPECT_EQ(scores({{}, {}}, times, 3, {Form::linear, 40.0}),
            (std::vector<double>{1.0, 0.5, 0.0, -1.0, 0.0, 0.75, 0.0, -1.0}));
  const auto inverse = scores({{}, {}}, times, 3, {Form::inverse, 40.0});
  for (std::size_t k = 0; k < 6; ++k) EXPECT_DOUBLE_EQ(inverse[k + k / 3], 40.0 / (40.0 + times[k]));
}

TEST(TimeToReach, TheIncumbentIsSoonerAndTheFallenLater) {
  const std::vector<double> times{20.0, 20.0, 20.0, 20.0};
  EXPECT_EQ(scores({{0.0, 1}, {10.0, no_task}}, times, 2, {Form::linear, 40.0, 10.0}),
            (std::vector<double>{0.5, 0.75, -1.0, 0.25, 0.25, -1.0}));
  EXPECT_EQ(scores({{10.0, 0}}, {20.0, 20.0}, 2, {Form::linear, 40.0, 10.0}), (std::vector<double>{0.5, 0.25, -1.0}));
  // Never sooner than at once.
  EXPECT_EQ(scores({{0.0, 0}}, {3.0}, 1, {Form::inverse, 40.0, 10.0})[0], 1.0);
}

TEST(TimeToReach, SoonerIsNeverWorseAndAllIsInRange) {
  std::mt19937 random(14);
  std::uniform_real_distribution<double> any(0.0, 120.0);
  for (int round = 0; round < 10000; ++round) {
    const double a = any(random), b = any(random);
    for (const Form form : {Form::linear, Form::inverse}) {
      const auto out = scores({{}}, {a, b}, 2, {form, 60.0});
      EXPECT_TRUE(a < b ? out[0] >= out[1] : out[0] <= out[1]);
      for (const std::size_t j : {0u, 1u}) {
        EXPECT_GE(out[j], 0.0);
        EXPECT_LE(out[j], 1.0);
      }
    }
  }
}

// Where no time is beyond the scale, the largest sum of linear scores is the least sum of times: each entry is the time
// mirrored.
TEST(TimeToReach, LinearScoresAddUpAsTimesDo) {
  const auto out = scores({{}, {}}, {10.0, 12.0, 25.0, 3.0}, 2, {Form::linear, 50.0});
  EXPECT_NEAR(out[0] + out[4], 2.0 - (10.0 + 3.0) / 50.0, 1e-15);
  EXPECT_NEAR(out[1] + out[3], 2.0 - (12.0 + 25.0) / 50.0, 1e-15);
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

// At 0.25 m/s: robot 2 needs 4 s to the striker's place and 8 s to the supporter's; robot 3 lies at the first.
FrameBuilder frame() {
  return FrameBuilder{}
      .own(2)
      .walk_speed(0.25)
      .robot(2)
      .at(0, 0)
      .role("striker")
      .robot(3)
      .at(1, 0)
      .role("supporter")
      .fallen(5.0)
      .task("striker")
      .at(1, 0)
      .task("supporter")
      .at(0, 2)
      .previous(2, "supporter");
}

TEST(TimeToReachPlugin, TimesOfTheFrameContainGettingUp) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "time_to_reach");
  Instance utility(plugin, EnvironmentBuilder{}.own(2), Values(plugin).set("scale", 20.0));
  const Matrix out = utility.score(frame().build());
  EXPECT_DOUBLE_EQ(out(0, 0), 0.8);
  EXPECT_DOUBLE_EQ(out(0, 1), 0.6);
  EXPECT_DOUBLE_EQ(out(1, 0), 0.75);
  Instance wary(plugin, EnvironmentBuilder{}.own(2), Values(plugin).set("scale", 20.0).set("getting_up", 5.0));
  EXPECT_DOUBLE_EQ(wary.score(frame().build())(0, 0), 0.8);
  EXPECT_DOUBLE_EQ(wary.score(frame().build())(1, 0), 0.5);
}

TEST(TimeToReachPlugin, TheIncumbentIsWhoDecidedSoOrSaidSo) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "time_to_reach");
  Instance utility(plugin, EnvironmentBuilder{}.own(2), Values(plugin).set("scale", 20.0).set("incumbent", 2.0));
  const Matrix mine = utility.score(frame().build());
  EXPECT_DOUBLE_EQ(mine(0, 0), 0.8);
  EXPECT_DOUBLE_EQ(mine(0, 1), 0.7);  // its last assignment
  EXPECT_DOUBLE_EQ(mine(1, 0), 0.75);
  const Matrix common = utility.score(frame().knowledge(REGISTA_COMMON).build());
  EXPECT_DOUBLE_EQ(common(0, 0), 0.9);  // what it has said
  EXPECT_DOUBLE_EQ(common(0, 1), 0.6);
}

REGISTA_UTILITY_CONTRACT(REGISTA_PLUGIN_FILE, "time_to_reach", {.order_of_opponents_is_irrelevant = true});

}  // namespace
