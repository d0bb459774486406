// SPDX-License-Identifier: MIT
// A tuning's plan as the file of results keeps it, and compared with the plan that is asked for.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "config/documents.hpp"
#include "config/read.hpp"
#include "match/metric_table.hpp"
#include "study/older_plans.hpp"
#include "study/plan_differences.hpp"
#include "study/plan_fields.hpp"
#include "study/settings.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {
namespace {

constexpr int tuning_plan_version = 2;

bool sound(const Parameter& each) {
  return each.least <= each.start && each.start <= each.most && (!each.log_scale || each.fixed() || each.least > 0.0);
}

std::string in_words(const std::vector<Parameter>& parameters) {
  std::string out;
  for (const Parameter& each : parameters) {
    out += fmt::format("{}{} {} to {} from {}{}{}", out.empty() ? "" : ", ", each.path, each.least, each.most,
                       each.start, each.integer ? ", whole" : "", each.log_scale ? ", logarithmic" : "");
  }
  return out;
}

bool is_of_the_team(const config::Override& setting) {
  constexpr std::array<std::string_view, 5> others{"opponent.", "rules.", "robot.", "disturbance.",
                                                   "opponent_disturbance."};
  return std::ranges::none_of(others, [&](std::string_view each) { return setting.path.starts_with(each); });
}

TuningObjective objective_of(const config::Tuning& asked) {
  TuningObjective out;
  out.minimise = !asked.objective.minimise.empty();
  for (const auto* const terms : {&asked.objective.maximise, &asked.objective.minimise}) {
    for (const config::TuningObjective::Term& each : *terms)
      out.terms.push_back({std::string(match::without_roles(each.measure)), each.weight});
  }
  if (out.terms.empty()) out.terms = {{"goal_difference", 1.0}};
  return out;
}

// What disturbs the tuned team disturbs the base team, too, when they are compared playing each other.
void make_jobs(const TuningPlan& plan, TuningOpponent& opponent, bool is_base) {
  const config::Overrides settings = settings_of(plan, is_base);
  const std::string& own = plan.asked.disturbance;
  const std::string& other = is_base ? own : plan.asked.opponent_disturbance;
  for (const std::size_t side : {0u, 1u}) {
    campaign::Job made = job_under(plan.asked.settings, plan.plugins);
    made.teams[side] = plan.asked.team;
    made.teams[1 - side] = opponent.file;
    made.home_disturbance = side == 0 ? own : other;
    made.away_disturbance = side == 0 ? other : own;
    made.overrides = as_typed(on_side(settings, side));
    campaign::Job& job = opponent.jobs[side];
    made.home_inputs = std::move(job.home_inputs);
    made.away_inputs = std::move(job.away_inputs);
    made.common_inputs = std::move(job.common_inputs);
    job = std::move(made);
  }
}

bool can_search(const TuningPlan& plan) {
  const std::uint64_t population = has_population(plan.algorithm()) ? plan.population() : 0;
  return plan.evaluations() >
         least_evaluations(plan.algorithm(), plan.free_parameters(), static_cast<std::size_t>(population));
}

}  // namespace

// Found by their arguments: not in the namespace above.

template <Like<Parameter> Value, class Visit>
static void fields(Value& parameter, Visit& visit) {
  visit("path", parameter.path);
  visit("start", parameter.start);
  visit("least", parameter.least);
  visit("most", parameter.most);
  visit("integer", parameter.integer);
  visit("log_scale", parameter.log_scale);
  visit("unit", parameter.unit);
  visit("doc", parameter.doc);
}

static PlanJson json_of(const TuningOpponent& opponent) {
  PlanJson out{{"label", opponent.label}};
  for (const std::size_t side : {0u, 1u}) {
    const campaign::Job& job = opponent.jobs[side];
    out[side == 0 ? "home" : "away"] = {
        {"home", json_of(job.home_inputs)}, {"away", json_of(job.away_inputs)}, {"common", json_of(job.common_inputs)}};
  }
  return out;
}
static void read(const PlanJson& json, TuningOpponent& opponent) {
  json.at("label").get_to(opponent.label);
  for (const std::size_t side : {0u, 1u}) {
    const PlanJson& inputs = json.at(side == 0 ? "home" : "away");
    read(inputs.at("home"), opponent.jobs[side].home_inputs);
    read(inputs.at("away"), opponent.jobs[side].away_inputs);
    read(inputs.at("common"), opponent.jobs[side].common_inputs);
  }
}

template <Like<TuningPlan> Plan, class Visit>
static void fields(Plan& plan, Visit& visit) {
  visit("team_document", plan.document);
  visit("parameters", plan.parameters);
  visit("opponents", plan.opponents);
  visit("base", plan.base);
  visit("openings", plan.openings);
  visit("most_goals", plan.most_goals);
  visit("search_pairs", plan.search_pairs);
  visit("pairs", plan.pairs);
  visit("selection_pairs", plan.selection_pairs);
  visit("verification_pairs", plan.verification_pairs);
  visit("folder", plan.folder);
  visit("plugins", plan.plugins);
  visit.maybe("program", plan.program);
}

