// SPDX-License-Identifier: MIT
// The outline of a tuning, and lines about a running tuning. tuning_sentences.cpp has the sentences.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "report/number.hpp"
#include "report/tuning_report.hpp"
#include "study/measure.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

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

Section setup_section(const study::TuningPlan& plan) {
  Section out("setup", "How it was tuned");
  out.list(setup_sentences(plan));
  Table table{{{"Parameter", Column::words},
               {"Start"},
               {"Range", Column::words},
               {"Scale", Column::words},
               {"What it is", Column::words, Readers::page}}};
  table.style = Table::Style::values;
  for (const study::Parameter& each : plan.parameters)
    table.row({path(each.path), text_of(each, each.start), range_text(each),
               fmt::format("{}{}", each.log_scale ? "log" : "linear", each.integer ? ", whole numbers" : ""),
               each.doc});
  out.table(std::move(table));
  return out;
}

std::vector<std::string> names_of(const char* figure, std::size_t count) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(fmt::format("{}_{}", figure, i + 1));
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
  const bool any_end = std::ranges::any_of(values, [](const TunedValue& each) { return each.at != RangeEnd::none; });
  const bool any_slice = !record.slices.empty();
  Table table{{{"Parameter", Column::words}, {"Base"}, {"Tuned"}, {"Range", Column::words}}};
  if (any_end) table.headings.push_back({"", Column::words});
  if (any_slice) table.headings.insert(table.headings.end(), {{"Importance"}, {"P", Column::words}});
  table.style = Table::Style::values;
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
    std::vector<Cell> cells{path(parameter.path), text_of(parameter, parameter.start), tuned, range_text(parameter)};
    if (any_end) cells.push_back(end);
    if (any_slice) cells.insert(cells.end(), {importance, p});
    table.row(std::move(cells));
  }
  out.table(std::move(table));
  out.note(slices_note(view));
  out.figures({"importance"});
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
  table.style = Table::Style::values;
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
  constexpr std::size_t most = 500;  // largest number of rows; a download from the page has the complete trace
  const std::vector<study::SearchStep>& trace = view.record.trace;
  Section out("trace", "Trace of the search");
  Table table{{{"Evaluation"}, {"Value"}, {"Best"}, {"Matches"}, {"", Column::words}, {"Values", Column::words}}};
  table.style = Table::Style::tight;
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

// Describes the stage of a running tuning. Precondition: the tuning has not ended.
std::string stage_text(const TuningView& view) {
  const study::TuningRecord& record = view.record;
  if (record.stage == TuningStage::search)
    return fmt::format("search, evaluation {} of at most {}", record.trace.size(), view.plan.evaluations());
  if (record.stage == TuningStage::verification)
    return fmt::format("verification, pair {} of at most {}", record.verification.pairs(),
                       view.plan.verification_pairs);
  return name(record.stage.value());
}

// Returns lines about the first three candidates or, before the verification has pairs, the first three finalists.
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

Json objective(const study::TuningObjective& of) {
  Json terms = Json::array();
  for (const study::ObjectiveTerm& each : of.terms)
    terms.push_back({{"measure", each.measure}, {"unit", study::unit_of(each.measure)}, {"weight", each.weight}});
  return {{"in_words", in_words(of)}, {"minimise", of.minimise}, {"terms", terms}};
}

Json parameters(const study::TuningPlan& plan) {
  Json out = Json::array();
  for (const study::Parameter& each : plan.parameters)
    out.push_back({{"path", each.path},
                   {"base", each.start},
                   {"least", each.least},
                   {"most", each.most},
                   {"integer", each.integer},
                   {"log_scale", each.log_scale},
                   {"unit", each.unit}});
  return out;
}

Json opponents(const study::TuningPlan& plan) {
  Json out = Json::array();
  for (const study::TuningOpponent& each : plan.opponents)
    out.push_back({{"name", each.label}, {"team", each.file}, {"weight", each.weight}});
  return out;
}

