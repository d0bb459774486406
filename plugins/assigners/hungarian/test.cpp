// SPDX-License-Identifier: MIT
// Against exhaustive search over small matrices with many ties, and the structure of the answer over large ones.
#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using hungarian::forbidden;
using Rows = std::vector<std::int32_t>;
using Order = std::vector<std::uint32_t>;

struct Case {
  std::size_t rows, columns;
  std::vector<double> values;
  Order order;
  double operator()(std::size_t i, std::size_t j) const { return values[i * columns + j]; }
};

Order in_sequence(std::size_t columns) {
  Order order(columns);
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

Rows assign(const Case& problem, hungarian::Solver& solver) {
  Rows out(problem.rows, -7);
  solver.assign({problem.values.data(), problem.rows, problem.columns, problem.columns}, problem.order, out);
  return out;
}

Rows assign(const Case& problem) {
  hungarian::Solver solver;
  return assign(problem, solver);
}

// Independent truth: dynamic programming over columns in order of importance and sets of free robots. Among all
// assignments: most pairs, then largest sum, then the lowest robot for the first column, and so on. Exact for integers.
struct Truth {
  const Case& problem;
  using Value = std::pair<int, double>;
  std::map<std::pair<std::size_t, unsigned>, Value> memory;

  Value best(std::size_t k, unsigned free) {
    if (k == problem.columns) return {0, 0.0};
    if (const auto known = memory.find({k, free}); known != memory.end()) return known->second;
    Value value = best(k + 1, free);
    for (std::size_t i = 0; i < problem.rows; ++i) {
      if (const auto found = with(k, free, i)) value = std::max(value, *found);
    }
    return memory[{k, free}] = value;
  }
  std::optional<Value> with(std::size_t k, unsigned free, std::size_t i) {
    const double utility = problem(i, problem.order[k]);
    if ((free >> i & 1u) == 0 || utility == forbidden) return std::nullopt;
    const Value rest = best(k + 1, free & ~(1u << i));
    return Value{rest.first + 1, rest.second + utility};
  }
  Rows least() {
    Rows out(problem.rows, -1);
    unsigned free = (1u << problem.rows) - 1u;
    for (std::size_t k = 0; k < problem.columns; ++k) {
      const Value value = best(k, free);
      for (std::size_t i = 0; i < problem.rows; ++i) {
        if (const auto found = with(k, free, i); found && *found == value) {
          out[i] = static_cast<std::int32_t>(problem.order[k]);
          free &= ~(1u << i);
          break;
        }
      }
    }
    return out;
  }
};

Case random_case(std::mt19937& random, int most, int levels, double forbidden_share) {
  std::uniform_int_distribution<int> size(0, most), level(0, levels - 1);
  std::bernoulli_distribution is_forbidden(forbidden_share);
  Case problem{static_cast<std::size_t>(size(random)), static_cast<std::size_t>(size(random)), {}, {}};
  problem.values.resize(problem.rows * problem.columns);
  for (double& value : problem.values) {
    value = level(random);
    if (is_forbidden(random)) value = forbidden;
  }
  problem.order = in_sequence(problem.columns);
  std::shuffle(problem.order.begin(), problem.order.end(), random);
  return problem;
}

// Pairs and sum of utilities of an assignment that is allowed.
std::pair<int, double> worth(const Case& problem, const Rows& column_of) {
  std::pair<int, double> out{0, 0.0};
  std::vector<bool> taken(problem.columns, false);
  for (std::size_t i = 0; i < problem.rows; ++i) {
    if (column_of[i] == -1) continue;
    const auto j = static_cast<std::size_t>(column_of[i]);
    EXPECT_TRUE(j < problem.columns && !taken[j] && problem(i, j) != forbidden);
    if (j >= problem.columns) break;
    taken[j] = true;
    ++out.first;
    out.second += problem(i, j);
  }
  return out;
}

TEST(Hungarian, EqualsExhaustiveSearchWithManyTies) {
  std::mt19937 random(4);
  hungarian::Solver solver;  // one for all: nothing may be left over from the case before
  for (int round = 0; round < 100000; ++round) {
    const int levels = 1 + round % 5;
    const double share = 0.25 * ((round / 5) % 4);
    const Case problem = random_case(random, 7, levels, share);
    const Rows truth = Truth{problem, {}}.least();
    ASSERT_EQ(assign(problem, solver), truth) << "round " << round;
    Rows any(problem.rows, -7);
    solver.assign_any({problem.values.data(), problem.rows, problem.columns, problem.columns}, any);
    ASSERT_EQ(worth(problem, any), worth(problem, truth)) << "round " << round;
  }
}

// Fractions whose sums round: what is equal in exact arithmetic must be treated as equal.
TEST(Hungarian, TiesSurviveRounding) {
  std::mt19937 random(5);
  hungarian::Solver solver;
  for (int round = 0; round < 5000; ++round) {
    const Case whole = random_case(random, 7, 4, 0.2 * (round % 3));
    Case tenths = whole;
    for (double& value : tenths.values) value = 0.1 * value + (value == forbidden ? 0.0 : 0.7);
    // The same number for every entry changes the sum of every assignment of the same cardinality alike.
    ASSERT_EQ(assign(tenths, solver), (Truth{whole, {}}.least())) << "round " << round;
  }
}

TEST(Hungarian, LexicographicallyLeastAmongEqual) {
  EXPECT_EQ(assign({3, 3, std::vector<double>(9, 1.0), {0, 1, 2}}), (Rows{0, 1, 2}));
  EXPECT_EQ(assign({3, 3, std::vector<double>(9, 1.0), {2, 0, 1}}), (Rows{2, 0, 1}));
  EXPECT_EQ(assign({2, 4, std::vector<double>(8, 1.0), {3, 1, 0, 2}}), (Rows{3, 1}));
  EXPECT_EQ(assign({4, 2, std::vector<double>(8, 1.0), {1, 0}}), (Rows{1, 0, -1, -1}));
}

TEST(Hungarian, CardinalityComesBeforeTheSum) {
  // One pair of 100 or two of 1: two.
  EXPECT_EQ(assign({2, 2, {100.0, 1.0, 1.0, forbidden}, {0, 1}}), (Rows{1, 0}));
  // Both robots can only take column 0: the better one does.
  EXPECT_EQ(assign({2, 2, {1.0, forbidden, 5.0, forbidden}, {0, 1}}), (Rows{-1, 0}));
  EXPECT_EQ(assign({2, 3, std::vector<double>(6, forbidden), {0, 1, 2}}), (Rows{-1, -1}));
}

TEST(Hungarian, EmptyMatrices) {
  EXPECT_EQ(assign({0, 0, {}, {}}), (Rows{}));
  EXPECT_EQ(assign({0, 3, {}, {0, 1, 2}}), (Rows{}));
  EXPECT_EQ(assign({3, 0, {}, {}}), (Rows{-1, -1, -1}));
}

TEST(Hungarian, ReadsByStride) {
  const std::vector<double> padded{1.0, 2.0, 99.0, 2.0, 1.0, 99.0};
  hungarian::Solver solver;
  Rows out(2);
  const Order order{0, 1};
  solver.assign({padded.data(), 2, 2, 3}, order, out);
  EXPECT_EQ(out, (Rows{1, 0}));
}

// Beyond one machine word: identical robots and identical tasks must come out in sequence, and a permutation hidden in
// a matrix must be found, with and without forbidden rows.
TEST(Hungarian, LargeMatrices) {
  hungarian::Solver solver;
  for (const std::size_t n : {65u, 130u, 200u}) {
    Case same{n, n + 3, std::vector<double>(n * (n + 3), 0.3), in_sequence(n + 3)};
    Rows expected(n);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(assign(same, solver), expected) << n;

    std::mt19937 random(static_cast<unsigned>(n));
    std::vector<std::int32_t> hidden(n);
    std::iota(hidden.begin(), hidden.end(), 0);
    std::shuffle(hidden.begin(), hidden.end(), random);
    Case permutation{n, n, std::vector<double>(n * n, 1.0), in_sequence(n)};
    for (std::size_t i = 0; i < n; ++i) permutation.values[i * n + static_cast<std::size_t>(hidden[i])] = 2.0;
    EXPECT_EQ(assign(permutation, solver), hidden) << n;

    for (std::size_t j = 0; j < n; ++j) permutation.values[(n - 1) * n + j] = forbidden;
    hidden[n - 1] = -1;
    EXPECT_EQ(assign(permutation, solver), hidden) << n;
  }
}

// The Ranked costs of forbidden pairs and the plain ones must not mix up magnitudes.
TEST(Hungarian, MagnitudesDoNotMatter) {
  std::mt19937 random(15);
  hungarian::Solver solver;
  for (int round = 0; round < 5000; ++round) {
    const Case small = random_case(random, 7, 6, 0.25 * (round % 4));
    for (const double scale : {1e-9, 1e9}) {
      Case other = small;
      for (double& value : other.values) value *= scale;
      ASSERT_EQ(assign(other, solver), assign(small, solver)) << "round " << round << ", times " << scale;
    }
  }
}

// Entries that stand for "never" or "by all means" must not swallow what the others differ by. Whole numbers: sums are
// exact. A forced outlier stands in every assignment, another in none of the best.
TEST(Hungarian, OutliersHideNothing) {
  std::mt19937 random(18);
  hungarian::Solver solver;
  for (const double outlier : {-1e9, 1e9, -1e11, 1e11}) {
    int wrong = 0;
    for (int round = 0; round < 10000; ++round) {
      Case problem = random_case(random, 6, 6, 0.2 * (round % 3));
      if (problem.values.empty()) continue;
      std::bernoulli_distribution one(1.0 / static_cast<double>(problem.values.size())), some(0.3);
      for (double& value : problem.values) {
        const bool chosen = round % 2 == 0 ? one(random) : some(random);
        if (value != forbidden && chosen) value = outlier + (round % 4 < 2 ? 0.0 : value);
      }
      wrong += assign(problem, solver) == Truth{problem, {}}.least() ? 0 : 1;
    }
    EXPECT_EQ(wrong, 0) << "of 10000 with " << outlier;
  }
  EXPECT_EQ(assign({2, 2, {0.0, 0.7, 0.7, -1e9}, {0, 1}}), (Rows{1, 0}));
  EXPECT_EQ(assign({3, 3, {0.0, 0.7, -5.0, 0.7, 0.0, -5.0, -5.0, -5.0, -1e9}, {0, 1, 2}}), (Rows{2, 0, 1}));
}

// Tenths that round, beside an outlier: equal sums stay equal.
TEST(Hungarian, TiesSurviveRoundingBesideAnOutlier) {
  std::mt19937 random(19);
  hungarian::Solver solver;
  for (int round = 0; round < 5000; ++round) {
    Case whole = random_case(random, 7, 4, 0.2 * (round % 3));
    if (whole.values.empty()) continue;
    const std::size_t place = random() % whole.values.size();
    if (whole.values[place] != forbidden) whole.values[place] = round % 2 == 0 ? -1e9 : 1e9;
    Case tenths = whole;
    for (double& value : tenths.values) value = 0.1 * value + (value == forbidden ? 0.0 : 0.7);
    ASSERT_EQ(assign(tenths, solver), (Truth{whole, {}}.least())) << "round " << round;
  }
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

TEST(HungarianPlugin, AmongEqualsPriorityCountsNotTheOrderOfColumns) {
  Instance assigner(Loaded(REGISTA_PLUGIN_FILE, "hungarian"), EnvironmentBuilder{}.own(2));
  const Scene scene =
      FrameBuilder{}.own(2).robot(2).robot(3).task("supporter").priority(5).task("striker").priority(1).build();
  EXPECT_EQ(assigner.assign(scene, Matrix(2, 2)), (Rows{1, 0}));
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "hungarian");

}  // namespace
