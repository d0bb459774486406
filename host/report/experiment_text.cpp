// SPDX-License-Identifier: MIT
// An experiment as text. Its estimates with their intervals are written by estimate_text.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "config/values.hpp"
#include "report/estimate_text.hpp"
#include "report/experiment.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "report/text_table.hpp"
#include "report/tournament.hpp"
#include "study/settings.hpp"
#include "texts/message.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

using study::MeanEstimate;

std::string with_unit(const std::string& measure) {
  return study::is_time(measure) ? fmt::format("{} [{}]", measure, study::unit_of(measure)) : measure;
}

// Measures in rows, arms in columns.
std::string arms_table(const ExperimentView& view, const std::vector<std::size_t>& measures) {
  const study::ExperimentPlan& plan = view.plan;
  TextTable table;
  std::vector<std::string> head{"measure"};
  for (const config::Experiment::Arm& arm : plan.asked.arms) head.push_back(texts::visible(arm.name));
  table.row(head);
  for (const std::size_t measure : measures) {
    std::vector<std::string> cells{with_unit(plan.measures[measure])};
    for (std::size_t arm = 0; arm < plan.asked.arms.size(); ++arm) {
      cells.push_back(estimate_text(view.course.mean(arm, measure)));
    }
    table.row(cells);
  }
  return table.text();
}

// One measure: values of the sweep in rows, arms in columns.
std::string sweep_table(const ExperimentView& view, std::size_t measure) {
  const study::ExperimentPlan& plan = view.plan;
  TextTable table;
  std::vector<std::string> head{texts::visible(plan.sweep())};
  for (const config::Experiment::Arm& arm : plan.asked.arms) head.push_back(texts::visible(arm.name));
  table.row(head);
  for (std::size_t value = 0; value < plan.values(); ++value) {
    std::vector<std::string> cells{texts::visible(plan.value(value))};
    for (std::size_t arm = 0; arm < plan.asked.arms.size(); ++arm) {
      cells.push_back(estimate_text(view.course.mean(plan.condition(arm, value), measure)));
    }
    table.row(cells);
  }
  return with_unit(plan.measures[measure]) + '\n' + table.text();
}

std::string mean_with_sign(const MeanEstimate& estimate) {
  return rounded_with_sign(estimate.mean,
                           estimate.interval ? half_width(estimate.interval) : std::abs(estimate.mean) / 100.0);
}

// Not of a single role, but for the primary one: a terminal has room for these.
bool is_headline(const study::ExperimentPlan& plan, const std::string& measure) {
  return measure == plan.primary() || measure.find('.') == std::string::npos;
}

std::string differences_table(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  TextTable table;
  std::vector<std::string> head{"measure"};
  for (const study::Comparison& each : plan.comparisons()) {
    head.push_back(
        fmt::format("{} less {}", texts::visible(label(plan, each.first)), texts::visible(label(plan, each.second))));
  }
  table.row(head);
  for (std::size_t measure = 0; measure < plan.measures.size(); ++measure) {
    if (!is_headline(plan, plan.measures[measure])) continue;
    std::vector<std::string> cells{with_unit(plan.measures[measure])};
    for (const study::Comparison& each : plan.comparisons()) {
      const MeanEstimate difference = view.course.difference(each, measure);
      cells.push_back(difference.pairs == 0
                          ? "-"
                          : fmt::format("{} {}", mean_with_sign(difference),
                                        difference.interval ? interval_text(difference) : std::string()));
    }
    table.row(cells);
  }
  return table.text();
}

std::string failures_text(const ExperimentView& view) {
  std::string out;
  const study::ForfeitList& forfeits = view.course.forfeits();
  for (const study::Forfeits& each : forfeits.listed()) {
    const bool opponent = each.team == view.plan.conditions.size();
    out += fmt::format("{} {}; the first again: {}\n", texts::counted(each.count, "match", "matches"),
                       forfeit_text(opponent ? std::string("the opponent") : label(view.plan, each.team), each.failure),
                       view.again(each.first_match));
  }
  if (forfeits.unlisted() > 0) {
    out += texts::counted(forfeits.unlisted(), "more was", "more were") + " forfeited for other reasons\n";
  }
  if (!out.empty()) out = "\nForfeits, whose pairs are left out of every number:\n" + out;
  return out;
}

std::string left_out_text(const ExperimentView& view) {
  if (view.course.unplayed_pairs() == 0) return {};
  std::string out = "\nPairs that could not be played, left out of every number; no team can be blamed:\n";
  for (std::size_t i = 0; i < view.plan.conditions.size(); ++i) {
    const std::uint64_t pairs = view.course.unplayed_pairs(i);
    if (pairs > 0) out += fmt::format("{} of {}\n", pairs_in_words(pairs), texts::visible(label(view.plan, i)));
  }
  return out + unplayed_text(view.course.remarks());
}

