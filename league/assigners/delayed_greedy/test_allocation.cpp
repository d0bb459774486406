// SPDX-License-Identifier: MIT
// The pairing allocates nothing.
#include <plugins/assigners/test_allocation.hpp>

#include "algorithm.hpp"

namespace {

struct Beside {
  void reserve(std::size_t robots, std::size_t tasks) { scratch.resize(robots * tasks); }
  std::vector<double> scratch;
};

TEST(DelayedGreedy, NothingIsAllocatedWithinWhatWasReserved) {
  assignment::expect_nothing_allocated<Beside>(
      assignment::forbidden, [](Beside& beside, const assignment::Matrix& utilities, auto order, auto out) {
        std::ranges::fill(out, -1);
        if (utilities.rows == 0 || utilities.columns == 0) return;
        const std::size_t row = utilities.rows - 1, column = utilities.columns / 2;
        if (utilities(row, column) == assignment::forbidden) return;
        delayed_greedy::assign_beside(utilities, order, row, column, beside.scratch, out);
      });
}

}  // namespace
