// SPDX-License-Identifier: MIT
// A tuning in numbers for programs.
#include <algorithm>

#include "report/number_json.hpp"
#include "report/packets_spent.hpp"
#include "report/tuning_sentences.hpp"
#include "study/measure.hpp"
#include "texts/json.hpp"

namespace regista::report {
namespace {

using Json = nlohmann::ordered_json;

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

// Values stand in the order of "parameters".
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
  Json all = Json::array();
  for (const TunedValue& each : tuned_values(view))
    all.push_back({{"path", view.plan.parameters[each.parameter].path},
                   {"base", each.base},
                   {"tuned", each.tuned},
                   {"at_end", each.at == RangeEnd::none    ? Json(nullptr)
                              : each.at == RangeEnd::lower ? Json("lower")
                                                           : Json("upper")}});
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

Json tuning_data(const TuningView& view) {
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
      {"compared", nullptr},  // kept for programs that read earlier reports
      {"forfeits",
       {{"listed", forfeits_json(tally.forfeits, forfeit_words(plan), "by")}, {"unlisted", tally.forfeits.unlisted()}}},
      {"unplayed", unplayed_json(tally.unplayed_pairs, tally.remarks)},
      {"tuned_file", view.tuned_file.empty() ? Json(nullptr) : Json(view.tuned_file)}};
}

}  // namespace regista::report
