// SPDX-License-Identifier: MIT
// Fields of the tables of every study that searches the values of a team. Numbers stand as short as they read back
// exactly; what is not known is an empty field.
#pragma once

#include <string>

#include "study/paired_estimates.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::report {

// A column for each parameter: the head, and the fields of a line. A comma after each.
std::string parameter_columns(const study::TuningPlan& plan);
std::string value_fields(const study::TuningPlan& plan, const study::ParameterValues& values);

// Of the mean; empty of fewer than two pairs.
std::string standard_error_field(const study::MeanEstimate& estimate);

}  // namespace regista::report