Json budget(const study::TuningPlan& plan) {
  return {{"evaluations", plan.evaluations()},   {"pairs_of_an_evaluation", plan.pairs_of_evaluation()},
          {"search_pairs", plan.search_pairs},   {"minutes", json_or_null(plan.asked.search.minutes)},
          {"finalists", plan.finalists()},       {"selection_pairs", plan.selection_pairs},
          {"candidates", plan.candidates()},     {"verification_pairs", plan.verification_pairs},
          {"slice_points", plan.slice_points()}, {"slice_pairs", plan.slice_pairs()}};
}

Json matches(const TuningView& view) {
  const MatchesByStage by = matches_by_stage(view);
  return {{"search", by.search},
          {"selection", by.selection},
          {"verification", by.verification},
          {"slices", by.slices},
          {"asked_for", view.record.tally.matches},
          {"at_most", most_matches(view.plan)}};
}

Json played(const study::TuningPlan& plan, const study::PlayedScore& of) {
  Json out = json_of(of_objective(plan.objective, of.score));
  out["failed"] = of.failed;
  return out;
}

// The values in "values" have the same order as the parameters in "parameters".
Json search(const TuningView& view) {
  const study::TuningRecord& record = view.record;
  Json out{{"evaluations", record.trace.size()},
           {"ended", record.ended.empty() ? Json(nullptr) : Json(record.ended)},
           {"repeated", std::ranges::count_if(record.trace, &study::SearchStep::repeated)},
           {"failed", std::ranges::count_if(record.trace, [](const auto& each) { return each.played.failed; })},
           {"base", nullptr},
           {"best", nullptr}};
  const study::SearchStep* const best = best_step(record);
  if (best == nullptr) return out;
  out["base"] = played(view.plan, record.trace.front().played);
  out["best"] = {{"evaluation", best->evaluation}, {"values", best->values}};
  out["best"].update(played(view.plan, best->played));
  return out;
}

Json finalists(const TuningView& view) {
  Json out = Json::array();
  for (const study::Finalist& each : view.record.finalists)
    out.push_back({{"finalist", out.size() + 1},
                   {"values", each.values},
                   {"search", each.seen ? played(view.plan, *each.seen) : Json(nullptr)},
                   {"selection", played(view.plan, each.selected)}});
  return out;
}

Json verification(const TuningView& view) {
  const auto or_null = [](const std::optional<study::MeanEstimate>& of) { return of ? json_of(*of) : Json(nullptr); };
  Json candidates = Json::array();
  for (const CandidateVerdict& each : candidate_verdicts(view)) {
    const bool any = each.pairs > 0;
    candidates.push_back(
        {{"finalist", each.finalist + 1},
         {"finding", name(each.finding)},
         {"forfeited", each.forfeited},
         {"pairs", each.pairs},
         {"unplayed_pairs", view.record.verification.of()[each.candidate].unplayed_pairs()},
         {"search", or_null(each.seen)},
         {"value", or_null(each.value)},
         {"base", or_null(each.base)},
         {"difference", any ? Json(each.difference.value) : Json(nullptr)},
         {"interval", any ? json_of(each.difference.interval) : Json(nullptr)},
         {"p", each.p},
         {"p_holm", each.adjusted},
         {"search_less_verified",
          each.optimism ? json_number(of_objective(view.plan.objective, *each.optimism)) : Json(nullptr)},
         {"packets_of_short_games", packets_json(each.packets)}});
  }
  return {{"pairs", view.record.verification.pairs()},
          {"against", view.plan.head_to_head() ? "base" : "opponents"},
          {"candidates", candidates}};
}

Json tuned(const TuningView& view) {
  const std::optional<std::size_t> kept = view.record.tuned();
  if (!kept) return nullptr;
  const std::array<Json, 3> ends{nullptr, "lower", "upper"};  // same order as RangeEnd
  Json all = Json::array();
  for (const TunedValue& each : tuned_values(view))
    all.push_back({{"path", view.plan.parameters[each.parameter].path},
                   {"base", each.base},
                   {"tuned", each.tuned},
                   {"at_end", ends[static_cast<std::size_t>(each.at)]}});
  return {{"finalist", *kept + 1}, {"verified", view.record.verified()}, {"values", all}};
}

