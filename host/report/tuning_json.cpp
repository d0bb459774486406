// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "config/json.hpp"
#include "report/match_remarks.hpp"
#include "report/packets_spent.hpp"
#include "report/tuning_sentences.hpp"
#include "study/measure.hpp"

namespace regista::report {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinite numbers.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json or_null(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

// A score, or a difference of scores.
Json told_or_null(const study::TuningObjective& objective, const std::optional<double>& score) {
  if (!score) return nullptr;
  return number(told(objective, *score));
}

Json ends(const statistics::Interval& interval) { return Json::array({number(interval.low), number(interval.high)}); }

// Of the user's terms.
Json json_of(const study::MeanEstimate& estimate) {
  const bool any = estimate.pairs > 0;
  return {{"pairs", estimate.pairs},
          {"mean", any ? Json(estimate.mean) : Json(nullptr)},
          {"standard_deviation", estimate.pairs > 1 ? Json(estimate.standard_deviation) : Json(nullptr)},
          {"interval", estimate.interval ? ends(*estimate.interval) : Json(nullptr)}};
}

Json json_of(const statistics::Quartiles& of) { return Json::array({of.lower, of.median, of.upper}); }

Json objective(const study::TuningObjective& of) {
  Json terms = Json::array();
  for (const study::ObjectiveTerm& each : of.terms) {
    terms.push_back({{"measure", each.measure}, {"unit", study::unit_of(each.measure)}, {"weight", each.weight}});
  }
  return {{"in_words", in_words(of)}, {"minimise", of.minimise}, {"terms", terms}};
}

Json parameters(const study::TuningPlan& plan) {
  Json out = Json::array();
  for (const study::Parameter& each : plan.parameters) {
    out.push_back({{"path", each.path},
                   {"base", each.start},
                   {"least", each.least},
                   {"most", each.most},
                   {"integer", each.integer},
                   {"log_scale", each.log_scale},
                   {"unit", each.unit}});
  }
  return out;
}

Json opponents(const study::TuningPlan& plan) {
  Json out = Json::array();
  for (const study::TuningOpponent& each : plan.opponents) {
    out.push_back({{"name", each.label}, {"team", each.file}, {"weight", each.weight}});
  }
  return out;
}

// In the order of "parameters".
Json values(const study::ParameterValues& of) { return Json(of); }

Json budget(const study::TuningPlan& plan) {
  Json out;
  if (!plan.compares()) {
    out["evaluations"] = plan.evaluations(plan.algorithm);
    out["pairs_of_an_evaluation"] = plan.pairs_of(plan.algorithm);
  }
  out["search_pairs"] = plan.search_pairs;
  out["minutes"] = or_null(plan.minutes);
  out["finalists"] = plan.finalists;
  out["selection_pairs"] = plan.selection_pairs;
  out["candidates"] = plan.candidates;
  out["verification_pairs"] = plan.verification_pairs;
  out["slice_points"] = plan.slice_points;
  out["slice_pairs"] = plan.slice_pairs;
  return out;
}

Json played(const study::TuningPlan& plan, const study::PlayedScore& of) {
  Json out = json_of(told(plan.objective, of.score));
  out["failed"] = of.failed;
  return out;
}

Json search_json(const TuningView& view) {
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
  out["best"] = {{"evaluation", best->evaluation}, {"values", values(best->values)}};
  out["best"].update(played(view.plan, best->played));
  return out;
}

Json finalists(const TuningView& view) {
  Json out = Json::array();
  for (std::size_t i = 0; i < view.record.finalists.size(); ++i) {
    const study::Finalist& each = view.record.finalists[i];
    out.push_back({{"finalist", i + 1},
                   {"values", values(each.values)},
                   {"search", each.seen ? played(view.plan, *each.seen) : Json(nullptr)},
                   {"selection", played(view.plan, each.selected)}});
  }
  return out;
}

Json verification(const TuningView& view) {
  Json candidates = Json::array();
  for (const CandidateVerdict& each : candidate_verdicts(view)) {
    const bool any = each.pairs > 0;
    candidates.push_back({{"finalist", each.finalist + 1},
                          {"finding", name(each.finding)},
                          {"forfeited", each.forfeited},
                          {"pairs", each.pairs},
                          {"unplayed_pairs", view.record.verification.of()[each.candidate].unplayed_pairs()},
                          {"search", each.seen ? json_of(*each.seen) : Json(nullptr)},
                          {"value", each.value ? json_of(*each.value) : Json(nullptr)},
                          {"base", each.base ? json_of(*each.base) : Json(nullptr)},
                          {"difference", any ? Json(each.difference.value) : Json(nullptr)},
                          {"interval", any ? ends(each.difference.interval) : Json(nullptr)},
                          {"p", each.p},
                          {"p_holm", each.adjusted},
                          {"search_less_verified", told_or_null(view.plan.objective, each.optimism)},
                          {"packets_of_short_games", packets_json(each.packets)}});
  }
  return {{"pairs", view.record.verification.pairs()},
          {"against", view.plan.head_to_head ? "base" : "opponents"},
          {"candidates", candidates}};
}

Json tuned(const TuningView& view) {
  const std::optional<std::size_t> kept = view.record.tuned();
  if (!kept) return nullptr;
  Json all = Json::array();
  for (const TunedValue& each : tuned_values(view)) {
    all.push_back({{"path", view.plan.parameters[each.parameter].path},
                   {"base", each.base},
                   {"tuned", each.tuned},
                   {"at_end", each.at == RangeEnd::none    ? Json(nullptr)
                              : each.at == RangeEnd::lower ? Json("lower")
                                                           : Json("upper")}});
  }
  return {{"finalist", *kept + 1}, {"verified", view.record.verified()}, {"values", all}};
}

Json slices(const TuningView& view) {
  Json out = Json::array();
  for (const study::Slice& slice : view.record.slices) {
    Json points = Json::array();
    for (const study::SlicePoint& each : slice.points) {
      points.push_back({{"value", each.value},
                        {"objective", json_of(told(view.plan.objective, each.score))},
                        {"difference", json_of(told(view.plan.objective, each.difference))}});
    }
    out.push_back({{"path", view.plan.parameters[slice.parameter].path},
                   {"importance", slice.p ? Json(slice.importance) : Json(nullptr)},
                   {"p", or_null(slice.p)},
                   {"more_than_chance", more_than_chance(slice)},
                   {"points", points}});
  }
  return out;
}

Json compared(const TuningView& view) {
  if (!view.plan.compares()) return nullptr;
  Json out = Json::array();
  for (const AlgorithmSummary& each : algorithm_summaries(view)) {
    Json runs = Json::array();
    for (const study::ComparedRun* const run : each.runs) {
      runs.push_back({{"repeat", run->repeat + 1},
                      {"evaluations", run->evaluations},
                      {"matches", run->matches},
                      {"ended", run->ended},
                      {"values", values(run->values)},
                      {"seen", told_or_null(view.plan.objective, run->seen)},
                      {"judged", json_of(told(view.plan.objective, run->judged))}});
    }
    const bool any = !each.runs.empty();
    out.push_back({{"algorithm", name(each.algorithm)},
                   {"difference_quartiles", each.difference ? json_of(*each.difference) : Json(nullptr)},
                   {"better", each.better},
                   {"judged", each.judged},
                   {"evaluations_quartiles", any ? json_of(each.evaluations) : Json(nullptr)},
                   {"matches_quartiles", any ? json_of(each.matches) : Json(nullptr)},
                   {"runs", runs}});
  }
  return out;
}

Json forfeits(const TuningView& view) {
  Json listed = Json::array();
  for (const study::Forfeits& each : view.record.forfeits.listed()) {
    listed.push_back({{"by", forfeiter(view.plan, each.team)},
                      {"plugin", each.failure.plugin},
                      {"call", each.failure.call},
                      {"what", each.failure.what},
                      {"matches", each.count},
                      {"first_match", each.first_match + 1}});
  }
  return {{"listed", listed}, {"unlisted", view.record.forfeits.unlisted()}};
}

Json matches(const TuningView& view) {
  const MatchesByStage by = matches_by_stage(view);
  return {{"search", by.search}, {"selection", by.selection},        {"verification", by.verification},
          {"slices", by.slices}, {"asked_for", view.record.matches}, {"at_most", most_matches(view.plan)}};
}

}  // namespace

std::string tuning_json(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const TuningVerdict verdict = tuning_verdict(view);
  Json out;
  out["tuning"] = plan.name;
  out["question"] = plan.question;
  out["team"] = plan.team;
  out["set"] = plan.settings;
  out["objective"] = objective(plan.objective);
  out["parameters"] = parameters(plan);
  out["opponents"] = opponents(plan);
  out["openings"] = plan.openings.size();
  out["algorithm"] = plan.compares() ? Json(nullptr) : Json(name(plan.algorithm));
  out["seed"] = plan.seed;
  out["confidence"] = plan.confidence;
  out["budget"] = budget(plan);
  out["complete"] = !view.record.stage;
  out["stage"] = view.record.stage ? Json(name(*view.record.stage)) : Json(nullptr);
  out["matches"] = matches(view);
  out["verdict"] = verdict.headline;
  out["findings"] = verdict.beside;
  if (!plan.compares()) {
    out["search"] = search_json(view);
    out["finalists"] = finalists(view);
    out["verification"] = verification(view);
    out["verified"] = view.record.verified();
    out["tuned"] = tuned(view);
    out["slices"] = slices(view);
  }
  out["compared"] = compared(view);
  out["forfeits"] = forfeits(view);
  out["unplayed"] = unplayed_json(view.record.unplayed_pairs, view.record.remarks);
  out["not_reproducible"] = irreproducible_json(view.record.remarks);
  out["standard_error"] = written_json(view.record.remarks);
  out["tuned_file"] = view.tuned_file.empty() ? Json(nullptr) : Json(view.tuned_file);
  return out.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace regista::report
