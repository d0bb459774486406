// SPDX-License-Identifier: MIT
// The first seed of matches that judge what was chosen: drawn from all that was chosen before, so that another choice
// is never judged on seeds that an earlier one was seen to do well on.
#pragma once

#include <cstdint>
#include <vector>

#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

// Below 2^31; a function of seed, objective, opponents and the chosen values.
std::uint64_t drawn_seed(const TuningPlan& plan, const TunedDocument& document,
                         const std::vector<ParameterValues>& chosen);

}  // namespace regista::study
