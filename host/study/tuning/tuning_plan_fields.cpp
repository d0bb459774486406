// SPDX-License-Identifier: MIT
// A tuning's plan as the file of results keeps it, and compared with the plan that is asked for.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "study/plan_differences.hpp"
#include "study/tuning/tuning_plan_fields.hpp"

namespace regista::study {
namespace {

constexpr int tuning_plan_version = 1;

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

}  // namespace

// Upper bounds are those of its document.
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

bool can_search(const TuningPlan& plan, Algorithm algorithm) {
  const std::uint64_t population = has_population(algorithm) ? plan.population : 0;
  return plan.evaluations(algorithm) >
         least_evaluations(algorithm, plan.free_parameters(), static_cast<std::size_t>(population));
}

std::string to_json(const TuningPlan& plan) { return plan_text(tuning_study, tuning_plan_version, plan); }

TuningPlan tuning_plan_from_json(const std::string& text) {
  return read_plan(text, tuning_study, tuning_plan_version, [](const PlanJson& json) {
    if (holds_comparison_of_before(json)) throw std::invalid_argument("these are results of another study");
    TuningPlan plan;
    read(json, plan);
    if (!sound(plan) || !can_search(plan, plan.algorithm)) throw std::out_of_range("a number that no tuning has");
    return plan;
  });
}

std::vector<std::string> differences(const TuningPlan& before, const TuningPlan& now) {
  std::vector<std::string> out = field_differences(before, now);
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
