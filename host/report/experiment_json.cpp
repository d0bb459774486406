// SPDX-License-Identifier: MIT
// An experiment as JSON.

#include "report/experiment.hpp"
#include "report/match_remarks.hpp"
#include "report/number_json.hpp"
#include "report/packets_spent.hpp"
#include "study/settings.hpp"
#include "texts/json.hpp"

namespace regista::report {
namespace {

using Json = nlohmann::ordered_json;

Json condition(const study::ExperimentPlan& plan, std::size_t index) {
  const study::Condition& each = plan.conditions[index];
  Json out{{"arm", plan.asked.arms[each.arm].name}};
  if (plan.swept()) out["value"] = plan.value(each.value);
  return out;
}

Json measure_json(const ExperimentView& view, std::size_t measure) {
  const study::ExperimentPlan& plan = view.plan;
  Json conditions = Json::array(), differences = Json::array();
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    Json each = condition(plan, i);
    each.update(json_of(view.course.mean(i, measure)));
    const study::MeanEstimate per_match = study::mean_of(view.course.per_match(i, measure), plan.asked.confidence);
    each["per_match"] = per_match.pairs > 0 ? Json(per_match.mean) : Json(nullptr);
    conditions.push_back(each);
  }
  for (const study::Comparison& comparison : plan.comparisons()) {
    Json each{{"first", condition(plan, comparison.first)}, {"second", condition(plan, comparison.second)}};
    each.update(json_of(view.course.difference(comparison, measure)));
    differences.push_back(each);
  }
  return {{"measure", plan.measures[measure]},
          {"unit", study::unit_of(plan.measures[measure])},
          {"conditions", conditions},
          {"differences", differences}};
}

Json primary_json(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  if (plan.primary().empty()) return nullptr;
  Json comparisons = Json::array();
  for (const study::Finding& finding : study::findings(plan, view.course)) {
    Json each{{"first", condition(plan, finding.comparison.first)},
              {"second", condition(plan, finding.comparison.second)}};
    each.update(json_of(finding.difference));
    each["p"] = json_or_null(finding.p);
    each["p_by"] = finding.p ? Json(study::name(finding.by)) : Json(nullptr);
    each["p_holm"] = json_or_null(finding.adjusted);
    each["found"] = finding.found;
    each["unplayed_pairs"] = finding.unplayed_pairs;
    each["verdict_prevented"] = finding.prevented;
    each["equal_by_construction"] = study::equal_conditions(plan, finding.comparison);
    comparisons.push_back(each);
  }
  return {{"measure", plan.primary()}, {"test", study::name(plan.test())}, {"comparisons", comparisons}};
}

}  // namespace

std::string experiment_json(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  Json out;
  out["played"] = played_json(what_was_played(plan));
  out["experiment"] = plan.asked.name;
  out["question"] = plan.asked.question;
  Json arms = Json::array();
  for (const config::Experiment::Arm& arm : plan.asked.arms) {
    arms.push_back({{"name", arm.name},
                    {"team", arm.team.empty() ? plan.asked.team : arm.team},
                    {"set", study::as_typed(study::settings_of(arm.set, "set"))}});
  }
  out["arms"] = arms;
  out["opponent"] = plan.asked.opponent;
  out["sweep"] = plan.swept() ? Json{{"path", plan.sweep()}, {"values", plan.value_texts()}} : Json(nullptr);
  out["pairs"] = plan.pairs;
  out["first_seed"] = plan.first_seed();
  out["openings"] = plan.openings.size();
  out["matches"] = view.course.taken();
  out["planned_matches"] = plan.matches();
  out["complete"] = view.course.complete();
  out["confidence"] = plan.asked.confidence;
  Json played = Json::array();
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    Json each = condition(plan, i);
    each["playing_seconds"] = view.course.playing_seconds(i);
    const auto of_a_match = view.course.playing_seconds_of_a_match(i);
    each["playing_minutes_of_a_match"] = of_a_match ? Json(*of_a_match / 60.0) : Json(nullptr);
    each["forfeits"] = view.course.forfeits().of_team()[i];
    each["unplayed_pairs"] = view.course.unplayed_pairs(i);
    each["packets_of_short_games"] = packets_json(view.course.packets(i));
    played.push_back(each);
  }
  out["conditions"] = played;
  Json measures = Json::array();
  for (std::size_t i = 0; i < plan.measures.size(); ++i) measures.push_back(measure_json(view, i));
  out["measures"] = measures;
  out["primary"] = primary_json(view);
  Json findings = Json::array({experiment_headline(view)});
  for (const std::string& each : finding_sentences(view)) findings.push_back(each);
  out["findings"] = findings;
  out["notes"] = experiment_notes(view);
  Json forfeits = Json::array();
  for (const study::Forfeits& each : view.course.forfeits().listed()) {
    const bool opponent = each.team == plan.conditions.size();
    forfeits.push_back({{"by", opponent ? std::string("opponent") : label(plan, each.team)},
                        {"plugin", each.failure.plugin},
                        {"call", each.failure.call},
                        {"what", each.failure.what},
                        {"matches", each.count},
                        {"again", view.again(each.first_match)}});
  }
  out["forfeits"] = forfeits;
  out["unplayed"] = unplayed_json(view.course.unplayed_pairs(), view.course.remarks());
  add_doubts(view.course.remarks(), out);
  add_notes(view.course.remarks(), out);
  return out.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace regista::report
