// SPDX-License-Identifier: MIT
#include "study/tuning/tuning_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "config/overlay.hpp"
#include "config/parse.hpp"
#include "config/scalar.hpp"
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

Algorithm algorithm_of(const Json& json) {
  const auto found = algorithm_named(json.get<std::string>());
  if (!found) throw std::out_of_range("algorithm");
  return *found;
}

bool sound(const Parameter& each) {
  return each.least <= each.start && each.start <= each.most && (!each.log_scale || each.fixed() || each.least > 0.0);
}

// Its budget is enough for its first round, the base team's evaluation aside.
bool can_search(const TuningPlan& plan, Algorithm algorithm) {
  const std::uint64_t population = has_population(algorithm) ? plan.population : 0;
  return plan.evaluations(algorithm) >
         least_evaluations(algorithm, plan.free_parameters(), static_cast<std::size_t>(population));
}

bool sound_weights(const std::vector<TuningOpponent>& opponents) {
  double sum = 0.0;
  for (const TuningOpponent& each : opponents) {
    if (!(each.weight > 0.0)) return false;
    sum += each.weight;
  }
  return std::abs(sum - 1.0) < 1e-9;
}

// What the course of a tuning relies on; upper bounds are those of its document.
bool sound(const TuningPlan& plan) {
  constexpr std::uint64_t most_seed = std::uint64_t{1} << 31, most_pairs = 10'000'000;
  const auto within = [](std::uint64_t least, std::uint64_t count, std::uint64_t most) {
    return least <= count && count <= most;
  };
  return plan.free_parameters() > 0 && !plan.objective.terms.empty() && sound_weights(plan.opponents) &&
         plan.most_goals >= 1 && plan.seed < most_seed && within(1, plan.pairs, most_pairs) &&
         within(plan.pairs, plan.search_pairs, most_pairs) && within(0, plan.population, 10'000) &&
         within(1, plan.repeats, 1024) && within(1, plan.finalists, 64) && within(1, plan.candidates, plan.finalists) &&
         within(1, plan.selection_pairs, most_pairs) && within(0, plan.verification_pairs, most_pairs) &&
         within(0, plan.slice_points, 101) && within(0, plan.slice_pairs, 10'000) && plan.confidence > 0.0 &&
         plan.confidence < 1.0 &&
         std::ranges::all_of(plan.parameters, [](const Parameter& each) { return sound(each); }) &&
         (plan.compares() ? std::ranges::all_of(plan.compared, [&](Algorithm each) { return can_search(plan, each); })
                          : can_search(plan, plan.algorithm));
}

// Everything a plan says beside who plays, with the words for it: what a comparison of two plans goes through.
std::vector<std::pair<std::string, std::string>> said(const TuningPlan& plan) {
  std::vector<std::pair<std::string, std::string>> out;
  const auto add = [&](const char* what, const auto& value) { out.emplace_back(what, fmt::format("{}", value)); };
  const auto list = [&](const char* what, const std::vector<std::string>& values) {
    out.emplace_back(what, fmt::format("{}", fmt::join(values, ", ")));
  };
  std::vector<std::string> paths, opponents, compared;
  for (const Parameter& each : plan.parameters) {
    paths.push_back(fmt::format("{} {} to {} from {}{}{}", each.path, each.least, each.most, each.start,
                                each.integer ? ", whole" : "", each.log_scale ? ", logarithmic" : ""));
  }
  for (const TuningOpponent& each : plan.opponents) {
    opponents.push_back(fmt::format("{} ({})", each.label, each.weight));
  }
  for (const Algorithm each : plan.compared) compared.emplace_back(name(each));
  add("the tuning", plan.name);
  list("the parameters", paths);
  list("the opponents", opponents);
  add("the objective", (plan.objective.minimise ? "minimise " : "maximise ") + in_words(plan.objective));
  add("the algorithm", name(plan.algorithm));
  list("--compare", compared);
  add("--repeats", plan.repeats);
  add("the seed", plan.seed);
  add("pairs of the search", plan.search_pairs);
  add("pairs for each evaluation", fmt::format("{}{}", plan.pairs, plan.pairs_for_all ? "" : " where replicated"));
  add("the minutes of the search", plan.minutes ? fmt::format("{}", *plan.minutes) : std::string("none"));
  add("the population", plan.population);
  add("the finalists", plan.finalists);
  add("pairs of the selection", plan.selection_pairs);
  add("the candidates", plan.candidates);
  add("pairs of the verification", plan.verification_pairs);
  add("verification.against", plan.head_to_head ? "base" : "opponents");
  add("the confidence", plan.confidence);
  add("points of the slices", plan.slice_points);
  add("pairs of the slices", plan.slice_pairs);
  add("--processor-seconds", plan.limits.processor_seconds);
  add("--memory", plan.limits.memory >> 20);
  return out;
}

}  // namespace

const char* name(TuningStage stage) {
  constexpr std::array names{"search", "selection", "verification", "slices"};
  return names[static_cast<std::size_t>(stage)];
}

std::size_t TuningPlan::free_parameters() const {
  return static_cast<std::size_t>(std::ranges::count(parameters, false, &Parameter::fixed));
}

ParameterValues start_values(const TuningPlan& plan) {
  ParameterValues out;
  for (const Parameter& each : plan.parameters) out.push_back(each.start);
  return out;
}

Eigen::VectorXd point_of(const TuningPlan& plan, const ParameterValues& values) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(plan.free_parameters()));
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
    if (!plan.parameters[i].fixed()) out[next++] = share_of(plan.parameters[i], values[i]);
  }
  return out;
}

