// SPDX-License-Identifier: MIT
// The delay against a clock, the pairing beside a role that is kept, and what in a utility changes no choice.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using delayed_greedy::Delay, delayed_greedy::forbidden, delayed_greedy::no_task, delayed_greedy::Settings;
using Rows = std::vector<std::int32_t>;
using Ids = std::vector<int>;

// Roles that a robot has when these are computed, ten times a second.
Ids played(const Ids& wanted, const Settings& settings = {}) {
  Delay delay;
  Ids out;
  int has = no_task;
  for (std::size_t tick = 0; tick < wanted.size(); ++tick) {
    if (delay.changes(settings, 0.1 * static_cast<double>(tick), has, wanted[tick], true)) has = wanted[tick];
    out.push_back(has);
  }
  return out;
}
Ids times(int count, int id, Ids before = {}) {
  before.insert(before.end(), static_cast<std::size_t>(count), id);
  return before;
}

TEST(Delay, AnotherRoleIsTakenOneSecondAfterItIsComputed) {
  EXPECT_EQ(played(times(20, 2, times(5, 1))), times(10, 2, times(15, 1)));
  EXPECT_EQ(played(times(20, 2, times(5, 1)), {0.0, false}), times(20, 2, times(5, 1)));
  EXPECT_EQ(played(times(5, no_task, times(1, 1))), times(6, 1));
}

// As released: one second after the first difference, what is computed then.
TEST(Delay, WhatIsComputedInBetweenDoesNotCount) {
  const Ids flickering = times(5, 3, times(6, 1, times(1, 2, times(5, 1))));
  EXPECT_EQ(played(flickering), times(2, 3, times(15, 1)));
  EXPECT_EQ(played(flickering, {1.0, true}), times(17, 1));
  const Ids back = times(20, 1, times(4, 2, times(5, 1)));
  EXPECT_EQ(played(back), times(29, 1));
  // The clock begins anew with the next difference.
  const Ids again = times(15, 2, times(12, 1, times(1, 2, times(5, 1))));
  EXPECT_EQ(played(again), times(5, 2, times(28, 1)));
}

TEST(Delay, LastingDifferencesAreThoseThatNeverEnded) {
  std::mt19937 random(3);
  for (int round = 0; round < 2000; ++round) {
    Ids wanted;
    while (wanted.size() < 60)
      wanted = times(1 + static_cast<int>(random() % 14), static_cast<int>(random() % 3), wanted);
    for (const bool lasting : {false, true}) {
      const Ids out = played(wanted, {1.0, lasting});
      for (std::size_t k = 1; k < out.size(); ++k) {
        if (out[k] == out[k - 1]) continue;
        ASSERT_EQ(out[k], wanted[k]);
        ASSERT_GE(k, 11u);
        // Ten ticks before it had that role, and wanted another; of lasting ones at all ticks since.
        for (std::size_t back = 1; back <= 10; ++back) ASSERT_EQ(out[k - back], out[k - 1]);
        ASSERT_NE(wanted[k - 10], out[k - 1]);
        for (std::size_t back = 1; lasting && back < 10; ++back) ASSERT_NE(wanted[k - back], out[k - 1]);
      }
    }
  }
}

TEST(Delay, NothingIsWaitedForWithoutARoleOrWithOneThatIsGone) {
  Delay delay;
  EXPECT_TRUE(delay.changes({}, 0.0, no_task, 4, false));
  EXPECT_FALSE(delay.changes({}, 0.2, 4, 5, true));
  EXPECT_TRUE(delay.changes({}, 0.3, 4, 5, false));
  EXPECT_FALSE(delay.changes({}, 1.25, 5, 6, true));  // the clock begins anew
  EXPECT_FALSE(delay.changes({}, 2.0, 5, 6, true));
  delay.forget();
  EXPECT_FALSE(delay.changes({}, 2.3, 5, 6, true));
}

// --- The pairing -------------------------------------------------------------------------------------------------

struct Problem {
  std::size_t rows, columns;
  std::vector<double> values;
  std::vector<std::uint32_t> order;
  assignment::Matrix matrix() const { return {values.data(), rows, columns, columns}; }
  Rows greedy() const {
    Rows out(rows, -1);
    greedy::assign(matrix(), order, out);
    return out;
  }
};

// Whole numbers, so that sums and products are exact; many ties, and pairs that must not be.
Problem problem(std::mt19937& random) {
  Problem out{1 + random() % 8, 1 + random() % 8, {}, {}};
  for (std::size_t k = 0; k < out.rows * out.columns; ++k) {
    out.values.push_back(random() % 6 == 0 ? forbidden : static_cast<double>(random() % 12));
  }
  out.order.resize(out.columns);
  std::iota(out.order.begin(), out.order.end(), 0u);
  std::shuffle(out.order.begin(), out.order.end(), random);
  return out;
}

