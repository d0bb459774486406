// SPDX-License-Identifier: MIT
// A tuning as text. Its estimates with their intervals are written by estimate_text.cpp (with_interval), the sentences
// around them by tuning_sentences.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "report/estimate_text.hpp"
#include "report/experiment.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "report/text_table.hpp"
#include "report/tuning_sentences.hpp"
#include "report/tuning_tables.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

using study::TuningStage;

std::string finalists_table(const TuningView& view) {
  const study::TuningRecord& record = view.record;
  if (record.finalists.empty()) return {};
  const study::ParameterValues base = start_values(view.plan);
  TextTable table;
  table.row({"finalist", "in the search", "on the selection", ""});
  for (std::size_t i = 0; i < record.finalists.size(); ++i) {
    const study::Finalist& each = record.finalists[i];
    const bool candidate = std::ranges::find(record.candidates, i) != record.candidates.end();
    table.row(
        {std::to_string(i + 1), seen_text(view.plan, each),
         each.selected.failed ? "forfeited" : with_interval(of_objective(view.plan.objective, each.selected.score)),
         each.values == base ? "the base team"
         : candidate         ? "candidate"
                             : ""});
  }
  return fmt::format(
             "\nFinalists, with {:.4g} % intervals; the value in the search is optimistic (parameters: --json, or the "
             "page)\n",
             100.0 * view.plan.confidence()) +
         indented(table.text());
}

std::string tuned_table(const TuningView& view) {
  const std::vector<TunedValue> values = tuned_values(view);
  if (values.empty()) return {};
  TextTable table;
  table.row({"parameter", "base", "tuned", "range", ""});
  for (const TunedValue& each : values) {
    const study::Parameter& parameter = view.plan.parameters[each.parameter];
    table.row({texts::visible(parameter.path), text_of(parameter, each.base), text_of(parameter, each.tuned),
               range_text(parameter), end_text(each.at)});
  }
  return fmt::format("\nValues of finalist {}{}\n", *view.record.tuned() + 1,
                     view.record.verified() ? "" : ", which was not found better") +
         indented(table.text());
}

std::string importance_table(const TuningView& view) {
  if (view.record.slices.empty()) return {};
  TextTable table;
  table.row({"parameter", "importance", ""});
  for (const study::Slice& each : view.record.slices) {
    table.row(
        {texts::visible(view.plan.parameters[each.parameter].path), importance_value(each), importance_text(each)});
  }
  return "\nImportance of the parameters\n" + indented(table.text()) + fmt::format("  {}\n", slices_note(view));
}

std::string matches_text(const TuningView& view) {
  const MatchesByStage matches = matches_by_stage(view);
  std::string out = fmt::format("\nMatches: search {}", matches.search);
  out += fmt::format(", selection {}, verification {}, slices {}", matches.selection, matches.verification,
                     matches.slices);
  return out + fmt::format("; at most {}\n", most_matches(view.plan));
}

// One line for each of the best finalists, or of the candidates once pairs of theirs are verified.
std::string finalists_in_short(const TuningView& view) {
  constexpr std::size_t shown = 3;
  std::string out;
  const std::vector<CandidateVerdict> candidates = candidate_verdicts(view);
  for (std::size_t i = 0; i < std::min(candidates.size(), shown); ++i) {
    const CandidateVerdict& each = candidates[i];
    if (each.pairs == 0) continue;
    out +=
        fmt::format("finalist {}: difference {}, {}{}, {}\n", each.finalist + 1, signed_with_interval(each.difference),
                    p_text(each.adjusted), candidates.size() > 1 ? " after Holm" : "", name(each.finding));
  }
  if (!out.empty()) return out;
  for (std::size_t i = 0; i < std::min(view.record.finalists.size(), shown); ++i) {
    const study::Finalist& each = view.record.finalists[i];
    out += fmt::format("finalist {}: {} on the selection, {}\n", i + 1,
                       with_interval(of_objective(view.plan.objective, each.selected.score)),
                       seen_text(view.plan, each) + " in the search" + (each.seen ? " (optimistic)" : ""));
  }
  return out;
}

std::string stage_line(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const study::TuningRecord& record = view.record;
  if (!record.stage) return "all is done";
  switch (*record.stage) {
    case TuningStage::search:
      return fmt::format("search, evaluation {} of at most {}", record.trace.size(), plan.evaluations());
    case TuningStage::verification:
      return fmt::format("verification, pair {} of at most {}", record.verification.pairs(), plan.verification_pairs);
    case TuningStage::selection:
    case TuningStage::slices:
      break;
  }
  return name(*record.stage);
}

}  // namespace

std::string tuning_standing(const TuningView& view) {
  const study::TuningRecord& record = view.record;
  std::string out = problem_title(view.plan) + '\n';
  out += fmt::format("{}; matches asked for: {} of at most {}\n", stage_line(view), record.tally.matches,
                     most_matches(view.plan));
  if (const study::SearchStep* const best = best_step(record)) {
    out += fmt::format("best so far: {} {} at evaluation {} (optimistic), the base team {}\n",
                       texts::visible(in_words(view.plan.objective)),
                       with_interval(of_objective(view.plan.objective, best->played.score)), best->evaluation,
                       with_interval(of_objective(view.plan.objective, record.trace.front().played.score)));
  }
  return out + finalists_in_short(view);
}

std::string tuning_text(const TuningView& view) {
  std::string out = doubts_text(view.record.tally.remarks) + problem_title(view.plan) + '\n';
  if (!view.plan.asked.question.empty()) out += texts::visible(view.plan.asked.question) + '\n';
  if (const std::string unfinished = unfinished_sentence(view); !unfinished.empty()) out += unfinished + '\n';
  out += played_text(what_was_played(view.plan));
  const TuningVerdict verdict = tuning_verdict(view);
  out += '\n' + verdict.headline + '\n';
  for (const std::string& each : verdict.beside) out += fmt::format("  {}\n", each);
  if (!view.tuned_file.empty()) {
    out += fmt::format("\nThe tuned team is in {}{}\n", texts::visible(view.tuned_file),
                       view.record.verified() ? "." : ", although it was not found better.");
  }
  out += tuned_table(view) + importance_table(view) + finalists_table(view);
  out += paragraph("Search", search_sentences(view)) + paragraph("How it was tuned", setup_sentences(view));
  return out + parameters_table(view.plan) + matches_text(view) + left_out_text(view.record.tally) +
         forfeits_text(view.plan, view.record.tally) + notes_text(view.record.tally.remarks);
}

}  // namespace regista::report
