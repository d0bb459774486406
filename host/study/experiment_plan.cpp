// SPDX-License-Identifier: MIT
#include "study/experiment_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "campaign/inputs.hpp"
#include "config/documents.hpp"
#include "config/flow.hpp"
#include "match/metric_table.hpp"
#include "study/older_plans.hpp"
#include "study/plan_differences.hpp"
#include "study/plan_fields.hpp"
#include "study/settings.hpp"

namespace regista::study {
namespace {

constexpr int experiment_plan_version = 2;

// What the course of an experiment relies on.
bool sound(const ExperimentPlan& plan) {
  return plan.pairs > 0 && !plan.measures.empty() && plan.conditions.size() == plan.arms() * plan.values() &&
         plan.pairs <= UINT64_MAX / 2 / plan.conditions.size();
}

}  // namespace

const char* name(PairTest test) { return test == PairTest::sign_flip ? "sign_flip" : "paired_t"; }

// Found by their arguments: not in the namespace above.

static PlanJson json_of(const Condition& condition) {
  PlanJson out = PlanJson::array();
  for (const campaign::Job& job : condition.jobs) {
    out.push_back({{"home", json_of(job.home_inputs)},
                   {"away", json_of(job.away_inputs)},
                   {"common", json_of(job.common_inputs)}});
  }
  return out;
}
static void read(const PlanJson& json, Condition& condition) {
  for (std::size_t side = 0; side < 2; ++side) {
    campaign::Job& job = condition.jobs[side];
    read(json.at(side).at("home"), job.home_inputs);
    read(json.at(side).at("away"), job.away_inputs);
    read(json.at(side).at("common"), job.common_inputs);
  }
}

template <Like<ExperimentPlan> Plan, class Visit>
static void fields(Plan& plan, Visit& visit) {
  visit("conditions", plan.conditions);
  visit("openings", plan.openings);
  visit("pairs", plan.pairs);
  visit("measures", plan.measures);
  visit("folder", plan.folder);
  visit("plugins", plan.plugins);
  visit.maybe("program", plan.program);
  visit("documents", plan.documents);
}

std::string ExperimentPlan::value(std::size_t index) const {
  return swept() ? config::flow(asked.sweep->values[index]) : std::string();
}

std::vector<std::string> ExperimentPlan::value_texts() const {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < values(); ++i) out.push_back(value(i));
  return out;
}

std::string ExperimentPlan::primary() const {
  return asked.primary ? std::string(match::without_roles(asked.primary->measure)) : std::string();
}

// Arms at each value; a single arm at each value with the first one.
std::vector<Comparison> ExperimentPlan::comparisons() const {
  std::vector<Comparison> of_arms, out;
  if (arms() == 1) {
    for (std::size_t value = 1; value < values(); ++value) out.push_back({value, 0});
    return out;
  }
  if (asked.primary && !asked.primary->compare.empty()) {
    const auto index = [&](const config::Node& name) {
      const auto found = std::ranges::find(asked.arms, name.text(), &config::Experiment::Arm::name);
      return static_cast<std::size_t>(found - asked.arms.begin());
    };
    for (const config::Node& pair : asked.primary->compare) {
      of_arms.push_back({index(pair.elements()[0]), index(pair.elements()[1])});
    }
  } else {
    for (std::size_t first = 0; first < arms(); ++first) {
      for (std::size_t second = first + 1; second < arms(); ++second) of_arms.push_back({first, second});
    }
  }
  for (std::size_t value = 0; value < values(); ++value) {
    for (const Comparison& each : of_arms) out.push_back({condition(each.first, value), condition(each.second, value)});
  }
  return out;
}

const std::string& team_of(const ExperimentPlan& plan, std::size_t arm) {
  const std::string& own = plan.asked.arms[arm].team;
  return own.empty() ? plan.asked.team : own;
}

void make_jobs(ExperimentPlan& plan, const config::Node& document) {
  plan.conditions.resize(plan.arms() * plan.values());
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    Condition& condition = plan.conditions[i];
    condition.arm = i % plan.arms();
    condition.value = i / plan.arms();
    const config::Overrides settings = settings_of(plan.asked, document, condition.arm, condition.value);
    for (const std::size_t side : {0u, 1u}) {
      campaign::Job made = job_under(plan.asked.settings, plan.plugins);
      made.teams[side] = team_of(plan, condition.arm);
      made.teams[1 - side] = plan.asked.opponent;
      (side == 0 ? made.home_disturbance : made.away_disturbance) = plan.asked.disturbance;
      (side == 0 ? made.away_disturbance : made.home_disturbance) = plan.asked.opponent_disturbance;
      made.overrides = as_typed(on_side(settings, side));
      campaign::Job& job = condition.jobs[side];
      made.home_inputs = std::move(job.home_inputs);
      made.away_inputs = std::move(job.away_inputs);
      made.common_inputs = std::move(job.common_inputs);
      job = std::move(made);
    }
  }
}

Trial trial(const ExperimentPlan& plan, std::uint64_t index) {
  const std::size_t openings = std::max<std::size_t>(plan.openings.size(), 1);
  Trial out;
  out.side = static_cast<std::size_t>(index % 2);
  out.condition = static_cast<std::size_t>(index / 2 % plan.conditions.size());
  out.pair = index / 2 / plan.conditions.size();
  out.seed = plan.first_seed() + out.pair;
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
  const std::string& arm = plan.asked.arms[each.arm].name;
  return plan.swept() ? fmt::format("{} at {}", arm, plan.value(each.value)) : arm;
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
  return read_plan(text, experiment_study, experiment_plan_version, experiment_of_version_1, [](const PlanJson& json) {
    ExperimentPlan plan;
    read(json, plan);
    config::Mistakes first = mistakes_of_a_plan();
    plan.asked = config::read_document<config::Experiment>(document_of(json), first);
    if (!sound(plan)) throw std::out_of_range("what no experiment has");
    make_jobs(plan, {});
    return plan;
  });
}

std::vector<std::string> differences(const ExperimentPlan& before, const ExperimentPlan& now) {
  config::Experiment asked = now.asked;
  std::vector<std::string> out = config::differences(asked_by(before), declare(asked));
  if (before.measures != now.measures) {
    out.push_back(
        fmt::format("the measures: was {}, now {}", fmt::join(before.measures, ", "), fmt::join(now.measures, ", ")));
  }
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
