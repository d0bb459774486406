// SPDX-License-Identifier: MIT
#include "study/tuning/selection.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "statistics/moments.hpp"

namespace regista::study {

std::vector<Finalist> select_finalists(const MatchSource& source, const SearchFindings& found) {
  const TuningPlan& plan = source.plan;
  std::vector<ParameterValues> chosen;
  for (const ParameterValues& each : found.recommended) {
    if (chosen.size() < plan.finalists() && std::ranges::find(chosen, each) == chosen.end()) chosen.push_back(each);
  }
  PairBatch batch(plan, source.document, chosen, {TuningStage::selection, plan.seed(), 0, plan.selection_pairs});
  play_batch(source, batch);
  const double worst = worst_of(batch, chosen.size(), found.worst);
  std::vector<Finalist> out;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    out.push_back(
        {chosen[i], seen_in_search(found.scores, chosen[i], plan.confidence()), played_score(plan, batch, i, worst)});
  }
  std::ranges::stable_sort(out, std::greater(), [](const Finalist& each) { return each.selected.counted; });
  return out;
}

std::vector<std::size_t> candidates_among(const TuningPlan& plan, const std::vector<Finalist>& finalists) {
  const ParameterValues base = start_values(plan);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < finalists.size() && i < plan.candidates(); ++i) {
    if (finalists[i].values == base) break;  // those behind it are thought worse than it
    out.push_back(i);
  }
  return out;
}

double deviation_of(const std::vector<Finalist>& finalists, const SearchScores& scores) {
  double variance = 0.0;
  for (const Finalist& each : finalists) {
    const double deviation = each.selected.score.standard_deviation;
    variance += deviation * deviation / static_cast<double>(finalists.size());
  }
  if (variance > 0.0) return std::sqrt(variance);
  // Of one pair nothing varies: then of all pairs of the search.
  statistics::Moments all;
  for (const auto& [key, set] : scores) {
    for (const double each : set.scores) {
      if (!std::isnan(each)) all.add(each);
    }
  }
  return all.variance() > 0.0 ? all.standard_deviation() : 1.0;
}

}  // namespace regista::study
