// SPDX-License-Identifier: MIT
// Both methods against trying every assignment, against the Hungarian method on weights that express the criterion
// (the O(n^5) algorithm of the paper), and the properties that the paper proves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "../hungarian/algorithm.hpp"
#include "algorithm.hpp"

namespace {

using scram::Criterion, scram::infinity, scram::Method;
using Rows = std::vector<std::int32_t>;
using Order = std::vector<std::uint32_t>;

constexpr Criterion criteria[] = {Criterion::mmdr, Criterion::mmd_msd2};

struct Case {
  std::size_t rows, columns;
  std::vector<double> costs;
  Order order, choice;
  double operator()(std::size_t i, std::size_t j) const { return costs[i * columns + j]; }
};

Rows assign(const Case& problem, Criterion criterion, scram::Solver& solver, Method method = Method::automatic) {
  Rows out(problem.rows, -7);
  solver.assign({problem.costs.data(), problem.rows, problem.columns, problem.columns}, criterion, problem.order,
                problem.choice, out, method);
  return out;
}

Rows assign(const Case& problem, Criterion criterion) {
  scram::Solver solver;
  return assign(problem, criterion, solver);
}

Order in_sequence(std::size_t columns) {
  Order order(columns);
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

// Every partial assignment, compared by definition; for small whole numbers as costs, so that sums are exact.
class Exhaustive {
 public:
  Exhaustive(const Case& problem, Criterion criterion) : problem_(problem), criterion_(criterion) {}
  Rows best() {
    robot_of_.assign(problem_.columns, -1);
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
      std::vector<double> key = key_of_present();
      if (best_.empty() || key < best_) {
        best_ = std::move(key);
        best_robot_of_ = robot_of_;
      }
      return;
    }
    descend(column + 1, used);
    for (std::size_t i = 0; i < problem_.rows; ++i) {
      if ((used >> i & 1u) != 0 || problem_(i, column) == infinity) continue;
      robot_of_[column] = static_cast<int>(i);
      descend(column + 1, used | 1u << i);
      robot_of_[column] = -1;
    }
  }
  // Less is better: tasks left open by choice; the criterion; robots by order.
  std::vector<double> key_of_present() const {
    std::vector<double> key{0.0}, costs;
    for (const std::uint32_t j : problem_.choice) key.push_back(robot_of_[j] < 0 ? 1.0 : 0.0);
    for (std::size_t j = 0; j < problem_.columns; ++j) {
      if (robot_of_[j] >= 0) costs.push_back(problem_(static_cast<std::size_t>(robot_of_[j]), j));
    }
    std::sort(costs.rbegin(), costs.rend());
    if (criterion_ == Criterion::mmdr) {
      key.insert(key.end(), costs.begin(), costs.end());
    } else if (!costs.empty()) {
      key.push_back(costs[0]);
      key.push_back(std::accumulate(costs.begin(), costs.end(), 0.0));
    }
    for (const std::uint32_t j : problem_.order) {
      key.push_back(robot_of_[j] < 0 ? static_cast<double>(problem_.rows) : robot_of_[j]);
    }
    return key;
  }

  const Case& problem_;
  Criterion criterion_;
  std::vector<int> robot_of_, best_robot_of_;
  std::vector<double> best_;
};

Case random_case(std::mt19937& random, int most_rows, int most_columns, int levels, double forbidden_share) {
  std::uniform_int_distribution<int> rows(0, most_rows), columns(0, most_columns), level(0, levels - 1);
  std::bernoulli_distribution is_forbidden(forbidden_share);
  const auto r = static_cast<std::size_t>(rows(random));
  const auto c = static_cast<std::size_t>(columns(random));
  Case problem{r, c, std::vector<double>(r * c), in_sequence(c), in_sequence(c)};
  for (double& cost : problem.costs) {
    cost = level(random);
    if (is_forbidden(random)) cost = infinity;
  }
  std::shuffle(problem.order.begin(), problem.order.end(), random);
  std::shuffle(problem.choice.begin(), problem.choice.end(), random);
  return problem;
}

TEST(Scram, EqualsExhaustiveSearchWithManyTies) {
  std::mt19937 random(6);
  scram::Solver solver;  // one for all: nothing may be left over from the case before
  for (int round = 0; round < 100000; ++round) {
    const Case problem = random_case(random, 5, 5, 1 + round % 7, 0.25 * ((round / 7) % 4));
    for (const Criterion criterion : criteria) {
      const Rows truth = Exhaustive(problem, criterion).best();
      ASSERT_EQ(assign(problem, criterion, solver, Method::enumeration), truth) << "round " << round;
      ASSERT_EQ(assign(problem, criterion, solver, Method::polynomial), truth) << "round " << round;
    }
  }
}

TEST(Scram, EqualsExhaustiveSearchForSevenRobots) {
  std::mt19937 random(7);
  scram::Solver solver;
  for (int round = 0; round < 1000; ++round) {
    const Case problem = random_case(random, 7, 7, 2 + round % 10, 0.2 * (round % 3));
    for (const Criterion criterion : criteria) {
      const Rows truth = Exhaustive(problem, criterion).best();
      ASSERT_EQ(assign(problem, criterion, solver, Method::enumeration), truth) << "round " << round;
      ASSERT_EQ(assign(problem, criterion, solver, Method::polynomial), truth) << "round " << round;
    }
  }
}

TEST(Scram, EnumerationAndPolynomialMethodAgreeOnRealNumbers) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> real(0.0, 80.0);
  scram::Solver solver;
  for (int round = 0; round < 20000; ++round) {
    Case problem = random_case(random, 7, 12, 2, 0.1 * (round % 4));
    for (double& cost : problem.costs) cost = cost == infinity ? infinity : real(random);
    for (const Criterion criterion : criteria) {
      ASSERT_EQ(assign(problem, criterion, solver, Method::enumeration),
                assign(problem, criterion, solver, Method::polynomial))
          << "round " << round;
    }
  }
}

