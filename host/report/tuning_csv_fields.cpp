// SPDX-License-Identifier: MIT
#include "report/tuning_csv_fields.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/csv_text.hpp"

namespace regista::report {

std::string parameter_columns(const study::TuningPlan& plan) {
  std::string out;
  for (const study::Parameter& each : plan.parameters) out += csv_field(each.path) + ',';
  return out;
}

std::string value_fields(const study::TuningPlan& plan, const study::ParameterValues& values) {
  std::string out;
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) out += text_of(plan.parameters[i], values[i]) + ',';
  return out;
}

std::string standard_error_field(const study::MeanEstimate& estimate) {
  if (estimate.pairs < 2) return {};
  return fmt::format("{}", estimate.standard_deviation / std::sqrt(static_cast<double>(estimate.pairs)));
}

}  // namespace regista::report