ParameterValues values_of(const TuningPlan& plan, const Eigen::VectorXd& point) {
  ParameterValues out;
  Eigen::Index next = 0;
  for (const Parameter& each : plan.parameters) {
    // The start itself, whatever rounding would make of it.
    if (each.fixed()) {
      out.push_back(each.least);
      continue;
    }
    const double share = point[next++];
    out.push_back(share == share_of(each, each.start) ? each.start : value_at_share(each, share));
  }
  return out;
}

static config::Node document_of(const TuningPlan& plan) {
  try {
    return config::parse_text(plan.document, plan.team);
  } catch (const config::Error& error) {
    throw std::invalid_argument(fmt::format("its plan is damaged: {}", error.what()));
  }
}

TunedDocument::TunedDocument(const TuningPlan& plan) : plan_(plan) {
  const config::Node document = document_of(plan);
  std::vector<std::size_t> lines{0};  // where they begin
  for (std::size_t i = 0; i < plan.document.size(); ++i) {
    if (plan.document[i] == '\n') lines.push_back(i + 1);
  }
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
    const config::Node value = config::value_at(document, plan.parameters[i].path);
    if (value.kind() != config::Node::Kind::scalar) throw std::invalid_argument("its plan is damaged");
    const config::Location& where = value.where();
    const std::size_t begin =
        lines.at(static_cast<std::size_t>(where.line - 1)) + static_cast<std::size_t>(where.column - 1);
    const std::string& text = value.text();
    const bool as_it_stands = begin < plan.document.size() && plan.document.compare(begin, text.size(), text) == 0;
    if (text.empty() || value.quoted() || !as_it_stands) throw std::invalid_argument("its plan is damaged");
    places_.push_back({begin, text.size(), i});
  }
  std::ranges::sort(places_, std::greater(), &Place::begin);
  if (std::ranges::adjacent_find(places_, {}, &Place::begin) != places_.end()) {
    throw std::invalid_argument("its plan is damaged");
  }
}

std::string TunedDocument::with(const ParameterValues& values) const {
  std::string out = plan_.document;
  for (const Place& each : places_) {
    out.replace(each.begin, each.length, text_of(plan_.parameters[each.parameter], values[each.parameter]));
  }
  return out;
}

std::vector<std::string> settings_of(const TuningPlan& plan, const ParameterValues& values) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
    out.push_back(fmt::format("{}={}", plan.parameters[i].path, text_of(plan.parameters[i], values[i])));
  }
  return out;
}

double score_of(const TuningObjective& objective, double value) { return objective.minimise ? -value : value; }
double value_of(const TuningObjective& objective, double score) { return objective.minimise ? -score : score; }

std::string in_words(const TuningObjective& objective) {
  if (objective.terms.size() == 1 && objective.terms.front().weight == 1.0) return objective.terms.front().measure;
  std::string out;
  for (const ObjectiveTerm& each : objective.terms) {
    const char* const sign = out.empty() ? (each.weight < 0.0 ? "-" : "") : each.weight < 0.0 ? " - " : " + ";
    out += fmt::format("{}{} {}", sign, std::abs(each.weight), each.measure);
  }
  return out;
}

std::optional<ScoreBounds> score_bounds(const TuningPlan& plan) {
  ScoreBounds out{0.0, 0.0};
  for (const ObjectiveTerm& each : plan.objective.terms) {
    double least = 0.0, most = 1.0;  // of points
    if (each.measure == "goal_difference") {
      most = plan.most_goals;
      least = -most;
    } else if (each.measure != "points") {
      return std::nullopt;
    }
    const double weight = score_of(plan.objective, each.weight);
    out.low += std::min(weight * least, weight * most);
    out.high += std::max(weight * least, weight * most);
  }
  return out;
}

std::uint64_t most_matches(const TuningPlan& plan, TuningStage stage) {
  const std::uint64_t pair = plan.matches_of_pair();
  if (plan.compares()) {
    const std::uint64_t searches = plan.compared.size() * plan.repeats;
    if (stage == TuningStage::search) return searches * plan.search_pairs * pair;
    return stage == TuningStage::verification ? (searches + 1) * plan.verification_pairs * pair : 0;
  }
  switch (stage) {
    case TuningStage::search:
      return plan.evaluations(plan.algorithm) * plan.pairs_of(plan.algorithm) * pair;
    case TuningStage::selection:
      return plan.finalists * plan.selection_pairs * pair;
    case TuningStage::verification:
      return plan.verification_pairs * (plan.head_to_head ? 2 * plan.candidates : (plan.candidates + 1) * pair);
    case TuningStage::slices:
      return plan.slice_points == 0 ? 0 : (plan.slice_points * plan.free_parameters() + 1) * plan.slice_pairs * pair;
  }
  return 0;
}

