// SPDX-License-Identifier: MIT
#include "study/tuning/slices.hpp"

#include <algorithm>
#include <cmath>

#include "statistics/analysis_of_variance.hpp"

namespace regista::study {

std::vector<double> slice_values(const TuningPlan& plan, const ParameterValues& tuned, std::size_t parameter) {
  const Parameter& of = plan.parameters[parameter];
  std::vector<double> out;
  for (std::uint64_t i = 0; i < plan.slice_points(); ++i) {
    const double share =
        plan.slice_points() == 1 ? 0.5 : static_cast<double>(i) / static_cast<double>(plan.slice_points() - 1);
    const double value = value_at_share(of, share);
    if (value != tuned[parameter] && std::ranges::find(out, value) == out.end()) out.push_back(value);
  }
  return out;
}

Slice slice_of(std::size_t parameter, double tuned_value, std::span<const double> values,
               std::span<const std::vector<double>> scores, const std::vector<double>& tuned, double confidence) {
  Slice out;
  out.parameter = parameter;
  std::vector<std::vector<double>> all{tuned};
  for (std::size_t i = 0; i < values.size(); ++i) {
    out.points.push_back({values[i], mean_of(scores[i], confidence), difference_of(scores[i], tuned, confidence)});
    all.push_back(scores[i]);
  }
  out.points.push_back({tuned_value, mean_of(tuned, confidence), {}});
  std::ranges::sort(out.points, {}, &SlicePoint::value);
  if (const auto found = statistics::two_way_analysis(all)) {
    out.importance = std::sqrt(found->variance_of_rows);
    out.p = found->p;
  }
  return out;
}

}  // namespace regista::study
