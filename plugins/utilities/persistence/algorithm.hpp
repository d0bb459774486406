// SPDX-License-Identifier: MIT
// Keeping a role pays: h in [0, 1] grows with the time for which it has been held and is full after a while (10 s in
// the SPQR team's utility of 2022, weight 0.2). SPQR's code counts it for the own row only, so that each robot computes
// another matrix even when all messages arrive; counting it on every row is what makes the matrices alike.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>

namespace persistence_utility {

inline constexpr int no_role = -1;

struct Holder {
  int role = no_role;  // id of the role that the robot of this row holds
  double held = 0.0;   // s; negative counts as 0
};

// out[i * stride + j] = min(1, held / full_after) where robot i holds task j; other entries are not touched.
// full_after > 0, s. A role that is no task now, or no_role, leaves its row as it is.
inline void score(std::span<const Holder> rows, std::span<const int> task_ids, double full_after, double* out,
                  std::size_t stride) {
  assert(full_after > 0.0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].role == no_role) continue;
    const auto column = std::find(task_ids.begin(), task_ids.end(), rows[i].role);
    if (column == task_ids.end()) continue;
    out[i * stride + static_cast<std::size_t>(column - task_ids.begin())] =
        std::clamp(rows[i].held / full_after, 0.0, 1.0);
  }
}

}  // namespace persistence_utility
