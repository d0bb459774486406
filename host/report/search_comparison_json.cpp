// SPDX-License-Identifier: MIT
// A comparison of search algorithms as JSON.
#include "config/json.hpp"
#include "report/objective_numbers.hpp"
#include "report/search_comparison_numbers.hpp"
#include "report/search_comparison_sentences.hpp"
#include "report/tuning_json_parts.hpp"

namespace regista::report {
namespace {

using Json = nlohmann::ordered_json;

Json quartiles(const statistics::Quartiles& of) { return Json::array({of.lower, of.median, of.upper}); }

Json run_json(const study::TuningObjective& objective, const study::ComparedRun& run) {
  return {{"repeat", run.repeat + 1},
          {"evaluations", run.evaluations},
          {"matches", run.matches},
          {"ended", run.ended},
          {"values", run.values},  // in the order of "parameters"
          {"seen", json_of_score(objective, run.seen)},
          {"judged", json_of(of_objective(objective, run.judged))}};
}

Json compared(const SearchComparisonView& view) {
  Json out = Json::array();
  for (const AlgorithmSummary& each : algorithm_summaries(view)) {
    Json runs = Json::array();
    for (const study::ComparedRun* const run : each.runs) runs.push_back(run_json(view.plan.tuning.objective, *run));
    const bool any = !each.runs.empty();
    out.push_back({{"algorithm", name(each.algorithm)},
                   {"difference_quartiles", each.difference ? quartiles(*each.difference) : Json(nullptr)},
                   {"better", each.better},
                   {"judged", each.judged},
                   {"evaluations_quartiles", any ? quartiles(each.evaluations) : Json(nullptr)},
                   {"matches_quartiles", any ? quartiles(each.matches) : Json(nullptr)},
                   {"runs", runs}});
  }
  return out;
}

// By the stages of a tuning, two of which a comparison has.
Json matches(const SearchComparisonView& view) {
  return {{"search", searched_matches(view)},       {"selection", 0},
          {"verification", judged_matches(view)},   {"slices", 0},
          {"asked_for", view.record.tally.matches}, {"at_most", most_matches(view.plan)}};
}

}  // namespace

std::string search_comparison_json(const SearchComparisonView& view) {
  const study::TuningPlan& plan = view.plan.tuning;
  const ComparisonVerdict verdict = comparison_verdict(view);
  Json out = problem_json(plan);
  out["algorithm"] = nullptr;  // several: see "compared"
  out["seed"] = plan.seed;
  out["confidence"] = plan.confidence;
  out["budget"] = budget_json(plan);
  out["complete"] = !view.record.stage;
  out["stage"] = view.record.stage ? Json(study::name(*view.record.stage)) : Json(nullptr);
  out["matches"] = matches(view);
  out["verdict"] = verdict.headline;
  out["findings"] = verdict.beside;
  out["compared"] = compared(view);
  out.update(tally_json(plan, view.record.tally));
  out["tuned_file"] = nullptr;  // none is written
  return out.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace regista::report
