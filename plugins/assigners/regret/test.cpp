// SPDX-License-Identifier: MIT
// Cases by hand, and the rule played out by its definition on random matrices.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <tuple>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "../hungarian/algorithm.hpp"
#include "algorithm.hpp"

namespace {

using regret::forbidden;
using Rows = std::vector<std::int32_t>;
using Order = std::vector<std::uint32_t>;

struct Case {
  std::size_t rows, columns;
  std::vector<double> values;
  Order order;
  double operator()(std::size_t i, std::size_t j) const { return values[i * columns + j]; }
};

Rows assign(const Case& problem, regret::Solver& solver) {
  Rows out(problem.rows, -7);
  solver.assign({problem.values.data(), problem.rows, problem.columns, problem.columns}, problem.order, out);
  return out;
}

Rows assign(const Case& problem) {
  regret::Solver solver;
  return assign(problem, solver);
}

TEST(Regret, WhoHasMostToLoseGoesFirst) {
  // Greedy by robots gives 9 + 1; robot 1 would lose 7, robot 0 only 1.
  EXPECT_EQ(assign({2, 2, {9, 8, 8, 1}, {0, 1}}), (Rows{1, 0}));
}

TEST(Regret, ARobotWithOneTaskLeftGoesFirst) {
  EXPECT_EQ(assign({2, 2, {9, 0, 1, forbidden}, {0, 1}}), (Rows{1, 0}));
  EXPECT_EQ(assign({2, 2, {5, forbidden, 6, forbidden}, {0, 1}}), (Rows{-1, 0}));  // both: the larger utility
}

TEST(Regret, EqualsGoByUtilityThenTaskThenRobot) {
  EXPECT_EQ(assign({2, 3, {2, 1, 0, 3, 2, 0}, {0, 1, 2}}), (Rows{1, 0}));
  EXPECT_EQ(assign({3, 3, std::vector<double>(9, 1.0), {0, 1, 2}}), (Rows{0, 1, 2}));
  EXPECT_EQ(assign({3, 3, std::vector<double>(9, 1.0), {2, 0, 1}}), (Rows{2, 0, 1}));
  EXPECT_EQ(assign({2, 2, {1, 2, 2, 1}, {1, 0}}), (Rows{1, 0}));
}

TEST(Regret, EmptyMatrices) {
  EXPECT_EQ(assign({0, 0, {}, {}}), (Rows{}));
  EXPECT_EQ(assign({0, 3, {}, {0, 1, 2}}), (Rows{}));
  EXPECT_EQ(assign({3, 0, {}, {}}), (Rows{-1, -1, -1}));
  EXPECT_EQ(assign({2, 2, std::vector<double>(4, forbidden), {0, 1}}), (Rows{-1, -1}));
}

// The rule, word by word: sort the free robot's free utilities; choose the robot by a key.
Rows by_definition(const Case& problem) {
  Rows out(problem.rows, -1);
  Order free = problem.order;
  while (true) {
    using Key = std::tuple<double, double, std::size_t, std::size_t>;  // less goes first
    std::vector<std::pair<Key, std::uint32_t>> candidates;
    for (std::size_t i = 0; i < problem.rows; ++i) {
      if (out[i] >= 0) continue;
      std::vector<std::tuple<double, std::size_t>> wishes;
      for (std::size_t k = 0; k < free.size(); ++k) {
        if (problem(i, free[k]) != forbidden) wishes.emplace_back(-problem(i, free[k]), k);
      }
      if (wishes.empty()) continue;
      std::sort(wishes.begin(), wishes.end());
      const auto [best, place] = wishes[0];
      const double gap = wishes.size() > 1 ? std::get<0>(wishes[1]) - best : -forbidden;
      candidates.push_back({{-gap, best, place, i}, free[place]});
    }
    if (candidates.empty()) return out;
    const auto [key, column] = *std::min_element(candidates.begin(), candidates.end());
    out[std::get<3>(key)] = static_cast<std::int32_t>(column);
    std::erase(free, column);
  }
}

TEST(Regret, FollowsItsDefinitionOnRandomMatrices) {
  std::mt19937 random(13);
  std::uniform_int_distribution<int> size(0, 8);
  regret::Solver solver;  // one for all: nothing may be left over from the case before
  double reached = 0.0, largest = 0.0;
  for (int round = 0; round < 20000; ++round) {
    Case problem{static_cast<std::size_t>(size(random)), static_cast<std::size_t>(size(random)), {}, {}};
    std::uniform_int_distribution<int> value(-(round % 3), 1 + round % 9);
    problem.values.resize(problem.rows * problem.columns);
    for (double& each : problem.values) {
      const int drawn = value(random);
      each = drawn < 0 ? forbidden : drawn;
    }
    problem.order.resize(problem.columns);
    std::iota(problem.order.begin(), problem.order.end(), 0u);
    std::shuffle(problem.order.begin(), problem.order.end(), random);
    const Rows out = assign(problem, solver);
    ASSERT_EQ(out, by_definition(problem)) << "round " << round;

    // Never above the largest sum (without forbidden pairs, where numbers of pairs are equal), and near it.
    if (round % 3 != 0 || problem.rows == 0 || problem.columns == 0) continue;
    Rows best(problem.rows);
    hungarian::Solver().assign_any({problem.values.data(), problem.rows, problem.columns, problem.columns}, best);
    const auto sum = [&](const Rows& rows) {
      double total = 0.0;
      for (std::size_t i = 0; i < problem.rows; ++i) {
        if (rows[i] >= 0) total += problem(i, static_cast<std::size_t>(rows[i]));
      }
      return total;
    };
    ASSERT_LE(sum(out), sum(best)) << "round " << round;
    reached += sum(out);
    largest += sum(best);
  }
  EXPECT_GT(reached, 0.9 * largest);
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

TEST(RegretPlugin, AmongEqualsPriorityCountsNotTheOrderOfColumns) {
  Instance assigner(Loaded(REGISTA_PLUGIN_FILE, "regret"), EnvironmentBuilder{}.own(2));
  const Scene scene =
      FrameBuilder{}.own(2).robot(2).robot(3).task("supporter").priority(5).task("striker").priority(1).build();
  EXPECT_EQ(assigner.assign(scene, Matrix(2, 2)), (Rows{1, 0}));
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "regret");

}  // namespace
