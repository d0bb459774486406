// SPDX-License-Identifier: MIT
// Warnings of what a team's plugins make of made-up scenes: contexts that may never be in force
// (mind/coordination/idle_contexts.hpp), terms of the utility that change nothing (idle_terms.hpp), and segments that
// no packet can take (mind/unsendable_segments.hpp). The plugins are called in a copy of this process: one that ends
// it, or does not return, is a warning too.
#pragma once

#include <vector>

#include "config/team_warnings.hpp"
#include "mind/team_plan.hpp"

namespace regista::study {

// This process must have no threads and no other children, see campaign/supervised.hpp. A signal that asks to end ends
// it as it would end any other.
std::vector<config::Warning> scenes_check(const mind::TeamPlan& plan);

}  // namespace regista::study
