// SPDX-License-Identifier: MIT
// One decision of one robot as the pipeline leaves it, step by step: what a recorder writes down and a reader wants to
// see. Reused from decision to decision; valid until the next one.
#pragma once

#include <cstdint>
#include <vector>

#include "mind/coordination/utility_estimation_matrix.hpp"
#include "plugin/positioner.hpp"
#include "regista/abi.h"

namespace regista::mind {

struct Decision {
  // As the sender sees it; its knowledge is that of the utilities, its spans point into this struct and the world
  // model.
  regista_frame frame{};
  int context = -1;                    // index into Team::contexts, -1 = none holds
  std::vector<regista_task> tasks;     // M: all of the context
  plugin::Placement placement;         // V; its points name tasks by their place in `columns`
  std::vector<std::size_t> kept;       // indices of those of `tasks` that were kept, ascending
  std::vector<regista_task> columns;   // N: the kept ones, moved towards their waypoints
  std::vector<double> time_to_task;    // s; rows x columns
  UtilityEstimationMatrix utility;     // rows x columns
  std::vector<std::int32_t> assigned;  // Phi: column of each row, or REGISTA_NO_TASK / REGISTA_UNKNOWN_TASK
  std::vector<std::int32_t> role_of;   // per robot (n - 1): row of the table of roles, -1 none, -2 unknown
  int own_role = -1;
  double own_role_since = 0.0;
  const regista_task* own_task = nullptr;  // the column that is the own one, or null

  std::size_t rows() const { return assigned.size(); }
};

}  // namespace regista::mind
