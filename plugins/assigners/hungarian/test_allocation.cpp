// SPDX-License-Identifier: MIT
// The solver with and without the rule for ties allocates nothing.
#include "../test_allocation.hpp"
#include "algorithm.hpp"

TEST(Hungarian, NothingIsAllocatedWithinWhatWasReserved) {
  assignment::expect_nothing_allocated<hungarian::Solver>(
      assignment::forbidden, [](hungarian::Solver& solver, const assignment::Matrix& utilities, auto order, auto out) {
        solver.assign(utilities, order, out);
        solver.assign_any(utilities, out);
      });
}
