// SPDX-License-Identifier: MIT
#include "report/objective_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/figure.hpp"
#include "report/objective_numbers.hpp"

namespace regista::report {

void AxisRange::take(double value) {
  if (!std::isfinite(value)) return;
  low_ = std::min(low_, value);
  high_ = std::max(high_, value);
}

void AxisRange::take(const study::MeanEstimate& estimate) {
  if (estimate.pairs == 0) return;
  take(estimate.mean);
  if (!estimate.interval) return;
  take(estimate.interval->low);
  take(estimate.interval->high);
}

std::string AxisRange::axis() const { return fmt::format("[{:.6g}:{:.6g}]", bottom(), high_ + room()); }

// A little more on both sides; of a single value as much as it can be told from others.
double AxisRange::room() const { return high_ > low_ ? 0.06 * (high_ - low_) : std::max(0.5, 0.1 * std::abs(high_)); }

std::string value_label(const study::TuningObjective& objective, int length) {
  constexpr double letter = 8.8;  // wide
  const std::string unit = unit_of(objective);
  if (unit.empty()) return gnuplot_text("objective");
  const std::string words = in_words(objective) + ", " + unit;
  if (letter * static_cast<double>(words.size()) > length) return gnuplot_text(unit);
  return fmt::format("{}.', {}'", gnuplot_text(in_words(objective)), unit);
}

}  // namespace regista::report