std::uint64_t most_matches(const TuningPlan& plan) {
  std::uint64_t sum = 0;
  for (const TuningStage stage :
       {TuningStage::search, TuningStage::selection, TuningStage::verification, TuningStage::slices}) {
    sum += most_matches(plan, stage);
  }
  return sum;
}

std::string to_json(const TuningPlan& plan) {
  Json parameters = Json::array(), opponents = Json::array(), compared = Json::array();
  for (const Parameter& each : plan.parameters) parameters.push_back(json_of(each));
  for (const TuningOpponent& each : plan.opponents) opponents.push_back(json_of(each));
  for (const Algorithm each : plan.compared) compared.push_back(name(each));
  return Json{{"study", tuning_study},
              {"version", plan_version},
              {"name", plan.name},
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
              {"confidence", plan.confidence},
              {"slice_points", plan.slice_points},
              {"slice_pairs", plan.slice_pairs},
              {"compared", compared},
              {"repeats", plan.repeats},
              {"limits", json_of(plan.limits)},
              {"folder", plan.folder},
              {"file", plan.file},
              {"overrides", plan.overrides}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);  // names of files may be anything, JSON must be UTF-8
}

TuningPlan tuning_plan_from_json(const std::string& text) {
  return read_plan(text, tuning_study, plan_version, [](const Json& json) {
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
    json.at("most_goals").get_to(plan.most_goals);
    json.at("seed").get_to(plan.seed);
    plan.algorithm = algorithm_of(json.at("algorithm"));
    json.at("pairs").get_to(plan.pairs);
    json.at("search_pairs").get_to(plan.search_pairs);
    json.at("pairs_for_all").get_to(plan.pairs_for_all);
    if (!json.at("minutes").is_null()) plan.minutes = json.at("minutes").get<double>();
    json.at("population").get_to(plan.population);
    json.at("finalists").get_to(plan.finalists);
    json.at("selection_pairs").get_to(plan.selection_pairs);
    json.at("candidates").get_to(plan.candidates);
    json.at("head_to_head").get_to(plan.head_to_head);
    json.at("verification_pairs").get_to(plan.verification_pairs);
    json.at("confidence").get_to(plan.confidence);
    json.at("slice_points").get_to(plan.slice_points);
    json.at("slice_pairs").get_to(plan.slice_pairs);
    for (const Json& each : json.at("compared")) plan.compared.push_back(algorithm_of(each));
    json.at("repeats").get_to(plan.repeats);
    plan.limits = limits_of(json.at("limits"));
    json.at("folder").get_to(plan.folder);
    json.at("file").get_to(plan.file);
    json.at("overrides").get_to(plan.overrides);
    if (!sound(plan)) throw std::out_of_range("a number that no tuning has");
    return plan;
  });
}

std::vector<std::string> differences(const TuningPlan& before, const TuningPlan& now) {
  std::vector<std::string> out;
  const auto then = said(before), today = said(now);
  for (std::size_t i = 0; i < today.size(); ++i) {
    if (then[i].second == today[i].second) continue;
    out.push_back(fmt::format("{}: was {}, now {}", today[i].first, then[i].second, today[i].second));
  }
  if (!out.empty()) return out;  // else the same opponents, which can be compared one by one
  const auto add = [&](const std::string& whose, std::span<const campaign::Input> old,
                       std::span<const campaign::Input> fresh) {
    for (const std::string& each : campaign::differences(old, fresh)) {
      const std::string line = whose + each;
      if (std::ranges::find(out, line) == out.end()) out.push_back(line);
    }
  };
  for (std::size_t i = 0; i < now.opponents.size(); ++i) {
    const campaign::Job &old = before.opponents[i].jobs[0], &fresh = now.opponents[i].jobs[0];
    add("the team: ", old.home_inputs, fresh.home_inputs);
    add(now.opponents[i].label + ": ", old.away_inputs, fresh.away_inputs);
    add("", old.common_inputs, fresh.common_inputs);
    add("", before.opponents[i].jobs[1].common_inputs, now.opponents[i].jobs[1].common_inputs);
  }
  for (const std::size_t side : {0u, 1u}) {
    const campaign::Job &old = before.base.jobs[side], &fresh = now.base.jobs[side];
    add("the team: ", old.home_inputs, fresh.home_inputs);
    add("the team: ", old.away_inputs, fresh.away_inputs);
    add("", old.common_inputs, fresh.common_inputs);
  }
  const auto scenes = [](const TuningPlan& plan) {
    std::vector<campaign::Input> all;
    for (const Opening& opening : plan.openings) all.push_back(opening.input);
    return all;
  };
  add("", scenes(before), scenes(now));
  if (out.empty() && scenes(before) != scenes(now)) out.push_back("the openings come in another order");
  return out;
}

}  // namespace regista::study
