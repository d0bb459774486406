// SPDX-License-Identifier: MIT
// A tuning's plan as JSON, which the file of results keeps.
#include "study/tuning/tuning_plan_json.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "config/json.hpp"
#include "study/plan_json.hpp"

namespace regista::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr int plan_version = 1;

Json json_of(const Parameter& each) {
  return {{"path", each.path},       {"start", each.start},         {"least", each.least}, {"most", each.most},
          {"integer", each.integer}, {"log_scale", each.log_scale}, {"unit", each.unit},   {"doc", each.doc}};
}

Parameter parameter_of(const Json& json) {
  Parameter out;
  json.at("path").get_to(out.path);
  json.at("start").get_to(out.start);
  json.at("least").get_to(out.least);
  json.at("most").get_to(out.most);
  json.at("integer").get_to(out.integer);
  json.at("log_scale").get_to(out.log_scale);
  json.at("unit").get_to(out.unit);
  json.at("doc").get_to(out.doc);
  return out;
}

Json json_of(const TuningOpponent& each) {
  return {{"label", each.label},
          {"file", each.file},
          {"weight", each.weight},
          {"home", Json::parse(campaign::to_json(each.jobs[0]))},
          {"away", Json::parse(campaign::to_json(each.jobs[1]))}};
}

TuningOpponent opponent_of(const Json& json) {
  TuningOpponent out;
  json.at("label").get_to(out.label);
  json.at("file").get_to(out.file);
  json.at("weight").get_to(out.weight);
  out.jobs[0] = campaign::job_from_json(json.at("home").dump());
  out.jobs[1] = campaign::job_from_json(json.at("away").dump());
  return out;
}

Json json_of(const TuningObjective& objective) {
  Json terms = Json::array();
  for (const ObjectiveTerm& each : objective.terms) {
    terms.push_back({{"measure", each.measure}, {"weight", each.weight}});
  }
  return {{"minimise", objective.minimise}, {"terms", terms}};
}

TuningObjective objective_of(const Json& json) {
  TuningObjective out;
  json.at("minimise").get_to(out.minimise);
  for (const Json& each : json.at("terms")) {
    out.terms.push_back({each.at("measure").get<std::string>(), each.at("weight").get<double>()});
  }
  return out;
}

bool sound(const Parameter& each) {
  return each.least <= each.start && each.start <= each.most && (!each.log_scale || each.fixed() || each.least > 0.0);
}

bool sound_weights(const std::vector<TuningOpponent>& opponents) {
  double sum = 0.0;
  for (const TuningOpponent& each : opponents) {
    if (!(each.weight > 0.0)) return false;
    sum += each.weight;
  }
  return std::abs(sum - 1.0) < 1e-9;
}