// Without that row and that column, by hand: greedy on what is left.
TEST(DelayedGreedy, BesideARoleThatIsKeptTheRestIsGreedy) {
  std::mt19937 random(4);
  for (int round = 0; round < 10000; ++round) {
    const Problem all = problem(random);
    const std::size_t row = random() % all.rows, column = random() % all.columns;
    if (all.values[row * all.columns + column] == forbidden) continue;
    Rows out(all.rows, -1);
    std::vector<double> scratch(all.rows * all.columns);
    delayed_greedy::assign_beside(all.matrix(), all.order, row, column, scratch, out);
    ASSERT_EQ(out[row], static_cast<std::int32_t>(column));
    Problem rest{all.rows - 1, all.columns - 1, {}, {}};
    for (std::size_t i = 0; i < all.rows; ++i) {
      for (std::size_t j = 0; j < all.columns; ++j) {
        if (i != row && j != column) rest.values.push_back(all.values[i * all.columns + j]);
      }
    }
    for (const std::uint32_t each : all.order) {
      if (each != column) rest.order.push_back(each > column ? each - 1 : each);
    }
    Rows expected = rest.greedy();
    for (std::int32_t& each : expected) each += each >= static_cast<std::int32_t>(column) ? 1 : 0;
    out.erase(out.begin() + static_cast<std::ptrdiff_t>(row));
    ASSERT_EQ(out, expected);
  }
}

// Why it does not matter that the released code divides by the sum of the weights.
TEST(DelayedGreedy, ScalingAllWeightsChangesNoChoice) {
  std::mt19937 random(5);
  for (int round = 0; round < 10000; ++round) {
    Problem one = problem(random);
    const Rows before = one.greedy();
    const double factor = 1.0 + static_cast<double>(random() % 1000);
    for (double& each : one.values) each *= factor;
    ASSERT_EQ(one.greedy(), before);
  }
}

// Why persistence does nothing there: it counts on all rows of the own role's column alike.
TEST(DelayedGreedy, WhatIsAlikeOnAllRowsOfAColumnChangesNoChoice) {
  std::mt19937 random(6);
  bool matters_on_a_row = false;
  for (int round = 0; round < 10000; ++round) {
    Problem one = problem(random);
    const Rows before = one.greedy();
    const std::size_t column = random() % one.columns;
    const double bonus = static_cast<double>(random() % 20);
    Problem row_alone = one;
    row_alone.values[column] += bonus;
    for (std::size_t i = 0; i < one.rows; ++i) one.values[i * one.columns + column] += bonus;
    ASSERT_EQ(one.greedy(), before);
    matters_on_a_row = matters_on_a_row || row_alone.greedy() != before;
  }
  EXPECT_TRUE(matters_on_a_row);
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

FrameBuilder two_robots(double time) {
  FrameBuilder frame;
  frame.own(2).time(time).robot(2).robot(3).task("striker").task("supporter");
  return frame;
}
Matrix prefers(bool own_is_striker) {
  Matrix utilities(2, 2);
  utilities(own_is_striker ? 0 : 1, 0) = 0.9;
  return utilities;
}

TEST(DelayedGreedyPlugin, TheOwnRoleIsKeptForASecond) {
  Instance assigner(Loaded(REGISTA_PLUGIN_FILE, "delayed_greedy"), EnvironmentBuilder{}.own(2));
  const auto at = [](double time, const char* has) { return two_robots(time).previous(2, has).build(); };
  EXPECT_EQ(assigner.assign(two_robots(10.0).build(), prefers(true)), (Rows{0, 1}));
  EXPECT_EQ(assigner.assign(at(10.1, "striker"), prefers(false)), (Rows{0, 1}));
  EXPECT_EQ(assigner.assign(at(11.0, "striker"), prefers(false)), (Rows{0, 1}));
  EXPECT_EQ(assigner.assign(at(11.1, "striker"), prefers(false)), (Rows{1, 0}));
  EXPECT_EQ(assigner.assign(at(11.2, "supporter"), prefers(true)), (Rows{1, 0}));
}

TEST(DelayedGreedyPlugin, TheRolesOfOthersAreNotDelayed) {
  Instance assigner(Loaded(REGISTA_PLUGIN_FILE, "delayed_greedy"), EnvironmentBuilder{}.own(2));
  FrameBuilder scene = two_robots(10.0).robot(4).task("jolly").previous(2, "striker");
  scene.previous(3, "supporter").previous(4, "jolly");
  Matrix utilities(3, 3);
  utilities(0, 0) = utilities(1, 2) = utilities(2, 1) = 0.9;
  EXPECT_EQ(assigner.assign(scene.build(), utilities), (Rows{0, 2, 1}));
}

TEST(DelayedGreedyPlugin, ARoleThatIsGoneIsNotWaitedFor) {
  Instance assigner(Loaded(REGISTA_PLUGIN_FILE, "delayed_greedy"), EnvironmentBuilder{}.own(2));
  Matrix utilities = prefers(false);
  utilities(0, 0) = forbidden;
  EXPECT_EQ(assigner.assign(two_robots(10.1).previous(2, "striker").build(), utilities), (Rows{1, 0}));
  FrameBuilder searching;
  searching.own(2).time(10.2).robot(2).robot(3).task("search_1").task("search_2").previous(2, "supporter");
  EXPECT_EQ(assigner.assign(searching.build(), prefers(false)), (Rows{1, 0}));
}

TEST(DelayedGreedyPlugin, WhoIsPenalisedWaitsForNothing) {
  Instance assigner(Loaded(REGISTA_PLUGIN_FILE, "delayed_greedy"), EnvironmentBuilder{}.own(2));
  const auto at = [](double time) { return two_robots(time).previous(2, "striker"); };
  assigner.assign(at(10.0).build(), prefers(false));
  FrameBuilder away = at(10.5);
  away.robot(2).penalised();
  EXPECT_EQ(assigner.assign(away.build(), Matrix(1, 2)), (Rows{0}));
  EXPECT_EQ(assigner.assign(at(11.1).build(), prefers(false)), (Rows{0, 1}));  // its time begins anew
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "delayed_greedy");

}  // namespace
