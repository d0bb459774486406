// SPDX-License-Identifier: MIT
// After reserve() nothing is allocated, whatever the size within it and whichever pairs are forbidden.
#include <gtest/gtest.h>
#include <regista/testkit/count_allocations.hpp>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "algorithm.hpp"

namespace {

std::vector<double> kept;  // outside of functions, so that no compiler leaves an allocation out

TEST(Hungarian, NothingIsAllocatedWithinWhatWasReserved) {
  constexpr std::size_t most_robots = 22, most_tasks = 27;
  constexpr double forbidden = hungarian::forbidden;
  std::mt19937 random(16);
  hungarian::Solver solver;
  solver.reserve(most_robots, most_tasks);
  for (int round = 0; round < 2000; ++round) {
    const std::size_t rows = random() % (most_robots + 1), columns = random() % (most_tasks + 1);
    std::vector<double> values(rows * columns);
    for (double& value : values)
      value = random() % 10 < static_cast<unsigned>(round % 10) ? forbidden : static_cast<double>(random() % 50);
    std::vector<std::uint32_t> order(columns);
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<std::int32_t> out(rows);
    const auto work = [&] {
      solver.assign({values.data(), rows, columns, columns}, order, out);
      solver.assign_any({values.data(), rows, columns, columns}, out);
    };
    ASSERT_EQ(regista::testkit::allocations_during(work), 0u) << rows << " x " << columns;
  }
  EXPECT_GT(regista::testkit::allocations_during([] { kept = std::vector<double>(1000); }), 0u);  // it does count
}

}  // namespace
