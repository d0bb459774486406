// SPDX-License-Identifier: MIT
#include "report/objective_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "report/experiment.hpp"
#include "report/number.hpp"
#include "study/measure.hpp"

namespace regista::report {
namespace {

// No minus before nought.
double without_sign_of_nought(double value) { return value == 0.0 ? 0.0 : value; }

statistics::Interval told(const study::TuningObjective& objective, const statistics::Interval& scores) {
  const double a = report::told(objective, scores.low), b = report::told(objective, scores.high);
  return {std::min(a, b), std::max(a, b)};
}

double margin_of(const std::optional<statistics::Interval>& interval) {
  return interval && has_width(*interval) ? (interval->high - interval->low) / 2.0 : 0.0;
}

// An end beside nought must not look as if it were nought.
std::string end_text(double end, double margin) {
  const std::string text = rounded(end, margin);
  return end != 0.0 && shows_nothing(end, text) ? rounded(end, std::abs(end)) : text;
}

std::string ends_text(const std::optional<statistics::Interval>& interval) {
  if (!interval || !has_width(*interval)) return {};
  const double margin = margin_of(interval);
  return fmt::format(" [{}, {}]", end_text(interval->low, margin), end_text(interval->high, margin));
}

}  // namespace

double told(const study::TuningObjective& objective, double score) {
  return without_sign_of_nought(study::value_of(objective, score));
}

statistics::Estimate told(const study::TuningObjective& objective, const statistics::Estimate& score) {
  return {told(objective, score.value), told(objective, score.interval)};
}

study::MeanEstimate told(const study::TuningObjective& objective, study::MeanEstimate score) {
  score.mean = told(objective, score.mean);
  if (score.interval) score.interval = told(objective, *score.interval);
  return score;
}

std::string unit_of(const study::TuningObjective& objective) {
  const bool one = objective.terms.size() == 1 && objective.terms.front().weight == 1.0;
  return one ? study::unit_of(objective.terms.front().measure) : std::string();
}

bool has_width(const statistics::Interval& interval) {
  constexpr double rounding = 1e-9;
  return interval.bounded() &&
         interval.high - interval.low > rounding * std::max(std::abs(interval.low), std::abs(interval.high));
}

std::string signed_text(double value, double margin) {
  const std::string text = rounded(value, std::isfinite(margin) ? margin : 0.0);
  return text.starts_with('-') ? text : '+' + text;
}

std::string told_text(const study::MeanEstimate& estimate) {
  if (estimate.pairs == 0) return "-";
  return rounded(estimate.mean, margin_of(estimate.interval)) + ends_text(estimate.interval);
}

std::string told_text(const statistics::Estimate& estimate) {
  return signed_text(estimate.value, margin_of(estimate.interval)) + ends_text(estimate.interval);
}

std::string difference_text(const study::MeanEstimate& difference) {
  if (difference.pairs == 0) return "-";
  return signed_text(difference.mean, margin_of(difference.interval)) + ends_text(difference.interval);
}

}  // namespace regista::report
