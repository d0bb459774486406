// SPDX-License-Identifier: MIT
// A tuning as an outline, and how it stands while it runs. Its sentences are in tuning_sentences.cpp.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "report/estimate_text.hpp"
#include "report/number.hpp"
#include "report/tuning_sentences.hpp"
#include "texts/json.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

using study::TuningStage;

std::string value_text(const study::TuningPlan& plan, const study::MeanEstimate& score) {
  return with_interval(of_objective(plan.objective, score));
}

std::string outcome_text(const study::TuningPlan& plan, const study::PlayedScore& played) {
  return played.failed ? "forfeited" : value_text(plan, played.score);
}

std::string seen_text(const study::TuningPlan& plan, const study::Finalist& finalist) {
  return finalist.seen ? outcome_text(plan, *finalist.seen) : "not played";
}

std::vector<Tile> tiles(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const MatchesByStage matches = matches_by_stage(view);
  std::vector<Tile> out;
  for (const CandidateVerdict& each : candidate_verdicts(view)) {
    if (each.finalist != view.record.tuned() || each.pairs == 0) continue;
    out.push_back({signed_with_interval(each.difference),
                   fmt::format("{} of the tuned team less the base team's", in_words(plan.objective))});
    if (each.seen && each.value) {
      out.push_back({rounded(each.value->mean, 0.0),
                     fmt::format("on the verification; the search had {}", rounded(each.seen->mean, 0.0))});
    }
  }
  out.push_back({std::to_string(plan.free_parameters()), plan.free_parameters() == 1 ? "parameter" : "parameters"});
  out.push_back({std::to_string(view.record.trace.size()), "evaluations of the search"});
  out.push_back({std::to_string(matches.search + matches.selection + matches.verification + matches.slices),
                 fmt::format("matches, of at most {}", most_matches(plan))});
  return out;
}

Section findings_section(const TuningView& view) {
  Section out("findings", "What was found");
  if (!view.tuned_file.empty())
    out.line(Sentence("The tuned team is in ")
             << path(view.tuned_file) << (view.record.verified() ? "." : ", although it was not found better."));
  return out;
}

Section setup_section(const study::TuningPlan& plan) {
  Section out("setup", "How it was tuned");
  out.list(setup_sentences(plan));
  Table table{{{"Parameter", Column::words},
               {"Start"},
               {"Range", Column::words},
               {"Scale", Column::words},
               {"What it is", Column::words, Readers::page}}};
  table.look = Table::Look::values;
  for (const study::Parameter& each : plan.parameters)
    table.row({path(each.path), text_of(each, each.start), range_text(each),
               fmt::format("{}{}", each.log_scale ? "log" : "linear", each.integer ? ", whole numbers" : ""),
               each.doc});
  out.table(std::move(table));
  return out;
}

Section convergence_section(const TuningView& view) {
  Section out("convergence", "The search");
  out.list(search_sentences(view));
  out.figures({"convergence"});
  return out;
}

Section values_section(const TuningView& view) {
  const study::TuningRecord& record = view.record;
  const std::vector<TunedValue> values = tuned_values(view);
  Section out("values", "Tuned values and importance");
  if (values.empty() && record.slices.empty()) return out;
  if (!values.empty())
    out.note(fmt::format("Of finalist {}{}", *record.tuned() + 1,
                         record.verified() ? "." : ", which was not found better than the base team."));
  Table table{{{"Parameter", Column::words},
               {"Base"},
               {"Tuned"},
               {"Range", Column::words},
               {"", Column::words},
               {"Importance"},
               {"P", Column::words}}};
  table.look = Table::Look::values;
  for (std::size_t i = 0; i < view.plan.parameters.size(); ++i) {
    const study::Parameter& parameter = view.plan.parameters[i];
    if (parameter.fixed()) continue;
    Cell tuned = "–", end, importance = "–", p = "–";
    if (const auto value = std::ranges::find(values, i, &TunedValue::parameter); value != values.end()) {
      tuned = text_of(parameter, value->tuned);
      tuned.stressed = value->tuned != value->base;
      if (value->at != RangeEnd::none) end = value->at == RangeEnd::lower ? "at the lower end" : "at the upper end";
    }
    if (const auto slice = std::ranges::find(record.slices, i, &study::Slice::parameter);
        slice != record.slices.end()) {
      if (slice->p) importance = rounded(slice->importance, 0.0);
      p = importance_text(*slice);
    }
    table.row(
        {path(parameter.path), text_of(parameter, parameter.start), tuned, range_text(parameter), end, importance, p});
  }
  out.table(std::move(table));
  out.note(slices_note(view));
  out.figures({"importance"});
  return out;
}

Section slices_section(const TuningView& view) {
  Section out("slices", "Each parameter by itself");
  std::vector<std::string> names;
  for (std::size_t i = 0; i < view.record.slices.size(); ++i) names.push_back(fmt::format("slice_{}", i + 1));
  out.figures(std::move(names), Figures::Look::beside);
  return out;
}

