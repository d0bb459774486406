// SPDX-License-Identifier: MIT
// A tuning as JSON.
#include <algorithm>

#include "report/packets_spent.hpp"
#include "report/tuning_json_parts.hpp"
#include "report/tuning_sentences.hpp"
#include "texts/json.hpp"

namespace regista::report {
namespace {

using Json = nlohmann::ordered_json;

// In the order of "parameters".
Json values(const study::ParameterValues& of) { return Json(of); }

Json budget(const study::TuningPlan& plan) {
  Json out{{"evaluations", plan.evaluations()}, {"pairs_of_an_evaluation", plan.pairs_of_evaluation()}};
  out.update(budget_json(plan));
  return out;
}

Json played(const study::TuningPlan& plan, const study::PlayedScore& of) {
  Json out = json_of(of_objective(plan.objective, of.score));
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
                          {"interval", any ? json_of(each.difference.interval) : Json(nullptr)},
                          {"p", each.p},
                          {"p_holm", each.adjusted},
                          {"search_less_verified", json_of_score(view.plan.objective, each.optimism)},
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
                        {"objective", json_of(of_objective(view.plan.objective, each.score))},
                        {"difference", json_of(of_objective(view.plan.objective, each.difference))}});
    }
    out.push_back({{"path", view.plan.parameters[slice.parameter].path},
                   {"importance", slice.p ? Json(slice.importance) : Json(nullptr)},
                   {"p", json_or_null(slice.p)},
                   {"more_than_chance", more_than_chance(slice)},
                   {"points", points}});
  }
  return out;
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

}  // namespace

std::string tuning_json(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const TuningVerdict verdict = tuning_verdict(view);
  Json out = problem_json(plan);
  out["played"] = played_json(what_was_played(plan));
  out["algorithm"] = name(plan.algorithm());
  out["seed"] = plan.seed();
  out["confidence"] = plan.confidence();
  out["budget"] = budget(plan);
  out["complete"] = !view.record.stage;
  out["stage"] = view.record.stage ? Json(name(*view.record.stage)) : Json(nullptr);
  out["matches"] = matches(view);
  out["verdict"] = verdict.headline;
  out["findings"] = verdict.beside;
  out["search"] = search_json(view);
  out["finalists"] = finalists(view);
  out["verification"] = verification(view);
  out["verified"] = view.record.verified();
  out["tuned"] = tuned(view);
  out["slices"] = slices(view);
  out["compared"] = nullptr;  // kept for programs that read earlier reports
  out.update(tally_json(plan, view.record.tally));
  out["tuned_file"] = view.tuned_file.empty() ? Json(nullptr) : Json(view.tuned_file);
  return out.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace regista::report
