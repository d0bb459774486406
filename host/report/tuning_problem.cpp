// SPDX-License-Identifier: MIT
#include "report/tuning_problem.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "config/values.hpp"
#include "report/objective_numbers.hpp"
#include "report/tournament.hpp"
#include "study/tuning/tuning_setup.hpp"
#include "texts/message.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

// To the nearest name of a file that people say.
std::string file_name(const std::string& path) {
  return texts::visible(std::filesystem::path(path).filename().string());
}

bool is_base(const study::TuningPlan& plan, const study::TuningOpponent& opponent) {
  const auto& inputs = opponent.jobs[0].away_inputs;
  return !inputs.empty() && inputs == plan.base.jobs[0].away_inputs;
}

std::string opponents_text(const study::TuningPlan& plan) {
  std::vector<std::string> out;
  for (const study::TuningOpponent& each : plan.opponents) {
    out.push_back(plan.opponents.size() == 1
                      ? texts::visible(each.label)
                      : fmt::format("{} ({:.4g} %)", texts::visible(each.label), 100.0 * each.weight));
  }
  return fmt::format("{}", fmt::join(out, ", "));
}

std::string base_sentence(const study::TuningPlan& plan) {
  std::string out = fmt::format("Base team: {}", texts::visible(plan.asked.team));
  for (std::size_t i = 0; i < plan.settings.size(); ++i) {
    out += fmt::format("{}{}", i == 0 ? " with " : ", ", texts::visible(plan.settings[i]));
  }
  out += fmt::format(". {}: {}", plan.opponents.size() == 1 ? "Opponent" : "Opponents, with their weights",
                     opponents_text(plan));
  for (const study::TuningOpponent& each : plan.opponents) {
    if (is_base(plan, each)) out += fmt::format("; {} is the base team itself", texts::visible(each.label));
  }
  return out + ".";
}

std::string unit_sentence(const study::TuningPlan& plan) {
  return fmt::format(
      "A pair is {}: with the tuned team at home and away{}, all with the same seed{}.",
      counted(plan.matches_of_pair(), "match", "matches"),
      plan.opponents.size() == 1 ? std::string() : fmt::format(", against each of {} opponents", plan.opponents.size()),
      plan.openings.empty() ? std::string(", from kick-off")
                            : fmt::format(" and opening, of {}", counted(plan.openings.size(), "opening", "openings")));
}

std::string team_of(const campaign::Job& job, std::size_t side) {
  return std::filesystem::path(job.teams[side]).stem().string();
}

}  // namespace

std::string pairs_text(std::uint64_t count) { return counted(count, "pair", "pairs"); }

std::string problem_title(const study::TuningPlan& plan) {
  return fmt::format("{}: {} of {}, {} as {} as possible", texts::visible(plan.asked.name),
                     counted(plan.free_parameters(), "parameter", "parameters"), file_name(plan.asked.team),
                     texts::visible(in_words(plan.objective)), plan.objective.minimise ? "small" : "large");
}

std::string objective_text(const study::TuningObjective& objective) {
  const std::string unit = unit_of(objective);
  return texts::visible(in_words(objective)) + (unit.empty() ? std::string() : fmt::format(" ({})", unit));
}

std::vector<std::string> problem_sentences(const study::TuningPlan& plan) {
  return {base_sentence(plan),
          fmt::format("Objective: {}, the {} the better.", objective_text(plan.objective),
                      plan.objective.minimise ? "smaller" : "larger"),
          unit_sentence(plan)};
}

std::vector<std::string> problem_notes(const study::TuningPlan& plan) {
  std::vector<std::string> out;
  for (const std::string& each : study::notes_on(plan)) out.push_back("note: " + texts::one_line(each));
  return out;
}

std::string scale_text(const study::Parameter& parameter) {
  const std::string scale = parameter.log_scale ? "log" : "linear";
  return parameter.integer ? scale + ", whole numbers" : scale;
}

bool has_unit(const study::Parameter& parameter) { return !parameter.unit.empty() && parameter.unit != "1"; }

std::string range_text(const study::Parameter& parameter) {
  const std::string unit = has_unit(parameter) ? fmt::format(" {}", texts::visible(parameter.unit)) : std::string();
  if (parameter.fixed()) return fmt::format("fixed at {}{}", text_of(parameter, parameter.least), unit);
  return fmt::format("{} to {}{}", text_of(parameter, parameter.least), text_of(parameter, parameter.most), unit);
}

std::string values_text(const study::TuningPlan& plan, const study::ParameterValues& values) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
    if (plan.parameters[i].fixed()) continue;
    out.push_back(
        fmt::format("{}={}", texts::visible(plan.parameters[i].path), text_of(plan.parameters[i], values[i])));
  }
  return fmt::format("{}", fmt::join(out, ", "));
}

std::string forfeiter(const study::TuningPlan& plan, std::size_t team) {
  if (team == 0) return "the team that is tuned";  // with whatever values, those of the base team among them
  return team <= plan.opponents.size() ? plan.opponents[team - 1].label : std::string("the base team");
}

std::string match_text(const std::string& stage, const campaign::Job& job, const campaign::Decided& decided) {
  std::string out = fmt::format("{}, seed {}: {} {}:{} {}", stage, job.seed, team_of(job, 0), decided.score[0],
                                decided.score[1], team_of(job, 1));
  if (decided.set_aside()) out += ", could not be played: " + decided.why_set_aside;
  if (decided.failure) {
    const auto side = static_cast<std::size_t>(decided.failure->side);
    out += ", " + forfeit_text(team_of(job, side), *decided.failure);
  }
  return texts::one_line(out);
}

WhatWasPlayed what_was_played(const study::TuningPlan& plan) {
  std::vector<campaign::Input> openings;
  for (const study::Opening& each : plan.openings) openings.push_back(each.input);
  const campaign::Job& first = plan.opponents.front().jobs[0];
  WhatWasPlayed out = what_was_played(plan.asked.settings, first.common_inputs, openings);
  out.teams.push_back(played_team("the team that is tuned", plan.asked.team, first.home_inputs,
                                  profile_of(first.common_inputs, "home disturbance", plan.asked.disturbance)));
  out.teams.back().set = plan.settings;
  for (const study::TuningOpponent& each : plan.opponents) {
    const campaign::Job& job = each.jobs[0];
    out.teams.push_back(
        played_team(each.label, each.file, job.away_inputs,
                    profile_of(job.common_inputs, "away disturbance", plan.asked.opponent_disturbance)));
  }
  for (const config::Override& each : study::settings_of(plan, false)) {
    const std::string text = to_string(each);
    if (std::ranges::find(plan.settings, text) == plan.settings.end()) out.set.push_back(text);
  }
  out.amount = fmt::format("{} matches at most, {} of them for the search, seed {}", most_matches(plan),
                           most_matches(plan, study::TuningStage::search), plan.seed());
  complete(out, plan);
  return out;
}

}  // namespace regista::report