Section finalists_section(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const study::TuningRecord& record = view.record;
  Section out("finalists", "Finalists");
  if (record.finalists.empty()) return out;
  const study::ParameterValues base = start_values(plan);
  std::vector<Heading> headings{{"Finalist"}, {"In the search (optimistic)"}, {"On the selection"}};
  for (const study::Parameter& each : plan.parameters) {
    if (!each.fixed()) headings.push_back({path(each.path), Column::number, Readers::page});
  }
  headings.push_back({"", Column::words});
  Table table(std::move(headings));
  table.look = Table::Look::values;
  for (std::size_t i = 0; i < record.finalists.size(); ++i) {
    const study::Finalist& each = record.finalists[i];
    std::vector<Cell> cells{i + 1, seen_text(plan, each), outcome_text(plan, each.selected)};
    for (std::size_t j = 0; j < plan.parameters.size(); ++j) {
      if (!plan.parameters[j].fixed()) cells.emplace_back(text_of(plan.parameters[j], each.values[j]));
    }
    const bool verified = std::ranges::find(record.candidates, i) != record.candidates.end();
    cells.emplace_back(each.values == base ? "the base team" : verified ? "candidate" : "");
    table.row(std::move(cells));
  }
  out.note(
      fmt::format("In the order of the selection, whose pairs the search did not play. In brackets: {:.4g} % "
                  "intervals of Student's t.",
                  100.0 * plan.confidence()));
  out.table(std::move(table));
  out.note("Their values: --json, or the page.", Readers::terminal);
  return out;
}

std::string values_text(const study::TuningPlan& plan, const study::ParameterValues& values) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
    const study::Parameter& each = plan.parameters[i];
    if (!each.fixed()) out.push_back(fmt::format("{}={}", each.path, text_of(each, values[i])));
  }
  return fmt::format("{}", fmt::join(out, ", "));
}

Section trace_section(const TuningView& view) {
  constexpr std::size_t most = 500;  // that are shown; all of it can be taken away
  const std::vector<study::SearchStep>& trace = view.record.trace;
  Section out("trace", "Trace of the search");
  Table table{{{"Evaluation"}, {"Value"}, {"Best"}, {"Matches"}, {"", Column::words}, {"Values", Column::words}}};
  table.look = Table::Look::tight;
  for (std::size_t i = 0; i < std::min(trace.size(), most); ++i) {
    const study::SearchStep& each = trace[i];
    table.row({each.evaluation, each.played.failed ? "–" : value_text(view.plan, each.played.score),
               rounded(of_objective(view.plan.objective, each.best), 0.0), each.matches,
               each.played.failed ? "forfeited"
               : each.repeated    ? "played before"
                                  : "",
               values_text(view.plan, each.values)});
  }
  table.summary = trace.size() <= most ? fmt::format("All {} evaluations", trace.size())
                                       : fmt::format("The first {} of {} evaluations", most, trace.size());
  table.file = "trace.csv";
  table.csv = tuning_csv(view);
  out.table(std::move(table), Readers::page);
  return out;
}

Section matches_section(const TuningView& view) {
  const MatchesByStage matches = matches_by_stage(view);
  Section out("matches", "Matches");
  out.line(fmt::format("search {}, selection {}, verification {}, slices {}; at most {}", matches.search,
                       matches.selection, matches.verification, matches.slices, most_matches(view.plan)),
           Readers::terminal);
  return out;
}

Section base_section(const study::TuningPlan& plan) {
  Section out("base", "The base team");
  out.listing("In full", plan.document);
  return out;
}

// Precondition: it is not at its end.
std::string stage_text(const TuningView& view) {
  const study::TuningRecord& record = view.record;
  switch (record.stage.value()) {
    case TuningStage::search:
      return fmt::format("search, evaluation {} of at most {}", record.trace.size(), view.plan.evaluations());
    case TuningStage::verification:
      return fmt::format("verification, pair {} of at most {}", record.verification.pairs(),
                         view.plan.verification_pairs);
    case TuningStage::selection:
    case TuningStage::slices:
      break;
  }
  return name(*record.stage);
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
    out += fmt::format("finalist {}: {} on the selection, {} in the search{}\n", i + 1,
                       value_text(view.plan, each.selected.score), seen_text(view.plan, each),
                       each.seen ? " (optimistic)" : "");
  }
  return out;
}

}  // namespace

std::string tuning_standing(const TuningView& view) {
  const study::TuningRecord& record = view.record;
  std::string out = texts::visible(problem_title(view.plan)) + '\n';
  out += fmt::format("{}; matches asked for: {} of at most {}\n", record.stage ? stage_text(view) : "all is done",
                     record.tally.matches, most_matches(view.plan));
  if (const study::SearchStep* const best = best_step(record)) {
    out += fmt::format("best so far: {} {} at evaluation {} (optimistic), the base team {}\n",
                       texts::visible(in_words(view.plan.objective)), value_text(view.plan, best->played.score),
                       best->evaluation, value_text(view.plan, record.trace.front().played.score));
  }
  return out + finalists_in_short(view);
}

Outline tuning_outline(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const study::MatchTally& tally = view.record.tally;
  const TuningVerdict verdict = tuning_verdict(view);
  Outline out;
  out.kind = "Tuning";
  out.title = problem_title(plan);
  out.question = plan.asked.question;
  out.headline = verdict.headline;
  if (view.record.stage) out.beside.emplace_back(fmt::format("Not at its end: {}.", stage_text(view)));
  for (const std::string& each : verdict.beside) out.beside.emplace_back(each);
  out.tiles = tiles(view);
  out.played = what_was_played(plan);
  for (Section& each :
       std::array{findings_section(view), setup_section(plan), convergence_section(view), values_section(view),
                  slices_section(view), finalists_section(view), trace_section(view), matches_section(view),
                  unplayed_section(tally.unplayed_pairs, tally.remarks),
                  forfeits_section(tally.forfeits, forfeit_words(plan)), base_section(plan)})
    out.add(std::move(each));
  out.remarks = tally.remarks;
  out.data = [view] { return tuning_data(view); };
  return out;
}

}  // namespace regista::report
