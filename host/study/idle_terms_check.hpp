// SPDX-License-Identifier: MIT
// Warnings of terms of a team's utility that change nothing (mind/coordination/idle_terms.hpp). The team's plugins are
// called in a copy of this process: one that ends it, or does not return, is a warning too.
#pragma once

#include <vector>

#include "config/team_warnings.hpp"
#include "mind/team_plan.hpp"

namespace regista::study {

// This process must have no threads and no other children, see campaign/supervised.hpp. A signal that asks to end ends
// it as it would end any other.
std::vector<config::Warning> idle_terms_check(const mind::TeamPlan& plan);

}  // namespace regista::study