std::string pairs_text(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  const std::uint64_t pairs = view.course.taken() / 2 / plan.conditions.size();
  return fmt::format(
      "Means of a match{}, +/- half of the {:.4g} % interval (Student's t over {} of matches: same seed, both sides)\n",
      std::ranges::any_of(plan.measures, [](const auto& each) { return study::is_time(each); })
          ? ", times in minutes of 60 minutes of play"
          : "",
      100.0 * plan.asked.confidence, texts::counted(pairs, "pair", "pairs"));
}

}  // namespace

WhatWasPlayed what_was_played(const study::ExperimentPlan& plan) {
  std::vector<campaign::Input> openings;
  for (const study::Opening& each : plan.openings) openings.push_back(each.input);
  const campaign::Job& first = plan.conditions.front().jobs[0];
  WhatWasPlayed out = what_was_played(plan.asked.settings, first.common_inputs, openings);
  for (std::size_t arm = 0; arm < plan.arms(); ++arm) {
    const campaign::Job& job = plan.conditions[arm].jobs[0];
    out.teams.push_back(played_team(plan.asked.arms[arm].name, team_of(plan, arm), job.home_inputs,
                                    profile_of(job.common_inputs, "home disturbance", plan.asked.disturbance)));
    out.teams.back().set = study::as_typed(study::settings_of(plan.asked.arms[arm].set, "set"));
  }
  out.teams.push_back(
      played_team("the opponent", plan.asked.opponent, first.away_inputs,
                  profile_of(first.common_inputs, "away disturbance", plan.asked.opponent_disturbance)));
  out.set = study::as_typed(study::settings_of(plan.asked.settings.set, "set"));
  out.amount = fmt::format(
      "{} against the opponent of each arm{}, seeds from {}", texts::counted(plan.pairs, "pair", "pairs"),
      plan.swept() ? fmt::format(" at each of {} values of {}", plan.values(), plan.sweep()) : std::string(),
      plan.first_seed());
  for (const study::Condition& each : plan.conditions) {
    const campaign::Job& job = each.jobs[0];
    for (const auto* inputs : {&job.common_inputs, &job.home_inputs, &job.away_inputs})
      out.inputs.insert(out.inputs.end(), inputs->begin(), inputs->end());
  }
  complete(out, plan);
  return out;
}

std::string experiment_title(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  std::string out =
      fmt::format("{}: {}", texts::visible(plan.asked.name), texts::counted(plan.asked.arms.size(), "arm", "arms"));
  if (plan.swept()) out += fmt::format(" at {} values of {}", plan.values(), texts::visible(plan.sweep()));
  out += fmt::format(" against {}, {} matches each",
                     texts::visible(std::filesystem::path(plan.asked.opponent).stem().string()), 2 * plan.pairs);
  if (!plan.openings.empty()) {
    out += " from " + texts::counted(plan.openings.size(), "opening", "openings");
  }
  return out;
}

std::string experiment_standing(const ExperimentView& view) {
  constexpr std::size_t shown = 6;
  const study::ExperimentPlan& plan = view.plan;
  std::vector<std::size_t> measures;
  if (const auto primary = study::primary_measure(plan)) measures.push_back(*primary);
  for (std::size_t i = 0; i < plan.measures.size() && measures.size() < shown; ++i) {
    if (std::ranges::find(measures, i) == measures.end()) measures.push_back(i);
  }
  std::string out = experiment_title(view) + '\n';
  return out + (plan.swept() ? sweep_table(view, measures.front()) : arms_table(view, measures));
}

std::string experiment_text(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  std::string out = doubts_text(view.course.remarks()) + experiment_title(view) + '\n';
  if (!plan.asked.question.empty()) out += texts::visible(plan.asked.question) + '\n';
  out += played_text(what_was_played(plan));
  out += '\n' + experiment_headline(view) + "\n\n" + pairs_text(view) + '\n';
  if (plan.swept()) {
    for (std::size_t measure = 0; measure < plan.measures.size(); ++measure) out += sweep_table(view, measure) + '\n';
  } else {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < plan.measures.size(); ++i) all.push_back(i);
    out += arms_table(view, all);
    if (!plan.comparisons().empty())
      out += "\nDifferences, pair by pair (of single roles: --json, or the page):\n\n" + differences_table(view);
    out += '\n';
  }
  const std::vector<std::string> notes = experiment_notes(view);
  for (const std::string& sentence : notes) out += sentence + '\n';
  if (!notes.empty()) out += '\n';
  for (const std::string& sentence : finding_sentences(view)) out += sentence + '\n';
  return out + left_out_text(view) + failures_text(view) + notes_text(view.course.remarks());
}

}  // namespace regista::report
