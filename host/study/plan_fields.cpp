// SPDX-License-Identifier: MIT
#include "study/plan_fields.hpp"

#include "config/experiment.hpp"
#include "config/overlay.hpp"
#include "config/tournament.hpp"
#include "config/tuning.hpp"

namespace regista::study {
namespace {

using Json = nlohmann::ordered_json;
using Texts = std::vector<std::string>;

config::Node map_of(const Texts& overrides) {
  std::vector<config::Node::Entry> out;
  for (const std::string& each : overrides) {
    const config::Override setting(each);
    std::erase_if(out, [&](const config::Node::Entry& other) { return other.key == setting.path; });
    out.push_back({setting.path, {}, setting.value});
  }
  return out.empty() ? config::Node() : config::Node::map(std::move(out), {});
}

// The settings of a plan of version 1. limits: the limits in the plan. job: the job of any of the plan's matches.
config::MatchSettings settings_of(const Json& plan, const Json& limits, const campaign::Job& job) {
  config::MatchSettings out;
  out.seeds = config::Seeds::consecutive;
  out.rules = job.rules;
  out.robot = job.robot;
  for (const Json& each : plan.at("openings")) out.openings.push_back({each.at("file").get<std::string>(), {}});
  if (!job.limit.empty()) out.limit = std::stod(job.limit);
  out.limits.processor_seconds = limits.at("processor_seconds").get<int>();
  out.limits.memory = static_cast<int>(limits.at("memory").get<std::uint64_t>() >> 20);
  const int wall = static_cast<int>(limits.at("wall_seconds").get<double>());
  if (wall != 10 * out.limits.processor_seconds + 100) out.limits.wall_seconds = wall;
  out.limits.match_seconds = static_cast<int>(limits.value("match_wall_seconds", 1800.0));
  if (limits.value("isolation", "") == "always") out.isolation = config::Isolation::always;
  out.play_twice = limits.value("plays", "") != "once";
  out.allow_shared_memory = limits.contains("shared_memory");
  return out;
}

// Returns the overrides of a match (own team at home). Each path is translated to the path in the study's document.
Texts own_settings(const campaign::Job& at_home) {
  Texts out;
  for (const std::string& each : at_home.overrides) {
    std::string& text = out.emplace_back(each);
    for (const auto& [before, now] : {std::pair{"home_disturbance.", "disturbance."},
                                      {"away_disturbance.", "opponent_disturbance."},
                                      {"home.", ""},
                                      {"away.", "opponent."}}) {
      if (!each.starts_with(before)) continue;
      text.replace(0, std::string_view(before).size(), now);
      break;
    }
  }
  return out;
}

Json inputs_of(const Json& jobs) {
  return {{"home", jobs.at("home_inputs")}, {"away", jobs.at("away_inputs")}, {"common", jobs.at("common_inputs")}};
}

// Returns JSON with the members that plans of all kinds have, and with the document.
template <class Document>
Json begun(const Json& plan, const Document& asked, const Texts& plugins) {
  return {{"document", config::document_text(asked)},
          {"openings", plan.at("openings")},
          {"folder", plan.at("folder")},
          {"plugins", plugins}};
}

}  // namespace

Json tournament_of_version_1(const Json& plan) {
  config::Tournament asked;
  asked.name = plan.value("name", "");
  if (asked.name.empty()) asked.name = "tournament";
  asked.question = plan.value("question", "");
  Json teams = Json::array();
  for (const Json& each : plan.at("teams")) {
    asked.teams.push_back({each.at("file").get<std::string>(), each.value("disturbance", "")});
    teams.push_back({{"label", each.at("label")},
                     {"inputs", each.at("inputs")},
                     {"disturbances", Json::parse(each.value("disturbances", "[]"))}});
  }
  if (plan.at("format") == "gauntlet") asked.format = config::Tournament::Format::gauntlet;
  asked.pairs = plan.at("pairs").get<int>();
  asked.seed = plan.at("first_seed").get<std::int64_t>();
  const Json& test = plan.at("objective");
  if (test.at("test") != "none") {
    config::TournamentTest& out = asked.test.emplace();
    out.alpha = test.at("alpha").get<double>();
    if (test.at("test") == "value") {
      out.metric = test.at("value").get<std::string>();
    } else {
      out.elo = {test.at("elo0").get<double>(), test.at("elo1").get<double>()};
      out.beta = test.at("beta").get<double>();
      if (test.at("model") == "logistic") out.model = config::TournamentTest::Model::logistic;
    }
  }
  asked.failures_in_a_row = plan.at("failures_in_a_row").get<int>();
  const campaign::Job common = campaign::job_from_json(plan.at("common").dump());
  asked.disturbance = common.disturbance;
  asked.settings = settings_of(plan, plan, common);
  asked.settings.set = map_of(common.overrides);
  Json out = begun(plan, asked, common.plugins);
  out["teams"] = teams;
  out["most_goals"] = plan.at("most_goals");
  if (plan.contains("pairs_before")) out["pairs_before"] = plan.at("pairs_before");
  out["common_inputs"] = plan.at("common_inputs");
  return out;
}

Json experiment_of_version_1(const Json& plan) {
  config::Experiment asked;
  asked.name = plan.at("name").get<std::string>();
  asked.question = plan.at("question").get<std::string>();
  Texts of_arm;  // settings of the first arm and of the sweep, which do not apply to all arms
  for (const Json& each : plan.at("arms")) {
    const auto settings = each.at("settings").get<Texts>();
    asked.arms.push_back(
        {each.at("name").get<std::string>(), each.at("file").get<std::string>(), map_of(settings), {}});
    if (asked.arms.size() == 1) of_arm = settings;
  }
  asked.opponent = plan.at("opponent").get<std::string>();
  if (const auto path = plan.at("sweep").get<std::string>(); !path.empty()) {
    config::Experiment::Sweep& sweep = asked.sweep.emplace();
    sweep.path = path;
    for (const Json& each : plan.at("values")) sweep.values.push_back(config::parse_value(each.get<std::string>(), {}));
    of_arm.push_back(path + '=' + plan.at("values").at(0).get<std::string>());
  }
  asked.matches = static_cast<int>(2 * plan.at("pairs").get<std::uint64_t>());
  asked.seed = plan.at("first_seed").get<std::int64_t>();
  for (const Json& each : plan.at("measures"))
    asked.measures.push_back(config::Node::scalar(each.get<std::string>(), true, {}));
  if (const auto measure = plan.at("primary").get<std::string>(); !measure.empty()) {
    config::ExperimentPrimary& primary = asked.primary.emplace();
    primary.measure = measure;
    if (plan.at("test") == "sign_flip") primary.test = config::PairedTest::sign_flip;
    for (const Json& each : plan.at("comparisons")) {
      const auto first = each.at(0).get<std::size_t>(), second = each.at(1).get<std::size_t>();
      if (first >= asked.arms.size() || second >= asked.arms.size()) break;  // later entries are for other swept values
      const auto name = [&](std::size_t arm) { return config::Node::scalar(asked.arms[arm].name, true, {}); };
      primary.compare.push_back(config::Node::sequence({name(first), name(second)}, {}));
    }
    if (asked.arms.size() == 1) primary.compare.clear();
  }
  asked.confidence = plan.at("confidence").get<double>();
  const campaign::Job at_home = campaign::job_from_json(plan.at("conditions").at(0).at("home").dump());
  asked.disturbance = at_home.home_disturbance;
  asked.opponent_disturbance = at_home.away_disturbance;
  asked.settings = settings_of(plan, plan.at("limits"), at_home);
  Texts of_all = own_settings(at_home);
  for (const std::string& each : of_arm) {
    if (const auto found = std::ranges::find(of_all, each); found != of_all.end()) of_all.erase(found);
  }
  asked.settings.set = map_of(of_all);
  Json out = begun(plan, asked, at_home.plugins);
  out["conditions"] = Json::array();
  for (const Json& each : plan.at("conditions"))
    out["conditions"].push_back(Json::array({inputs_of(each.at("home")), inputs_of(each.at("away"))}));
  for (const char* const key : {"pairs", "measures", "documents"}) out[key] = plan.at(key);
  return out;
}

Json tuning_of_version_1(const Json& plan) {
  if (plan.contains("compared") && plan.at("compared") != Json::array())
    throw std::invalid_argument("it compares search algorithms, which this version does not read");
  config::Tuning asked;
  asked.name = plan.at("name").get<std::string>();
  asked.question = plan.at("question").get<std::string>();
  asked.team = plan.at("team").get<std::string>();
  Json opponents = Json::array();
  const auto opponent_of = [](const Json& each) {
    return Json{
        {"label", each.at("label")}, {"home", inputs_of(each.at("home"))}, {"away", inputs_of(each.at("away"))}};
  };
  for (const Json& each : plan.at("opponents")) {
    asked.opponents.push_back({each.at("file").get<std::string>(), each.at("weight").get<double>(), {}});
    opponents.push_back(opponent_of(each));
  }
  for (const Json& each : plan.at("parameters")) {
    config::TunedPath& path = asked.parameters.emplace_back();
    path.pattern = each.at("path").get<std::string>();
    path.range = {each.at("least").get<double>(), each.at("most").get<double>()};
  }
  const Json& objective = plan.at("objective");
  auto& terms = objective.at("minimise").get<bool>() ? asked.objective.minimise : asked.objective.maximise;
  for (const Json& each : objective.at("terms"))
    terms.push_back({each.at("measure").get<std::string>(), each.at("weight").get<double>(), {}});
  asked.seed = plan.at("seed").get<int>();
  const auto count = [&plan](const char* key) { return plan.at(key).get<int>(); };
  const int pair = 2 * static_cast<int>(asked.opponents.size());
  asked.search.algorithm = plan.at("algorithm").get<std::string>();
  asked.search.matches = count("search_pairs") * pair;
  if (!plan.at("minutes").is_null()) asked.search.minutes = plan.at("minutes").get<double>();
  if (plan.at("pairs_for_all").get<bool>()) asked.search.pairs = count("pairs");
  if (count("population") > 0) asked.search.population = count("population");
  asked.selection = {count("finalists"), count("selection_pairs") * pair * count("finalists")};
  config::Tuning::Verification& verification = asked.verification;
  verification.candidates = count("candidates");
  const bool head_to_head = plan.at("head_to_head").get<bool>();
  if (head_to_head) verification.against = config::Tuning::Against::base;
  verification.matches =
      count("verification_pairs") * (head_to_head ? 2 * verification.candidates : pair * (verification.candidates + 1));
  if (plan.at("symmetric").get<bool>()) verification.test = config::Tuning::Test::symmetric;
  verification.confidence = plan.at("confidence").get<double>();
  asked.slices.points = count("slice_points");
  if (asked.slices.points > 0) asked.slices.pairs = count("slice_pairs");
  const campaign::Job at_home = campaign::job_from_json(plan.at("opponents").at(0).at("home").dump());
  asked.disturbance = at_home.home_disturbance;
  asked.opponent_disturbance = at_home.away_disturbance;
  asked.settings = settings_of(plan, plan.at("limits"), at_home);
  asked.settings.set = map_of(own_settings(at_home));
  Json out = begun(plan, asked, at_home.plugins);
  out["team_document"] = plan.at("document");
  out["opponents"] = opponents;
  out["base"] = opponent_of(plan.at("base"));
  for (const char* const key :
       {"parameters", "most_goals", "search_pairs", "pairs", "selection_pairs", "verification_pairs"})
    out[key] = plan.at(key);
  return out;
}

}  // namespace regista::study