// --- Larger teams, by the Hungarian method -------------------------------------------------------------------------

// All columns, or nothing when that cannot be.
Rows least_sum(const Case& problem, const std::vector<double>& weights) {
  std::vector<double> utilities(weights.size());
  std::transform(weights.begin(), weights.end(), utilities.begin(), [](double weight) { return -weight; });
  Rows out(problem.rows);
  hungarian::Solver().assign({utilities.data(), problem.rows, problem.columns, problem.columns}, problem.order, out);
  const auto pairs = out.size() - static_cast<std::size_t>(std::count(out.begin(), out.end(), -1));
  return pairs == problem.columns ? out : Rows{};
}

// More robots than most_robots of the enumeration, up to 22; no more tasks than robots.
Case large_case(std::mt19937& random, int levels, double forbidden_share) {
  const std::size_t rows = 8 + random() % 15, columns = 1 + random() % rows;
  std::uniform_int_distribution<int> level(0, levels - 1);
  std::bernoulli_distribution is_forbidden(forbidden_share);
  Case problem{rows, columns, std::vector<double>(rows * columns), in_sequence(columns), in_sequence(columns)};
  for (double& cost : problem.costs) cost = is_forbidden(random) ? infinity : level(random);
  std::shuffle(problem.order.begin(), problem.order.end(), random);
  return problem;
}

// One pair of a level weighs more than all pairs of lower levels, so that the least sum is MMDR.
TEST(Scram, MmdrIsTheLeastSumOfPowers) {
  std::mt19937 random(9);
  scram::Solver solver;
  int compared = 0;
  for (int round = 0; round < 2000; ++round) {
    const Case problem = large_case(random, 1 + round % 7, 0.3 * (round % 3));
    std::vector<double> weights(problem.costs);
    const double base = static_cast<double>(problem.columns) + 1.0;
    for (double& weight : weights) weight = weight == infinity ? infinity : std::pow(base, weight);
    const Rows truth = least_sum(problem, weights);
    if (truth.empty()) continue;
    ASSERT_EQ(assign(problem, Criterion::mmdr, solver), truth) << "round " << round;
    ++compared;
  }
  EXPECT_GT(compared, 1500);
}

TEST(Scram, MmdMsd2IsTheLeastSumBelowTheBottleneck) {
  std::mt19937 random(10);
  scram::Solver solver;
  int compared = 0;
  for (int round = 0; round < 2000; ++round) {
    const int levels = 1 + round % 40;
    const Case problem = large_case(random, levels, 0.3 * (round % 3));
    Rows truth;
    for (int bottleneck = 0; bottleneck < levels && truth.empty(); ++bottleneck) {
      std::vector<double> below(problem.costs);
      for (double& cost : below) cost = cost > bottleneck ? infinity : cost;
      truth = least_sum(problem, below);
    }
    if (truth.empty()) continue;
    ASSERT_EQ(assign(problem, Criterion::mmd_msd2, solver), truth) << "round " << round;
    ++compared;
  }
  EXPECT_GT(compared, 1500);
}

// --- What the paper says -------------------------------------------------------------------------------------------

struct Points {
  std::vector<double> x, y;
  Points(std::mt19937& random, std::size_t n) : x(n), y(n) {
    std::uniform_real_distribution<double> along(-4.5, 4.5), across(-3.0, 3.0);
    for (std::size_t i = 0; i < n; ++i) {
      x[i] = along(random);
      y[i] = across(random);
    }
  }
};