Json slices(const TuningView& view) {
  Json out = Json::array();
  for (const study::Slice& slice : view.record.slices) {
    Json points = Json::array();
    for (const study::SlicePoint& each : slice.points)
      points.push_back({{"value", each.value},
                        {"objective", json_of(of_objective(view.plan.objective, each.score))},
                        {"difference", json_of(of_objective(view.plan.objective, each.difference))}});
    out.push_back({{"path", view.plan.parameters[slice.parameter].path},
                   {"importance", slice.p ? Json(slice.importance) : Json(nullptr)},
                   {"p", json_or_null(slice.p)},
                   {"more_than_chance", more_than_chance(slice)},
                   {"points", points}});
  }
  return out;
}

}  // namespace

static Json tuning_data(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const study::TuningRecord& record = view.record;
  const TuningVerdict verdict = tuning_verdict(view);
  const study::MatchTally& tally = record.tally;
  return {
      {"tuning", plan.asked.name},
      {"question", plan.asked.question},
      {"team", plan.asked.team},
      {"set", plan.settings},
      {"objective", objective(plan.objective)},
      {"parameters", parameters(plan)},
      {"opponents", opponents(plan)},
      {"openings", plan.openings.size()},
      {"algorithm", name(plan.algorithm())},
      {"seed", plan.seed()},
      {"confidence", plan.confidence()},
      {"budget", budget(plan)},
      {"complete", !record.stage},
      {"stage", record.stage ? Json(name(*record.stage)) : Json(nullptr)},
      {"matches", matches(view)},
      {"verdict", verdict.headline},
      {"findings", verdict.beside},
      {"search", search(view)},
      {"finalists", finalists(view)},
      {"verification", verification(view)},
      {"verified", record.verified()},
      {"tuned", tuned(view)},
      {"slices", slices(view)},
      {"compared", nullptr},  // always null; the key is for programs that read reports of earlier versions
      {"forfeits",
       {{"listed", forfeits_json(tally.forfeits, forfeit_words(plan), "by")}, {"unlisted", tally.forfeits.unlisted()}}},
      {"unplayed", unplayed_json(tally.unplayed_pairs, tally.remarks)},
      {"tuned_file", view.tuned_file.empty() ? Json(nullptr) : Json(view.tuned_file)}};
}

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
  const std::vector<CandidateVerdict> verified = candidate_verdicts(view);
  out.lead =
      std::ranges::any_of(verified, [](const auto& each) { return each.pairs > 0; }) ? "verification" : "convergence";
  out.played = what_was_played(plan);
  Section findings("findings", "What was found"), convergence("convergence", "The search"),
      slices("slices", "Each parameter by itself"), matches("matches", "Matches"), base("base", "The base team");
  if (!view.tuned_file.empty())
    findings.line(Sentence("The tuned team is in ")
                  << path(view.tuned_file) << (view.record.verified() ? "." : ", although it was not found better."));
  convergence.list(search_sentences(view));
  convergence.figures({"convergence"});
  convergence.figures(names_of("history", plan.parameters.size()), Figures::Style::beside);
  slices.figures(names_of("slice", view.record.slices.size()), Figures::Style::beside);
  const MatchesByStage by = matches_by_stage(view);
  matches.line(fmt::format("search {}, selection {}, verification {}, slices {}; at most {}", by.search, by.selection,
                           by.verification, by.slices, most_matches(plan)),
               Readers::terminal);
  base.listing("In full", plan.document);
  for (const Section& each :
       {findings, setup_section(plan), convergence, values_section(view), slices, finalists_section(view),
        trace_section(view), matches, unplayed_section(tally.unplayed_pairs, tally.remarks),
        forfeits_section(tally.forfeits, forfeit_words(plan)), base})
    out.add(each);
  out.remarks = tally.remarks;
  out.data = [view] { return tuning_data(view); };
  return out;
}

}  // namespace regista::report
