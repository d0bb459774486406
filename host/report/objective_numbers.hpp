// SPDX-License-Identifier: MIT
// Values of an objective, and differences of them, as the user's objective has them. Within a study of numbers a larger
// score is better: of a minimised objective the sign is turned back.
#pragma once

#include <string>

#include "statistics/interval.hpp"
#include "study/paired_estimates.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::report {

// From scores, or differences of scores.
double of_objective(const study::TuningObjective& objective, double score);
statistics::Estimate of_objective(const study::TuningObjective& objective, const statistics::Estimate& score);
study::MeanEstimate of_objective(const study::TuningObjective& objective, study::MeanEstimate score);

// "per match", "min per 60 min"; empty for a weighted sum, whose terms have units of their own.
std::string unit_of(const study::TuningObjective& objective);

}  // namespace regista::report
