// SPDX-License-Identifier: MIT
#include "report/reproduction.hpp"

#include <fmt/format.h>

#include <variant>

namespace regista::report {

std::vector<std::string> tournament_arguments(const study::TournamentPlan& plan) {
  std::vector<std::string> words{"tournament"};
  const auto add = [&](const char* option, const std::string& value) {
    if (value.starts_with('-'))
      words.push_back(fmt::format("{}={}", option, value));  // lest it be taken for an option
    else if (!value.empty())
      words.insert(words.end(), {option, value});
  };
  for (const study::Entrant& team : plan.teams) add("--team", team.file);
  if (plan.format == study::Format::gauntlet) add("--format", "gauntlet");
  add("--pairs", std::to_string(plan.pairs));
  add("--seed", std::to_string(plan.first_seed));
  if (const auto* const score = std::get_if<study::ScoreTest>(&plan.objective)) {
    const auto& design = score->design;
    add("--sprt", fmt::format("{},{}", design.hypotheses.elo0, design.hypotheses.elo1));
    add("--model", statistics::name(design.model));
    add("--alpha", fmt::format("{}", design.rates.alpha));
    add("--beta", fmt::format("{}", design.rates.beta));
  } else if (const auto* const value = std::get_if<study::ValueTest>(&plan.objective)) {
    add("--metric", value->value);
    add("--alpha", fmt::format("{}", value->alpha));
  }
  for (const study::Opening& opening : plan.openings) add("--openings", opening.file);
  add("--limit", plan.common.limit);
  add("--rules", plan.common.rules);
  add("--robot", plan.common.robot);
  add("--disturbance", plan.common.disturbance);
  for (const std::string& each : plan.common.overrides) add("--set", each);
  for (const std::string& each : plan.common.plugins) add("--plugins", each);
  add("--failures-in-a-row", std::to_string(plan.failures_in_a_row));
  add("--processor-seconds", std::to_string(plan.limits.processor_seconds));
  add("--memory", std::to_string(plan.limits.memory >> 20));
  return words;
}

}  // namespace regista::report
