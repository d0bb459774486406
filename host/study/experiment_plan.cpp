// SPDX-License-Identifier: MIT
#include "study/experiment_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "campaign/inputs.hpp"
#include "config/json.hpp"
#include "study/plan_differences.hpp"
#include "study/plan_json.hpp"

namespace regista::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr int plan_version = 1;

Json json_of(const std::vector<Condition>& conditions) {
  Json out = Json::array();
  for (const Condition& each : conditions) {
    out.push_back({{"arm", each.arm},
                   {"value", each.value},
                   {"home", Json::parse(campaign::to_json(each.jobs[0]))},
                   {"away", Json::parse(campaign::to_json(each.jobs[1]))}});
  }
  return out;
}

Condition condition_of(const Json& json) {
  Condition out;
  json.at("arm").get_to(out.arm);
  json.at("value").get_to(out.value);
  out.jobs[0] = campaign::job_from_json(json.at("home").dump());
  out.jobs[1] = campaign::job_from_json(json.at("away").dump());
  return out;
}

// What the course of an experiment relies on.
bool sound(const ExperimentPlan& plan) {
  if (plan.arms.empty() || plan.values.empty() || plan.pairs == 0 || plan.measures.empty()) return false;
  if (plan.conditions.size() != plan.arms.size() * plan.values.size()) return false;
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    if (plan.condition(plan.conditions[i].arm, plan.conditions[i].value) != i) return false;
  }
  const auto known = [&](const Comparison& each) {
    return each.first < plan.conditions.size() && each.second < plan.conditions.size();
  };
  return std::ranges::all_of(plan.comparisons, known) && plan.confidence > 0.0 && plan.confidence < 1.0 &&
         plan.pairs <= UINT64_MAX / 2 / plan.conditions.size() && plan.first_seed <= UINT64_MAX - (plan.pairs - 1);
}

std::string in_words(const ExperimentPlan& plan, const std::vector<Comparison>& comparisons) {
  std::vector<std::string> out;
  for (const Comparison& each : comparisons) {
    out.push_back(fmt::format("{} and {}", label(plan, each.first), label(plan, each.second)));
  }
  return out.empty() ? "none" : fmt::format("{}", fmt::join(out, "; "));
}

std::string in_words(const ExperimentPlan& plan) {
  return plan.primary.empty() ? "none" : fmt::format("{} of {}", name(plan.test), plan.primary);
}

}  // namespace

const char* name(PairTest test) { return test == PairTest::sign_flip ? "sign_flip" : "paired_t"; }

Trial trial(const ExperimentPlan& plan, std::uint64_t index) {
  const std::size_t openings = std::max<std::size_t>(plan.openings.size(), 1);
  Trial out;
  out.side = static_cast<std::size_t>(index % 2);
  out.condition = static_cast<std::size_t>(index / 2 % plan.conditions.size());
  out.pair = index / 2 / plan.conditions.size();
  out.seed = plan.first_seed + out.pair;
  out.opening = static_cast<std::size_t>(out.pair % openings);
  out.number = (2 * out.condition + out.side) * openings + out.opening;
  return out;
}

campaign::Job job(const ExperimentPlan& plan, const Trial& trial) {
  campaign::Job out = plan.conditions[trial.condition].jobs[trial.side];
  out.seed = trial.seed;
  if (!plan.openings.empty()) start_from(plan.openings[trial.opening], out);
  return out;
}

std::vector<campaign::Store::Fixture> fixtures(const ExperimentPlan& plan) {
  const std::size_t openings = std::max<std::size_t>(plan.openings.size(), 1);
  std::vector<campaign::Store::Fixture> out(2 * plan.conditions.size() * openings);
  for (std::size_t number = 0; number < out.size(); ++number) {
    Trial each;
    each.opening = number % openings;
    each.side = number / openings % 2;
    each.condition = number / openings / 2;
    out[number].job = job(plan, each);
    const campaign::Job& made = out[number].job;
    out[number].key = campaign::fixture_key(made.home_inputs, made.away_inputs, made.common_inputs);
  }
  return out;
}

std::string label(const ExperimentPlan& plan, std::size_t condition) {
  const Condition& each = plan.conditions[condition];
  if (!plan.swept()) return plan.arms[each.arm].name;
  return fmt::format("{} at {}", plan.arms[each.arm].name, plan.values[each.value]);
}

bool equal_conditions(const ExperimentPlan& plan, const Comparison& comparison) {
  const auto key = [&](std::size_t condition, std::size_t side) {
    const campaign::Job& job = plan.conditions[condition].jobs[side];
    return campaign::fixture_key(job.home_inputs, job.away_inputs, job.common_inputs);
  };
  return key(comparison.first, 0) == key(comparison.second, 0) && key(comparison.first, 1) == key(comparison.second, 1);
}

