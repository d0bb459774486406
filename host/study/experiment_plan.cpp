// SPDX-License-Identifier: MIT
#include "study/experiment_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "campaign/inputs.hpp"
#include "study/plan_differences.hpp"
#include "study/plan_fields.hpp"

namespace regista::study {
namespace {

constexpr int experiment_plan_version = 1;

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

// Found by their arguments: not in the namespace above.

static bool named(const std::string& text, PairTest& test) {
  for (const PairTest each : {PairTest::paired_t, PairTest::sign_flip}) {
    if (text != name(each)) continue;
    test = each;
    return true;
  }
  return false;
}

static PlanJson json_of(const Comparison& comparison) { return {comparison.first, comparison.second}; }
static void read(const PlanJson& json, Comparison& comparison) {
  read(json.at(0), comparison.first);
  read(json.at(1), comparison.second);
}

template <Like<Arm> Value, class Visit>
static void fields(Value& arm, Visit& visit) {
  visit("name", arm.name);
  visit("file", arm.file);
  visit("settings", arm.settings);
}

template <Like<Condition> Value, class Visit>
static void fields(Value& condition, Visit& visit) {
  visit("arm", condition.arm);
  visit("value", condition.value);
  visit("home", condition.jobs[0]);
  visit("away", condition.jobs[1]);
}

template <Like<ExperimentPlan> Plan, class Visit>
static void fields(Plan& plan, Visit& visit) {
  visit("name", plan.name, "the experiment");
  visit("question", plan.question);
  visit("arms", plan.arms, "the arms", [](const std::vector<Arm>& arms) {
    std::vector<std::string> names;
    for (const Arm& each : arms) names.push_back(each.name);
    return in_words(names);
  });
  visit("opponent", plan.opponent);
  visit("sweep", plan.sweep, "the path of the sweep");
  visit("values", plan.values, "the values of the sweep");
  visit("conditions", plan.conditions);
  visit("openings", plan.openings);
  visit("pairs", plan.pairs, "the number of matches for each arm",
        [](std::uint64_t pairs) { return std::to_string(2 * pairs); });
  visit("first_seed", plan.first_seed, "the first seed");
  visit("measures", plan.measures, "the measures");
  visit("primary", plan.primary);
  visit("comparisons", plan.comparisons, "what it compares",
        [&plan](const std::vector<Comparison>& comparisons) { return in_words(plan, comparisons); });
  visit("test", plan.test, "the test", [&plan](PairTest) { return in_words(plan); });
  visit("confidence", plan.confidence, "the confidence");
  visit.inner("limits", [&plan](auto& inner) { limit_fields(plan.limits, inner); });
  visit("folder", plan.folder);
  visit("file", plan.file);
  visit("overrides", plan.overrides);
  visit("documents", plan.documents);
}

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

std::string to_json(const ExperimentPlan& plan) { return plan_text(experiment_study, experiment_plan_version, plan); }

ExperimentPlan experiment_plan_from_json(const std::string& text) {
  return plan_of<ExperimentPlan>(experiment_study, experiment_plan_version, text,
                                 [](const ExperimentPlan& plan) { return sound(plan); });
}

std::vector<std::string> differences(const ExperimentPlan& before, const ExperimentPlan& now) {
  std::vector<std::string> out = field_differences(before, now);
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
