// SPDX-License-Identifier: MIT
#include "report/tuning_json_parts.hpp"

#include "report/match_remarks.hpp"
#include "report/objective_numbers.hpp"
#include "report/tuning_problem.hpp"
#include "study/measure.hpp"
#include "texts/json.hpp"

namespace regista::report {

using Json = nlohmann::ordered_json;

namespace {

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

Json forfeits(const study::TuningPlan& plan, const study::MatchTally& tally) {
  Json listed = Json::array();
  for (const study::Forfeits& each : tally.forfeits.listed()) {
    listed.push_back({{"by", forfeiter(plan, each.team)},
                      {"plugin", each.failure.plugin},
                      {"call", each.failure.call},
                      {"what", each.failure.what},
                      {"matches", each.count},
                      {"first_match", each.first_match + 1}});
  }
  return {{"listed", listed}, {"unlisted", tally.forfeits.unlisted()}};
}

}  // namespace

Json json_of_score(const study::TuningObjective& objective, const std::optional<double>& score) {
  if (!score) return nullptr;
  return json_number(of_objective(objective, *score));
}

Json problem_json(const study::TuningPlan& plan) {
  Json out;
  out["tuning"] = plan.asked.name;
  out["question"] = plan.asked.question;
  out["team"] = plan.asked.team;
  out["set"] = plan.settings;
  out["objective"] = objective(plan.objective);
  out["parameters"] = parameters(plan);
  out["opponents"] = opponents(plan);
  out["openings"] = plan.openings.size();
  return out;
}

Json budget_json(const study::TuningPlan& plan) {
  Json out;
  out["search_pairs"] = plan.search_pairs;
  out["minutes"] = json_or_null(plan.asked.search.minutes);
  out["finalists"] = plan.finalists();
  out["selection_pairs"] = plan.selection_pairs;
  out["candidates"] = plan.candidates();
  out["verification_pairs"] = plan.verification_pairs;
  out["slice_points"] = plan.slice_points();
  out["slice_pairs"] = plan.slice_pairs();
  return out;
}

Json tally_json(const study::TuningPlan& plan, const study::MatchTally& tally) {
  Json out{{"forfeits", forfeits(plan, tally)}, {"unplayed", unplayed_json(tally.unplayed_pairs, tally.remarks)}};
  add_doubts(tally.remarks, out);
  add_notes(tally.remarks, out);
  return out;
}

}  // namespace regista::report