std::string to_json(const ExperimentPlan& plan) {
  Json arms = Json::array(), comparisons = Json::array();
  for (const Arm& arm : plan.arms) {
    arms.push_back({{"name", arm.name}, {"file", arm.file}, {"settings", arm.settings}});
  }
  for (const Comparison& each : plan.comparisons) comparisons.push_back({each.first, each.second});
  return Json{{"study", experiment_study},
              {"version", plan_version},
              {"name", plan.name},
              {"question", plan.question},
              {"arms", arms},
              {"opponent", plan.opponent},
              {"sweep", plan.sweep},
              {"values", plan.values},
              {"conditions", json_of(plan.conditions)},
              {"openings", json_of(plan.openings)},
              {"pairs", plan.pairs},
              {"first_seed", plan.first_seed},
              {"measures", plan.measures},
              {"primary", plan.primary},
              {"comparisons", comparisons},
              {"test", name(plan.test)},
              {"confidence", plan.confidence},
              {"limits", json_of(plan.limits)},
              {"folder", plan.folder},
              {"file", plan.file},
              {"overrides", plan.overrides},
              {"documents", plan.documents}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);  // names of files may be anything, JSON must be UTF-8
}

ExperimentPlan experiment_plan_from_json(const std::string& text) {
  return read_plan(text, experiment_study, plan_version, [](const Json& json) {
    ExperimentPlan plan;
    json.at("name").get_to(plan.name);
    json.at("question").get_to(plan.question);
    for (const Json& each : json.at("arms")) {
      Arm& arm = plan.arms.emplace_back();
      each.at("name").get_to(arm.name);
      each.at("file").get_to(arm.file);
      each.at("settings").get_to(arm.settings);
    }
    json.at("opponent").get_to(plan.opponent);
    json.at("sweep").get_to(plan.sweep);
    json.at("values").get_to(plan.values);
    for (const Json& each : json.at("conditions")) plan.conditions.push_back(condition_of(each));
    plan.openings = openings_of(json.at("openings"));
    json.at("pairs").get_to(plan.pairs);
    json.at("first_seed").get_to(plan.first_seed);
    json.at("measures").get_to(plan.measures);
    json.at("primary").get_to(plan.primary);
    for (const Json& each : json.at("comparisons")) {
      plan.comparisons.push_back({each.at(0).get<std::size_t>(), each.at(1).get<std::size_t>()});
    }
    plan.test = json.at("test") == name(PairTest::sign_flip) ? PairTest::sign_flip : PairTest::paired_t;
    json.at("confidence").get_to(plan.confidence);
    plan.limits = limits_of(json.at("limits"));
    json.at("folder").get_to(plan.folder);
    json.at("file").get_to(plan.file);
    json.at("overrides").get_to(plan.overrides);
    json.at("documents").get_to(plan.documents);
    if (!sound(plan)) throw std::out_of_range("a number that no experiment has");
    return plan;
  });
}

std::vector<std::string> differences(const ExperimentPlan& before, const ExperimentPlan& now) {
  std::vector<std::string> out;
  const auto note = [&](const std::string& what, const auto& then, const auto& today, const char* verb = "was") {
    if (then != today) out.push_back(fmt::format("{} {} {}, now {}", what, verb, then, today));
  };
  const auto lists = [&](const std::string& what, const std::vector<std::string>& then,
                         const std::vector<std::string>& today) {
    note(what, fmt::format("{}", fmt::join(then, ", ")), fmt::format("{}", fmt::join(today, ", ")), "were");
  };
  const auto names = [](const ExperimentPlan& plan) {
    std::vector<std::string> all;
    for (const Arm& arm : plan.arms) all.push_back(arm.name);
    return all;
  };
  note("the experiment", before.name, now.name);
  lists("the arms", names(before), names(now));
  note("the path of the sweep", before.sweep, now.sweep);
  lists("the values of the sweep", before.values, now.values);
  note("the number of matches for each arm", 2 * before.pairs, 2 * now.pairs);
  note("the first seed", before.first_seed, now.first_seed);
  lists("the measures", before.measures, now.measures);
  note("the test", in_words(before), in_words(now));
  note("what it compares", in_words(before, before.comparisons), in_words(now, now.comparisons));
  note("the confidence", before.confidence, now.confidence);
  note("--processor-seconds", before.limits.processor_seconds, now.limits.processor_seconds);
  note("--memory", before.limits.memory >> 20, now.limits.memory >> 20);
  if (!out.empty()) return out;  // else the same conditions, which can be compared one by one
  InputDifferences inputs;
  for (std::size_t i = 0; i < now.conditions.size(); ++i) {
    for (const std::size_t side : {0u, 1u}) {
      const campaign::Job &then = before.conditions[i].jobs[side], &today = now.conditions[i].jobs[side];
      const std::string arm = fmt::format("{}: ", label(now, i));
      inputs.add(arm, side == 0 ? then.home_inputs : then.away_inputs,
                 side == 0 ? today.home_inputs : today.away_inputs);
      inputs.add("the opponent: ", side == 0 ? then.away_inputs : then.home_inputs,
                 side == 0 ? today.away_inputs : today.home_inputs);
      inputs.add("", then.common_inputs, today.common_inputs);
    }
  }
  return std::move(inputs).with_openings(before.openings, now.openings);
}

}  // namespace regista::study
