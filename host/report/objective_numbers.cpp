// SPDX-License-Identifier: MIT
#include "report/objective_numbers.hpp"

#include <algorithm>

#include "study/measure.hpp"

namespace regista::report {
namespace {

// No minus before nought.
double without_sign_of_nought(double value) { return value == 0.0 ? 0.0 : value; }

statistics::Interval of_objective(const study::TuningObjective& objective, const statistics::Interval& scores) {
  const double a = report::of_objective(objective, scores.low), b = report::of_objective(objective, scores.high);
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

double of_objective(const study::TuningObjective& objective, double score) {
  return without_sign_of_nought(study::value_of(objective, score));
}

statistics::Estimate of_objective(const study::TuningObjective& objective, const statistics::Estimate& score) {
  return {of_objective(objective, score.value), of_objective(objective, score.interval)};
}

study::MeanEstimate of_objective(const study::TuningObjective& objective, study::MeanEstimate score) {
  score.mean = of_objective(objective, score.mean);
  if (score.interval) score.interval = of_objective(objective, *score.interval);
  return score;
}

std::string unit_of(const study::TuningObjective& objective) {
  const bool one = objective.terms.size() == 1 && objective.terms.front().weight == 1.0;
  return one ? study::unit_of(objective.terms.front().measure) : std::string();
}

}  // namespace regista::report
