// SPDX-License-Identifier: MIT
// What tests of an assigner's solver share: after reserve() nothing is allocated, whatever the size within it and
// whichever pairs are forbidden. Include it in one file of a program only, as count_allocations.hpp asks.
#pragma once

#include <gtest/gtest.h>
#include <regista/testkit/count_allocations.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>
#include <vector>

#include "matrix.hpp"

namespace assignment {

inline std::vector<double> kept;  // outside of functions, so that no compiler leaves an allocation out

// no_pair: what stands for a pair that must not be. work(solver, matrix, order, out) has the solver assign.
template <class Solver, class Work>
void expect_nothing_allocated(double no_pair, const Work& work) {
  constexpr std::size_t most_robots = 22, most_tasks = 27;
  std::mt19937 random(16);
  Solver solver;
  solver.reserve(most_robots, most_tasks);
  for (int round = 0; round < 2000; ++round) {
    const std::size_t rows = random() % (most_robots + 1), columns = random() % (most_tasks + 1);
    std::vector<double> values(rows * columns);
    for (double& value : values) {
      value = random() % 10 < static_cast<unsigned>(round % 10) ? no_pair : static_cast<double>(random() % 50);
    }
    std::vector<std::uint32_t> order(columns);
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<std::int32_t> out(rows);
    const Matrix matrix{values.data(), rows, columns, columns};
    const auto count = regista::testkit::allocations_during(
        [&] { work(solver, matrix, std::span<const std::uint32_t>(order), std::span<std::int32_t>(out)); });
    ASSERT_EQ(count, 0u) << rows << " x " << columns;
  }
  EXPECT_GT(regista::testkit::allocations_during([] { kept = std::vector<double>(1000); }), 0u);  // it does count
}

}  // namespace assignment
