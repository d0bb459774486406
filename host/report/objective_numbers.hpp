// SPDX-License-Identifier: MIT
// Values of an objective, and differences of them, as they are told. Within a study of numbers a larger score is
// better; here everything is told as the user's objective has it: of a minimised one the sign is turned back.
#pragma once

#include <string>

#include "statistics/interval.hpp"
#include "study/paired_estimates.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::report {

// Scores, or differences of scores, as the objective tells them.
double told(const study::TuningObjective& objective, double score);
statistics::Estimate told(const study::TuningObjective& objective, const statistics::Estimate& score);
study::MeanEstimate told(const study::TuningObjective& objective, study::MeanEstimate score);

// "per match", "min per 60 min"; empty for a weighted sum, whose terms have units of their own.
std::string unit_of(const study::TuningObjective& objective);

// It has ends, and more between them than rounding makes of values that are all the same.
bool has_width(const statistics::Interval& interval);

// "0.85 [0.40, 1.30]"; "0.85" without an interval that has a width, "-" without a pair.
std::string told_text(const study::MeanEstimate& estimate);
std::string told_text(const statistics::Estimate& estimate);         // with a sign
std::string difference_text(const study::MeanEstimate& difference);  // with a sign
std::string signed_text(double value, double margin);                // "+0.75"

}  // namespace regista::report
