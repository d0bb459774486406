// SPDX-License-Identifier: MIT
// The parts of a tuning's plan as JSON that the plan of another study may hold.
#pragma once

#include "config/json.hpp"
#include "study/tuning/algorithm.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

// All that a tuning's plan says; not yet which study it is of.
nlohmann::ordered_json json_of(const TuningPlan& plan);

// Throws std::out_of_range, std::invalid_argument and the library's exceptions for what the above did not make. Does
// not ask whether its budget is enough for its algorithm: can_search() does.
TuningPlan tuning_plan_of(const nlohmann::ordered_json& json);
Algorithm algorithm_of(const nlohmann::ordered_json& json);

// Its budget is enough for this algorithm's first round, the base team's evaluation aside.
bool can_search(const TuningPlan& plan, Algorithm algorithm);

}  // namespace regista::study
