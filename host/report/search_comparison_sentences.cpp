// SPDX-License-Identifier: MIT
#include "report/search_comparison_sentences.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "report/estimate_text.hpp"
#include "report/objective_numbers.hpp"
#include "report/search_comparison_numbers.hpp"
#include "report/tuning_problem.hpp"
#include "report/visible_text.hpp"

namespace regista::report {
namespace {

std::string plan_sentence(const study::SearchComparisonPlan& of) {
  const study::TuningPlan& plan = of.tuning;
  std::vector<std::string> names;
  for (const study::Algorithm each : of.algorithms) {
    names.push_back(fmt::format("{} ({} for each evaluation)", name(each), pairs_text(plan.pairs_of(each))));
  }
  return fmt::format(
      "Compared: {}; {} of each, seeds from {}. Each has the same budget, {}, and its result is judged on the same {} "
      "with held-out seeds as all others.",
      fmt::join(names, ", "), counted(of.repeats, "run", "runs"), plan.seed,
      counted(plan.search_pairs * plan.matches_of_pair(), "match", "matches"), pairs_text(plan.verification_pairs));
}

std::string headline_of(const SearchComparisonView& view) {
  std::vector<AlgorithmSummary> placed = algorithm_summaries(view);
  std::erase_if(placed, [](const AlgorithmSummary& each) { return !each.difference; });
  if (placed.empty()) return "No run has been judged yet, so nothing can be said.";
  std::ranges::stable_sort(placed, std::greater(), [&](const AlgorithmSummary& each) {
    return study::score_of(view.plan.tuning.objective, each.difference->median);
  });
  std::string order;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const double median = placed[i].difference->median;
    if (i > 0) order += ", ";
    order += fmt::format("{} {}", name(placed[i].algorithm), rounded_with_sign(median, 0.0));
  }
  return fmt::format("Median difference in {} from the base team: {}. Nothing was tested.",
                     visible(in_words(view.plan.tuning.objective)), order);
}

}  // namespace

std::string comparison_title(const SearchComparisonView& view) {
  return fmt::format("{}, by {}", problem_title(view.plan.tuning),
                     counted(view.plan.algorithms.size(), "algorithm", "algorithms"));
}

std::string unfinished_sentence(const SearchComparisonView& view) {
  if (!view.record.stage) return {};
  if (*view.record.stage == study::TuningStage::verification) return "Not at its end: the runs are being judged.";
  return fmt::format("Not at its end: {} of {} runs.", view.record.runs.size(), view.plan.runs());
}

std::vector<std::string> setup_sentences(const SearchComparisonView& view) {
  std::vector<std::string> out = problem_sentences(view.plan.tuning);
  out.push_back(plan_sentence(view.plan));
  return out;
}

ComparisonVerdict comparison_verdict(const SearchComparisonView& view) {
  ComparisonVerdict out{caution(view.record.tally.remarks, view.plan.tuning.limits) + headline_of(view), {}};
  if (view.record.stage) return out;
  out.beside.push_back(
      fmt::format("All had the same budget, {}, and were judged on the same {} with held-out seeds. A search that "
                  "ended by itself played fewer matches.",
                  counted(view.plan.tuning.search_pairs * view.plan.tuning.matches_of_pair(), "match", "matches"),
                  pairs_text(view.plan.tuning.verification_pairs)));
  out.beside.push_back(
      fmt::format("The medians are over {}, in their order, and were not tested: they say how these runs went, not "
                  "which algorithm is better.",
                  counted(view.plan.repeats, "run", "runs")));
  return out;
}

}  // namespace regista::report
