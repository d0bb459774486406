// SPDX-License-Identifier: MIT
// The permutation with the largest sum, against trying every one.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "best_permutation.hpp"

namespace {

using role_exchange::BestPermutation, role_exchange::forbidden;
using Rows = std::vector<std::int32_t>;
using Order = std::vector<std::uint32_t>;

struct Case {
  std::size_t rows, columns;
  std::vector<double> values;
  Order choice, order;
  double operator()(std::size_t i, std::size_t j) const { return values[i * columns + j]; }
};

Rows find(const Case& problem, BestPermutation& solver) {
  Rows out(problem.rows, -7);
  solver.find({problem.values.data(), problem.rows, problem.columns, problem.columns}, problem.choice, problem.order,
              out);
  return out;
}

// By definition: every square matrix's permutations in turn.
Rows every_permutation(const Case& problem) {
  std::vector<std::int32_t> robot_of(problem.rows), best_robot_of;  // by column
  std::iota(robot_of.begin(), robot_of.end(), 0);
  double most = 0.0;
  const auto lower = [&](const Rows& a, const Rows& b) {
    for (const std::uint32_t column : problem.order) {
      if (a[column] != b[column]) return a[column] < b[column];
    }
    return false;
  };
  do {
    double sum = 0.0;
    for (std::size_t column = 0; column < problem.columns; ++column) {
      sum += problem(static_cast<std::size_t>(robot_of[column]), column);
    }
    if (best_robot_of.empty() || sum > most || (sum == most && lower(robot_of, best_robot_of))) {
      most = sum;
      best_robot_of = robot_of;
    }
  } while (std::next_permutation(robot_of.begin(), robot_of.end()));
  Rows out(problem.rows);
  for (std::size_t column = 0; column < problem.columns; ++column) {
    out[static_cast<std::size_t>(best_robot_of[column])] = static_cast<std::int32_t>(column);
  }
  return out;
}

// Every partial assignment: less open tasks in the order of choice, then the sum, then the lowest robots.
class Exhaustive {
 public:
  explicit Exhaustive(const Case& problem) : problem_(problem), robot_of_(problem.columns, -1) {}
  Rows best() {
    descend(0, 0);
    Rows out(problem_.rows, -1);
    for (std::size_t j = 0; j < problem_.columns; ++j) {
      if (best_robot_of_[j] >= 0) out[static_cast<std::size_t>(best_robot_of_[j])] = static_cast<std::int32_t>(j);
    }
    return out;
  }

 private:
  void descend(std::size_t column, unsigned used) {
    if (column == problem_.columns) {
      std::vector<double> key;
      for (const std::uint32_t j : problem_.choice) key.push_back(robot_of_[j] < 0 ? 1.0 : 0.0);
      double sum = 0.0;
      for (std::size_t j = 0; j < problem_.columns; ++j) {
        if (robot_of_[j] >= 0) sum += problem_(static_cast<std::size_t>(robot_of_[j]), j);
      }
      key.push_back(-sum);
      for (const std::uint32_t j : problem_.order) key.push_back(robot_of_[j] < 0 ? 99.0 : robot_of_[j]);
      if (best_.empty() || key < best_) {
        best_ = key;
        best_robot_of_ = robot_of_;
      }
      return;
    }
    descend(column + 1, used);
    for (std::size_t i = 0; i < problem_.rows; ++i) {
      if ((used >> i & 1u) != 0 || problem_(i, column) == forbidden) continue;
      robot_of_[column] = static_cast<std::int32_t>(i);
      descend(column + 1, used | 1u << i);
      robot_of_[column] = -1;
    }
  }
  const Case& problem_;
  Rows robot_of_, best_robot_of_;
  std::vector<double> best_;
};

Case random_case(std::mt19937& random, std::size_t rows, std::size_t columns, int levels, unsigned forbidden_percent) {
  Case problem{rows, columns, std::vector<double>(rows * columns), Order(columns), Order(columns)};
  std::uniform_int_distribution<int> level(0, levels - 1);
  for (double& value : problem.values) value = random() % 100 < forbidden_percent ? forbidden : level(random);
  std::iota(problem.choice.begin(), problem.choice.end(), 0u);
  std::iota(problem.order.begin(), problem.order.end(), 0u);
  std::shuffle(problem.choice.begin(), problem.choice.end(), random);
  std::shuffle(problem.order.begin(), problem.order.end(), random);
  return problem;
}

TEST(BestPermutation, EqualsEveryPermutationOfThreeToSevenRobots) {
  std::mt19937 random(2002);
  BestPermutation solver;  // one for all: nothing may be left over from the case before
  for (int round = 0; round < 10000; ++round) {
    // Seven robots have 5040 permutations: a tenth of the rounds.
    const std::size_t size = round % 10 == 9 ? 7 : 3 + static_cast<std::size_t>(round % 4);
    const Case problem = random_case(random, size, size, round % 2 == 0 ? 256 : 4, 0);
    ASSERT_EQ(find(problem, solver), every_permutation(problem)) << "round " << round;
  }
}

TEST(BestPermutation, EqualsExhaustiveSearchOfAnyShape) {
  std::mt19937 random(2001);
  BestPermutation solver;
  for (int round = 0; round < 10000; ++round) {
    const std::size_t rows = random() % 5, columns = random() % 5;
    const Case problem = random_case(random, rows, columns, 1 + round % 6, static_cast<unsigned>(20 * (round % 4)));
    ASSERT_EQ(find(problem, solver), Exhaustive(problem).best()) << "round " << round;
  }
}

// Elevens are too many to try: no exchange of two or three roles is better.
TEST(BestPermutation, ElevenRobotsCannotBeImprovedBySmallExchanges) {
  std::mt19937 random(11);
  BestPermutation solver;
  for (int round = 0; round < 1000; ++round) {
    const Case problem = random_case(random, 11, 11, 256, 0);
    const Rows found = find(problem, solver);
    const auto value = [&](std::size_t robot, std::size_t role_of) {
      return problem(robot, static_cast<std::size_t>(found[role_of]));
    };
    for (std::size_t a = 0; a < 11; ++a) {
      for (std::size_t b = 0; b < 11; ++b) {
        ASSERT_GE(value(a, a) + value(b, b), value(a, b) + value(b, a));
        for (std::size_t c = 0; c < 11; ++c) {
          if (a == b || b == c || a == c) continue;
          ASSERT_GE(value(a, a) + value(b, b) + value(c, c), value(a, b) + value(b, c) + value(c, a));
        }
      }
    }
  }
}

TEST(BestPermutation, TheLeastImportantTaskStaysOpen) {
  BestPermutation solver;
  const Case problem{2, 3, {9, 9, 1, 9, 9, 1}, {2, 0, 1}, {0, 1, 2}};
  EXPECT_EQ(find(problem, solver), (Rows{0, 2}));
}

}  // namespace
