// SPDX-License-Identifier: MIT
// The solver allocates nothing, whichever the criterion.
#include "../test_allocation.hpp"
#include "algorithm.hpp"

TEST(Scram, NothingIsAllocatedWithinWhatWasReserved) {
  assignment::expect_nothing_allocated<scram::Solver>(
      scram::infinity, [](scram::Solver& solver, const assignment::Matrix& costs, auto order, auto out) {
        for (const scram::Criterion criterion : {scram::Criterion::mmdr, scram::Criterion::mmd_msd2}) {
          solver.assign(costs, criterion, order, order, out);
        }
      });
}