// What every search of its points relies on; upper bounds are those of its document.
bool sound(const TuningPlan& plan) {
  constexpr std::uint64_t most_seed = std::uint64_t{1} << 31, most_pairs = 10'000'000;
  const auto within = [](std::uint64_t least, std::uint64_t count, std::uint64_t most) {
    return least <= count && count <= most;
  };
  return plan.free_parameters() > 0 && !plan.objective.terms.empty() && sound_weights(plan.opponents) &&
         plan.most_goals >= 1 && plan.seed < most_seed && within(1, plan.pairs, most_pairs) &&
         within(plan.pairs, plan.search_pairs, most_pairs) && within(0, plan.population, 10'000) &&
         within(1, plan.finalists, 64) && within(1, plan.candidates, plan.finalists) &&
         within(1, plan.selection_pairs, most_pairs) && within(0, plan.verification_pairs, most_pairs) &&
         within(0, plan.slice_points, 101) && within(0, plan.slice_pairs, 10'000) && plan.confidence > 0.0 &&
         plan.confidence < 1.0 &&
         std::ranges::all_of(plan.parameters, [](const Parameter& each) { return sound(each); });
}

}  // namespace

Algorithm algorithm_of(const Json& json) {
  const auto found = algorithm_named(json.get<std::string>());
  if (!found) throw std::out_of_range("algorithm");
  return *found;
}

bool can_search(const TuningPlan& plan, Algorithm algorithm) {
  const std::uint64_t population = has_population(algorithm) ? plan.population : 0;
  return plan.evaluations(algorithm) >
         least_evaluations(algorithm, plan.free_parameters(), static_cast<std::size_t>(population));
}

Json json_of(const TuningPlan& plan) {
  Json parameters = Json::array(), opponents = Json::array();
  for (const Parameter& each : plan.parameters) parameters.push_back(json_of(each));
  for (const TuningOpponent& each : plan.opponents) opponents.push_back(json_of(each));
  return Json{{"name", plan.name},
              {"question", plan.question},
              {"team", plan.team},
              {"document", plan.document},
              {"settings", plan.settings},
              {"parameters", parameters},
              {"opponents", opponents},
              {"base", json_of(plan.base)},
              {"objective", json_of(plan.objective)},
              {"openings", json_of(plan.openings)},
              {"most_goals", plan.most_goals},
              {"seed", plan.seed},
              {"algorithm", name(plan.algorithm)},
              {"search_pairs", plan.search_pairs},
              {"pairs", plan.pairs},
              {"pairs_for_all", plan.pairs_for_all},
              {"minutes", plan.minutes ? Json(*plan.minutes) : Json()},
              {"population", plan.population},
              {"finalists", plan.finalists},
              {"selection_pairs", plan.selection_pairs},
              {"candidates", plan.candidates},
              {"head_to_head", plan.head_to_head},
              {"verification_pairs", plan.verification_pairs},
              {"symmetric", plan.symmetric},
              {"confidence", plan.confidence},
              {"slice_points", plan.slice_points},
              {"slice_pairs", plan.slice_pairs},
              {"limits", json_of(plan.limits)},
              {"folder", plan.folder},
              {"file", plan.file},
              {"overrides", plan.overrides}};
}

TuningPlan tuning_plan_of(const Json& json) {
  TuningPlan plan;
  json.at("name").get_to(plan.name);
  json.at("question").get_to(plan.question);
  json.at("team").get_to(plan.team);
  json.at("document").get_to(plan.document);
  json.at("settings").get_to(plan.settings);
  for (const Json& each : json.at("parameters")) plan.parameters.push_back(parameter_of(each));
  for (const Json& each : json.at("opponents")) plan.opponents.push_back(opponent_of(each));
  plan.base = opponent_of(json.at("base"));
  plan.objective = objective_of(json.at("objective"));
  plan.openings = openings_of(json.at("openings"));
  plan.most_goals = static_cast<int>(campaign::whole_number(json.at("most_goals"), INT_MAX));
  plan.seed = campaign::whole_number(json.at("seed"));
  plan.algorithm = algorithm_of(json.at("algorithm"));
  plan.pairs = campaign::whole_number(json.at("pairs"));
  plan.search_pairs = campaign::whole_number(json.at("search_pairs"));
  json.at("pairs_for_all").get_to(plan.pairs_for_all);
  if (!json.at("minutes").is_null()) plan.minutes = json.at("minutes").get<double>();
  plan.population = campaign::whole_number(json.at("population"));
  plan.finalists = campaign::whole_number(json.at("finalists"));
  plan.selection_pairs = campaign::whole_number(json.at("selection_pairs"));
  plan.candidates = campaign::whole_number(json.at("candidates"));
  json.at("head_to_head").get_to(plan.head_to_head);
  plan.verification_pairs = campaign::whole_number(json.at("verification_pairs"));
  json.at("symmetric").get_to(plan.symmetric);
  json.at("confidence").get_to(plan.confidence);
  plan.slice_points = campaign::whole_number(json.at("slice_points"));
  plan.slice_pairs = campaign::whole_number(json.at("slice_pairs"));
  plan.limits = limits_of(json.at("limits"));
  json.at("folder").get_to(plan.folder);
  json.at("file").get_to(plan.file);
  json.at("overrides").get_to(plan.overrides);
  if (!sound(plan)) throw std::out_of_range("a number that no tuning has");
  return plan;
}

std::string to_json(const TuningPlan& plan) {
  Json out{{"study", tuning_study}, {"version", plan_version}};
  out.update(json_of(plan));
  return out.dump(-1, ' ', false,
                  Json::error_handler_t::replace);  // names of files may be anything, JSON must be UTF-8
}

TuningPlan tuning_plan_from_json(const std::string& text) {
  return read_plan(text, tuning_study, plan_version, [](const Json& json) {
    if (holds_comparison_of_before(json)) throw std::invalid_argument("these are results of another study");
    TuningPlan plan = tuning_plan_of(json);
    if (!can_search(plan, plan.algorithm)) throw std::out_of_range("a budget that no tuning has");
    return plan;
  });
}

}  // namespace regista::study
