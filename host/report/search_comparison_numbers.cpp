// SPDX-License-Identifier: MIT
#include "report/search_comparison_numbers.hpp"

#include "report/objective_numbers.hpp"

namespace regista::report {

std::uint64_t searched_matches(const SearchComparisonView& view) {
  std::uint64_t out = 0;
  for (const study::ComparedRun& each : view.record.runs) out += each.matches;
  return out;
}

std::uint64_t judged_matches(const SearchComparisonView& view) {
  return view.record.stage ? 0 : judging_matches(view.plan);
}

std::vector<AlgorithmSummary> algorithm_summaries(const SearchComparisonView& view) {
  std::vector<AlgorithmSummary> out;
  for (const study::Algorithm algorithm : view.plan.algorithms) {
    AlgorithmSummary& each = out.emplace_back();
    each.algorithm = algorithm;
    std::vector<double> evaluations, matches, differences;
    for (const study::ComparedRun& run : view.record.runs) {
      if (run.algorithm != algorithm) continue;
      each.runs.push_back(&run);
      evaluations.push_back(static_cast<double>(run.evaluations));
      matches.push_back(static_cast<double>(run.matches));
      if (run.judged.pairs == 0) continue;
      differences.push_back(of_objective(view.plan.tuning.objective, run.judged.mean));
      if (run.judged.mean > 0.0) ++each.better;
    }
    if (!each.runs.empty()) {
      each.evaluations = statistics::quartiles(evaluations);
      each.matches = statistics::quartiles(matches);
    }
    each.judged = differences.size();
    if (!differences.empty()) each.difference = statistics::quartiles(differences);
  }
  return out;
}

}  // namespace regista::report