config::Overrides settings_of(const TuningPlan& plan, bool against_base) {
  const config::Overrides all = settings_of(plan.asked.settings.set, "set");
  if (!against_base) return all;
  config::Overrides out;
  for (const config::Override& each : all) {
    if (each.path.starts_with("opponent.")) continue;
    out.push_back(each);
    if (is_of_the_team(each)) out.emplace_back("opponent." + each.path, each.value, each.where);
  }
  return out;
}

void complete(TuningPlan& plan) {
  plan.objective = objective_of(plan.asked);
  plan.settings.clear();
  for (const config::Override& each : settings_of(plan, false)) {
    // What is set for the tuned team alone goes with it into its file; as an opponent the base team has it, too.
    if (is_of_the_team(each)) plan.settings.push_back(to_string(each));
  }
  plan.opponents.resize(plan.asked.opponents.size());
  double sum = 0.0;
  for (const config::Tuning::Opponent& each : plan.asked.opponents) sum += each.weight;
  for (std::size_t i = 0; i < plan.opponents.size(); ++i) {
    plan.opponents[i].file = plan.asked.opponents[i].team;
    plan.opponents[i].weight = plan.asked.opponents[i].weight / sum;
    make_jobs(plan, plan.opponents[i], false);
  }
  plan.base.file = plan.asked.team;
  make_jobs(plan, plan.base, true);
}

// Upper bounds are those of its document.
bool sound(const TuningPlan& plan) {
  constexpr std::uint64_t most_pairs = 10'000'000;
  const auto within = [](std::uint64_t least, std::uint64_t count, std::uint64_t most) {
    return least <= count && count <= most;
  };
  return plan.free_parameters() > 0 && plan.most_goals >= 1 && within(1, plan.pairs, most_pairs) &&
         within(plan.pairs, plan.search_pairs, most_pairs) && within(1, plan.selection_pairs, most_pairs) &&
         within(0, plan.verification_pairs, most_pairs) &&
         std::ranges::all_of(plan.parameters, [](const Parameter& each) { return sound(each); }) && can_search(plan);
}

std::string to_json(const TuningPlan& plan) { return plan_text(tuning_study, tuning_plan_version, plan); }

TuningPlan tuning_plan_from_json(const std::string& text) {
  return read_plan(text, tuning_study, tuning_plan_version, tuning_of_version_1, [](const PlanJson& json) {
    TuningPlan plan;
    read(json, plan);
    config::Mistakes first = mistakes_of_a_plan();
    plan.asked = config::read_document<config::Tuning>(document_of(json), first);
    if (plan.opponents.size() != plan.asked.opponents.size() || !algorithm_named(plan.asked.search.algorithm) ||
        !sound(plan))
      throw std::out_of_range("what no tuning has");
    complete(plan);
    return plan;
  });
}

std::vector<std::string> differences(const TuningPlan& before, const TuningPlan& now) {
  config::Tuning asked = now.asked;
  std::vector<std::string> out = config::differences(asked_by(before), declare(asked));
  if (before.parameters != now.parameters) {
    out.push_back(fmt::format("the parameters: was {}, now {}", in_words(before.parameters), in_words(now.parameters)));
  }
  struct Count {
    const char* what;
    std::uint64_t before, now;
  };
  for (const auto& [what, then, today] :
       {Count{"pairs of the search", before.search_pairs, now.search_pairs},
        Count{"pairs for each evaluation", before.pairs, now.pairs},
        Count{"pairs of the selection", before.selection_pairs, now.selection_pairs},
        Count{"pairs of the verification", before.verification_pairs, now.verification_pairs}}) {
    if (then != today) out.push_back(fmt::format("{}: was {}, now {}", what, then, today));
  }
  if (!out.empty()) return out;  // else the same opponents, which can be compared one by one
  InputDifferences inputs;
  for (std::size_t i = 0; i < now.opponents.size(); ++i) {
    const campaign::Job &old = before.opponents[i].jobs[0], &fresh = now.opponents[i].jobs[0];
    inputs.add("the team: ", old.home_inputs, fresh.home_inputs);
    inputs.add(now.opponents[i].label + ": ", old.away_inputs, fresh.away_inputs);
    inputs.add("", old.common_inputs, fresh.common_inputs);
    inputs.add("", before.opponents[i].jobs[1].common_inputs, now.opponents[i].jobs[1].common_inputs);
  }
  for (const std::size_t side : {0u, 1u}) {
    const campaign::Job &old = before.base.jobs[side], &fresh = now.base.jobs[side];
    inputs.add("the team: ", old.home_inputs, fresh.home_inputs);
    inputs.add("the team: ", old.away_inputs, fresh.away_inputs);
    inputs.add("", old.common_inputs, fresh.common_inputs);
  }
  return std::move(inputs).with_openings(before.openings, now.openings);
}

}  // namespace regista::study
