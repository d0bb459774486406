// SPDX-License-Identifier: MIT
// A comparison of search algorithms as text. Its estimates with their intervals are written by
// estimate_text.cpp.
#include <fmt/format.h>

#include <optional>

#include "report/estimate_text.hpp"
#include "report/experiment.hpp"
#include "report/match_remarks.hpp"
#include "report/objective_numbers.hpp"
#include "report/search_comparison_numbers.hpp"
#include "report/search_comparison_sentences.hpp"
#include "report/text_table.hpp"
#include "report/tuning_problem.hpp"
#include "report/tuning_tables.hpp"
#include "report/visible_text.hpp"

namespace regista::report {
namespace {

std::string quartiles_text(const std::optional<statistics::Quartiles>& of) {
  if (!of) return "-";
  const double margin = (of->upper - of->lower) / 2.0;
  return fmt::format("{} [{}, {}]", rounded_with_sign(of->median, margin), rounded_with_sign(of->lower, margin),
                     rounded_with_sign(of->upper, margin));
}

std::string algorithms_table(const SearchComparisonView& view) {
  TextTable table;
  table.row({"algorithm", "difference", "better", "evaluations", "matches", "runs"});
  for (const AlgorithmSummary& each : algorithm_summaries(view)) {
    table.row({name(each.algorithm), quartiles_text(each.difference),
               each.judged == 0 ? "-" : fmt::format("{} of {}", each.better, each.judged),
               each.runs.empty() ? "-" : fmt::format("{:.0f}", each.evaluations.median),
               each.runs.empty() ? "-" : fmt::format("{:.0f}", each.matches.median), std::to_string(each.runs.size())});
  }
  return fmt::format(
             "\nAlgorithms: difference of {} from the base team, median and quartiles over runs; runs whose mean is "
             "better than the base team; evaluations and matches of a run, median\n",
             objective_text(view.plan.tuning.objective)) +
         indented(table.text());
}

std::string matches_text(const SearchComparisonView& view) {
  return fmt::format("\nMatches: search {}, verification {}; at most {}\n", searched_matches(view),
                     judged_matches(view), most_matches(view.plan));
}

std::string stage_line(const SearchComparisonView& view) {
  if (!view.record.stage) return "all is done";
  return *view.record.stage == study::TuningStage::verification
             ? std::string("judging the runs")
             : fmt::format("run {} of {}", view.record.runs.size() + 1, view.plan.runs());
}

}  // namespace

std::string search_comparison_standing(const SearchComparisonView& view) {
  std::string out = comparison_title(view) + '\n';
  out += fmt::format("{}; matches asked for: {} of at most {}\n", stage_line(view), view.record.tally.matches,
                     most_matches(view.plan));
  if (view.record.runs.empty()) return out;
  const study::ComparedRun& last = view.record.runs.back();
  return out +
         fmt::format("last: {}, run {}: {} in its search (optimistic)\n", name(last.algorithm), last.repeat + 1,
                     last.seen ? rounded(of_objective(view.plan.tuning.objective, *last.seen), 0.0) : "not played");
}

std::string search_comparison_text(const SearchComparisonView& view) {
  const study::TuningPlan& plan = view.plan.tuning;
  const study::MatchTally& tally = view.record.tally;
  std::string out = doubts_text(tally.remarks) + comparison_title(view) + '\n';
  if (!plan.question.empty()) out += visible(plan.question) + '\n';
  if (const std::string unfinished = unfinished_sentence(view); !unfinished.empty()) out += unfinished + '\n';
  const ComparisonVerdict verdict = comparison_verdict(view);
  out += '\n' + verdict.headline + '\n';
  for (const std::string& each : verdict.beside) out += fmt::format("  {}\n", each);
  out += algorithms_table(view) + paragraph("How it was tuned", setup_sentences(view));
  return out + parameters_table(plan) + matches_text(view) + left_out_text(tally) + forfeits_text(plan, tally) +
         notes_text(tally.remarks);
}

}  // namespace regista::report
