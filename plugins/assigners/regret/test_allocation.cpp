// SPDX-License-Identifier: MIT
// The solver allocates nothing.
#include "../test_allocation.hpp"
#include "algorithm.hpp"

TEST(Regret, NothingIsAllocatedWithinWhatWasReserved) {
  assignment::expect_nothing_allocated<regret::Solver>(
      assignment::forbidden, [](regret::Solver& solver, const assignment::Matrix& utilities, auto order, auto out) {
        solver.assign(utilities, order, out);
      });
}