Case squared_distances(const Points& robots, const Points& tasks) {
  const std::size_t n = robots.x.size(), m = tasks.x.size();
  Case problem{n, m, std::vector<double>(n * m), in_sequence(m), in_sequence(m)};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      problem.costs[i * m + j] = std::pow(robots.x[i] - tasks.x[j], 2) + std::pow(robots.y[i] - tasks.y[j], 2);
    }
  }
  return problem;
}

// Robots that walk straight and equally fast to what MMDR gives them are given the same again on the way.
TEST(Scram, MmdrIsDynamicallyConsistent) {
  std::mt19937 random(11);
  scram::Solver solver;
  for (int round = 0; round < 300; ++round) {
    const std::size_t n = round % 2 == 0 ? 7 : 11;
    Points robots(random, n);
    const Points tasks(random, n);
    const Rows first = assign(squared_distances(robots, tasks), Criterion::mmdr, solver);
    for (int step = 0; step < 40; ++step) {
      for (std::size_t i = 0; i < n; ++i) {
        const auto j = static_cast<std::size_t>(first[i]);
        const double dx = tasks.x[j] - robots.x[i], dy = tasks.y[j] - robots.y[i], left = std::hypot(dx, dy);
        const double share = left <= 0.1 ? 1.0 : 0.1 / left;
        robots.x[i] += share * dx;
        robots.y[i] += share * dy;
      }
      ASSERT_EQ(assign(squared_distances(robots, tasks), Criterion::mmdr, solver), first)
          << "round " << round << ", step " << step;
    }
  }
}

// In a line with equal gaps one robot could pass all the others at the same sum of distances: here all move.
TEST(Scram, EverybodyMovesUpInALine) {
  // Robots at 0, 1, 2, 3; tasks at 1, 2, 3, 4. Squares are those of distances.
  Case line{4, 4, {}, in_sequence(4), in_sequence(4)};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) line.costs.push_back((j + 1 - i) * (j + 1 - i));
  }
  EXPECT_EQ(assign(line, Criterion::mmdr), (Rows{0, 1, 2, 3}));
  EXPECT_EQ(assign(line, Criterion::mmd_msd2), (Rows{0, 1, 2, 3}));
}

TEST(Scram, TheCriteriaDiffer) {
  // Longest 6 both; then MMDR prefers 5, 5 to 5.5, 1 and the sum the other way round.
  const Case problem{3, 3, {6, infinity, infinity, infinity, 5, 5.5, infinity, 1, 5}, in_sequence(3), in_sequence(3)};
  EXPECT_EQ(assign(problem, Criterion::mmdr), (Rows{0, 1, 2}));
  EXPECT_EQ(assign(problem, Criterion::mmd_msd2), (Rows{0, 2, 1}));
}

TEST(Scram, TiesSurviveRounding) {
  std::mt19937 random(12);
  scram::Solver solver;
  for (int round = 0; round < 3000; ++round) {
    const Case whole = random_case(random, 9, 9, 5, 0.2 * (round % 3));
    Case noisy = whole;
    std::uniform_real_distribution<double> noise(-1e-12, 1e-12);
    for (double& cost : noisy.costs) cost = (cost + 1.0) * (1.0 + noise(random));
    Case shifted = whole;
    for (double& cost : shifted.costs) cost += 1.0;
    for (const Criterion criterion : criteria) {
      ASSERT_EQ(assign(noisy, criterion, solver), assign(shifted, criterion, solver)) << "round " << round;
    }
  }
}

TEST(Scram, WithMoreTasksThanRobotsTheLessImportantStayOpen) {
  const Case problem{2, 3, {9, 9, 0, 9, 9, 0}, {0, 1, 2}, {1, 0, 2}};
  EXPECT_EQ(assign(problem, Criterion::mmdr), (Rows{0, 1}));
  const Case other_choice{2, 3, {9, 9, 0, 9, 9, 0}, {0, 1, 2}, {1, 2, 0}};
  EXPECT_EQ(assign(other_choice, Criterion::mmdr), (Rows{1, 2}));
}

TEST(Scram, EmptyAndForbidden) {
  for (const Criterion criterion : criteria) {
    EXPECT_EQ(assign({0, 0, {}, {}, {}}, criterion), (Rows{}));
    EXPECT_EQ(assign({0, 3, {}, {0, 1, 2}, {0, 1, 2}}, criterion), (Rows{}));
    EXPECT_EQ(assign({3, 0, {}, {}, {}}, criterion), (Rows{-1, -1, -1}));
    EXPECT_EQ(assign({2, 2, std::vector<double>(4, infinity), {0, 1}, {0, 1}}, criterion), (Rows{-1, -1}));
    EXPECT_EQ(assign({2, 2, {1, infinity, 0, infinity}, {0, 1}, {1, 0}}, criterion), (Rows{-1, 0}));
  }
}

}  // namespace
