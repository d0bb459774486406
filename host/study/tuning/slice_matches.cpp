// SPDX-License-Identifier: MIT
#include "study/tuning/slice_matches.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace regista::study {

std::vector<Slice> slices_around(const MatchSource& source, const ParameterValues& tuned) {
  const TuningPlan& plan = source.plan;
  std::vector<Slice> out;
  if (plan.slice_points() == 0 || plan.slice_pairs() == 0) return out;
  std::vector<ParameterValues> points{tuned};
  std::vector<std::vector<double>> values(plan.parameters.size());
  for (std::size_t parameter = 0; parameter < plan.parameters.size(); ++parameter) {
    if (plan.parameters[parameter].fixed()) continue;
    values[parameter] = slice_values(plan, tuned, parameter);
    for (const double value : values[parameter]) {
      points.push_back(tuned);
      points.back()[parameter] = value;
    }
  }
  PairBatch batch(plan, source.document, points, {TuningStage::slices, plan.seed(), 0, plan.slice_pairs()});
  play_batch(source, batch);
  std::size_t next = 1;
  for (std::size_t parameter = 0; parameter < plan.parameters.size(); ++parameter) {
    if (plan.parameters[parameter].fixed()) continue;
    std::vector<std::vector<double>> scores;
    for (std::size_t i = 0; i < values[parameter].size(); ++i) scores.push_back(batch.scores(next++));
    out.push_back(slice_of(parameter, tuned[parameter], values[parameter], scores, batch.scores(0), plan.confidence()));
  }
  std::ranges::stable_sort(out, std::greater(), &Slice::importance);
  return out;
}

}  // namespace regista::study
