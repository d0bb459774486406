// SPDX-License-Identifier: MIT
// The outline of an experiment: its findings, means and differences for people, and all numbers for programs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <optional>

#include "config/values.hpp"
#include "report/experiment_report.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "study/paired_estimates.hpp"
#include "study/settings.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

// Returns a title: "role_overlap: 3 arms against spqr2023, 36 matches each"
std::string title_of(const study::ExperimentPlan& plan) {
  std::string out = fmt::format("{}: {}", plan.asked.name, texts::plural(plan.asked.arms.size(), "arm", "arms"));
  if (plan.swept()) out += fmt::format(" at {} values of {}", plan.values(), plan.sweep());
  out += fmt::format(" against {}, {} {} each", std::filesystem::path(plan.asked.opponent).stem().string(),
                     2 * plan.pairs_to_its_end(), plan.openings.empty() ? "matches" : "games");
  if (!plan.openings.empty()) out += " from " + scenes_in_words(plan.openings, plan.asked.settings.limit);
  return out;
}

std::string minutes_of_play(const ExperimentView& view) {
  std::vector<double> seconds;
  for (std::size_t i = 0; i < view.plan.conditions.size(); ++i) seconds.push_back(view.course.playing_seconds(i));
  const auto [least, most] = std::ranges::minmax(seconds);
  const std::string from = fmt::format("{:.0f}", least / 60.0), to = fmt::format("{:.0f}", most / 60.0);
  return from == to ? from : fmt::format("{} – {}", from, to);
}

std::vector<Tile> tiles_of(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  std::vector<Tile> out{{std::to_string(plan.arms()), plan.arms() == 1 ? "arm" : "arms"}};
  if (plan.swept()) out.push_back({std::to_string(plan.values()), "values of the sweep"});
  out.push_back({std::to_string(plan.pairs_to_its_end()), "pairs of matches each: same seed, both sides"});
  out.push_back({minutes_of_play(view), "minutes of play each"});
  out.push_back({std::to_string(view.course.taken()),
                 fmt::format("{} of {} planned", games_in_words(plan.openings), plan.matches())});
  return out;
}

Section findings_section(const ExperimentView& view) {
  const std::vector<std::string> sentences = finding_sentences(view);
  Section out("findings", "What was found");
  out.list({sentences.begin(), sentences.end()});
  return out;
}

// Returns the indices of the measures; the primary measure comes first.
std::vector<std::size_t> measures_in_order(const study::ExperimentPlan& plan) {
  const std::optional<std::size_t> primary = study::primary_measure(plan);
  std::vector<std::size_t> out;
  if (primary) out.push_back(*primary);
  for (std::size_t i = 0; i < plan.measures.size(); ++i) {
    if (i != primary) out.push_back(i);
  }
  return out;
}

Section figures_section(const ExperimentView& view) {
  Section out("figures", "Figures");
  out.figures(names_of_experiment_figures(view.plan));
  std::vector<std::string> left_out;
  for (std::size_t measure = 0; measure < view.plan.measures.size(); ++measure) {
    if (view.course.taken() > 0 && shows_nothing(view, measure)) left_out.push_back(view.plan.measures[measure]);
  }
  if (!left_out.empty())
    out.note(fmt::format("Not drawn, because all numbers are 0 or missing: {}.", fmt::join(left_out, ", ")),
             Readers::page);
  return out;
}

Sentence with_unit(const std::string& measure) {
  Sentence out = path(measure);
  return study::is_time(measure) ? out << fmt::format(", {}", study::unit_of(measure)) : out;
}

// Returns a table with a row for each measure and value of the sweep, and a column for each arm.
Table means_table(const ExperimentView& view, const std::vector<std::size_t>& measures) {
  const study::ExperimentPlan& plan = view.plan;
  Table out{{{"Measure", Column::words}}};
  if (plan.swept()) out.headings.push_back({path(plan.sweep())});
  for (const config::Experiment::Arm& arm : plan.asked.arms) out.headings.push_back({named(arm.name)});
  for (const std::size_t measure : measures) {
    for (std::size_t value = 0; value < plan.values(); ++value) {
      std::vector<Cell> cells{with_unit(plan.measures[measure])};
      if (plan.swept()) cells.emplace_back(code(plan.value(value)));
      for (std::size_t arm = 0; arm < plan.arms(); ++arm)
        cells.emplace_back(estimate_text(view.course.mean(plan.condition(arm, value), measure)));
      out.row(std::move(cells));
    }
  }
  out.style = Table::Style::values;
  return out;
}

Section means_section(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  Section out("means", "Means");
  for (const std::string& each : experiment_notes(view)) out.note(each);
  const bool times = std::ranges::any_of(plan.measures, study::is_time);
  out.note(
      fmt::format("{} means of a match, each with half of its {:.4g} % interval (Student's t over {} of matches: "
                  "same seed, both sides).",
                  times ? "Times are minutes in 60 minutes of play, all other numbers are" : "Numbers are",
                  100.0 * plan.asked.confidence, pairs_in_words(view.course.taken() / 2 / plan.conditions.size())));
  std::vector<std::size_t> all(plan.measures.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Table table = means_table(view, all);
  table.file = "means.csv";
  table.csv = experiment_summary_csv(view);
  out.table(std::move(table));
  return out;
}

// Returns which readers see a measure. Without a sweep, a terminal shows the primary measure and whole-team measures.
Readers readers_of(const study::ExperimentPlan& plan, const std::string& measure) {
  const bool shown = measure == plan.primary() || measure.find('.') == std::string::npos;
  return !plan.swept() && shown ? Readers::all : Readers::page;
}

Section differences_section(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  Section out("differences", "Differences");
  Table table{{{"Measure", Column::words},
               {"First", Column::words},
               {"Less second", Column::words},
               {"Pairs"},
               {"Difference"}}};
  Readers readers = Readers::page;  // readers of the table; Readers::all if a terminal shows at least one measure
  for (std::size_t measure = 0; measure < plan.measures.size(); ++measure) {
    const Readers of_measure = readers_of(plan, plan.measures[measure]);
    if (of_measure == Readers::all) readers = Readers::all;
    for (const study::Comparison& each : plan.comparisons()) {
      const study::MeanEstimate difference = view.course.difference(each, measure);
      table.row({with_unit(plan.measures[measure]), named(label(plan, each.first)), named(label(plan, each.second)),
                 difference.pairs, signed_with_interval(difference)},
                of_measure);
    }
  }
  if (table.rows.empty()) return out;
  table.style = Table::Style::values;
  table.summary = "All differences";
  out.note(
      "Differences pair by pair. Each interval holds for its own comparison. Only the primary measure was tested, with "
      "a correction for the number of comparisons.",
      readers);
  if (readers == Readers::all && std::ranges::find(table.rows, Readers::page, &Row::readers) != table.rows.end())
    out.note("Those of single roles: --json, or the page.", Readers::terminal);
  out.table(std::move(table), readers);
  return out;
}

Section left_out_section(const ExperimentView& view) {
  Section out = unplayed_section(view.course.unplayed_pairs(), view.course.remarks());
  std::vector<Sentence> by_condition;
  for (std::size_t i = 0; i < view.plan.conditions.size(); ++i) {
    if (const std::uint64_t pairs = view.course.unplayed_pairs(i); pairs > 0)
      by_condition.push_back(Sentence(pairs_in_words(pairs) + " of ") << named(label(view.plan, i)));
  }
  if (view.plan.conditions.size() > 1 && !by_condition.empty()) {
    out.line("By condition:");
    out.list(std::move(by_condition));
  }
  return out;
}

ForfeitWords forfeit_words(const ExperimentView& view, const char* opponent) {
  const auto label = [&plan = view.plan, opponent](std::size_t team) {
    return team == plan.conditions.size() ? std::string(opponent) : study::label(plan, team);
  };
  return {label, view.again, "Their pairs are left out of every number."};
}

Json condition(const study::ExperimentPlan& plan, std::size_t index) {
  const study::Condition& each = plan.conditions[index];
  Json out{{"arm", plan.asked.arms[each.arm].name}};
  if (plan.swept()) out["value"] = plan.value(each.value);
  return out;
}

Json comparison_json(const study::ExperimentPlan& plan, const study::Comparison& of,
                     const study::MeanEstimate& difference) {
  Json out{{"first", condition(plan, of.first)}, {"second", condition(plan, of.second)}};
  out.update(json_of(difference));
  return out;
}

// Returns the trend of an arm. slope: change of the measure per unit of the swept value, mean over pairs.
Json trend_json(const study::ExperimentPlan& plan, std::size_t arm, const study::MeanEstimate& slope) {
  Json out{{"arm", plan.asked.arms[arm].name}};
  out.update(json_of(slope));
  return out;
}

Json measure_json(const ExperimentView& view, std::size_t measure) {
  const study::ExperimentPlan& plan = view.plan;
  Json conditions = Json::array(), differences = Json::array(), trends = Json::array();
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    Json each = condition(plan, i);
    each.update(json_of(view.course.mean(i, measure)));
    const study::MeanEstimate per_match = study::mean_of(view.course.per_match(i, measure), plan.asked.confidence);
    each["per_match"] = per_match.pairs > 0 ? Json(per_match.mean) : Json(nullptr);
    conditions.push_back(each);
  }
  for (const study::Comparison& each : plan.comparisons())
    differences.push_back(comparison_json(plan, each, view.course.difference(each, measure)));
  for (std::size_t arm = 0; study::has_trends(plan) && arm < plan.arms(); ++arm)
    trends.push_back(trend_json(plan, arm, view.course.slope(arm, measure)));
  return {{"measure", plan.measures[measure]},
          {"unit", study::unit_of(plan.measures[measure])},
          {"conditions", conditions},
          {"differences", differences},
          {"trends", trends}};
}

Json tested_json(const study::Tested& of) {
  return {{"p", json_or_null(of.p)},
          {"p_by", of.p ? Json(study::name(of.by)) : Json(nullptr)},
          {"p_holm", json_or_null(of.adjusted)},
          {"found", of.found},
          {"unplayed_pairs", of.unplayed_pairs},
          {"verdict_prevented", of.prevented}};
}

Json primary_json(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  if (plan.primary().empty()) return nullptr;
  const study::Findings all = study::findings(plan, view.course);
  Json comparisons = Json::array(), trends = Json::array();
  for (const study::Finding& finding : all.comparisons) {
    Json each = comparison_json(plan, finding.comparison, finding.difference);
    each.update(tested_json(finding));
    each["equal_by_construction"] = study::equal_conditions(plan, finding.comparison);
    comparisons.push_back(each);
  }
  for (const study::Trend& trend : all.trends) {
    Json each = trend_json(plan, trend.arm, trend.slope);
    each.update(tested_json(trend));
    trends.push_back(each);
  }
  return {{"measure", plan.primary()},
          {"test", study::name(plan.test())},
          {"comparisons", comparisons},
          {"trends", trends}};
}

Json data_of(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  Json arms = Json::array(), conditions = Json::array(), measures = Json::array();
  for (std::size_t arm = 0; arm < plan.arms(); ++arm) {
    arms.push_back({{"name", plan.asked.arms[arm].name},
                    {"team", team_of(plan, arm)},
                    {"set", study::as_typed(study::settings_of(plan.asked.arms[arm].set, "set"))}});
  }
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    Json each = condition(plan, i);
    each["playing_seconds"] = view.course.playing_seconds(i);
    const auto of_a_match = view.course.playing_seconds_of_a_match(i);
    each["playing_minutes_of_a_match"] = of_a_match ? Json(*of_a_match / 60.0) : Json(nullptr);
    each["forfeits"] = view.course.forfeits().of_team()[i];
    each["unplayed_pairs"] = view.course.unplayed_pairs(i);
    each["packets_of_short_games"] = packets_json(view.course.packets(i));
    conditions.push_back(each);
  }
  for (std::size_t i = 0; i < plan.measures.size(); ++i) measures.push_back(measure_json(view, i));
  Json findings = Json::array({experiment_headline(view)});
  for (const std::string& each : finding_sentences(view)) findings.push_back(each);
  Json out{{"experiment", plan.asked.name},
           {"question", plan.asked.question},
           {"arms", arms},
           {"opponent", plan.asked.opponent},
           {"sweep", plan.swept() ? Json{{"path", plan.sweep()}, {"values", plan.value_texts()}} : Json(nullptr)},
           {"pairs", plan.pairs},
           {"first_seed", plan.first_seed()},
           {"openings", plan.openings.size()},
           {"matches", view.course.taken()},
           {"planned_matches", plan.matches()},
           {"complete", view.course.complete()},
           {"confidence", plan.asked.confidence},
           {"conditions", conditions},
           {"measures", measures},
           {"primary", primary_json(view)},
           {"findings", findings},
           {"notes", experiment_notes(view)},
           {"forfeits", forfeits_json(view.course.forfeits(), forfeit_words(view, "opponent"), "by")},
           {"unplayed", unplayed_json(view.course.unplayed_pairs(), view.course.remarks())}};
  if (!plan.pairs_before.empty()) out["pairs_before"] = plan.pairs_before;
  if (plan.ended_after) out["ended_after"] = *plan.ended_after;
  return out;
}

}  // namespace

WhatWasPlayed what_was_played(const study::ExperimentPlan& plan) {
  const campaign::Job& first = plan.conditions.front().jobs[0];
  WhatWasPlayed out = what_was_played(plan.asked.settings, first.common_inputs, inputs_of(plan.openings));
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
      "{} against the opponent of each arm{}, seeds from {}", number_of_pairs(plan),
      plan.swept() ? fmt::format(" at each of {} values of {}", plan.values(), plan.sweep()) : std::string(),
      plan.first_seed());
  for (const study::Condition& each : plan.conditions) {
    const campaign::Job& job = each.jobs[0];
    for (const auto* inputs : {&job.common_inputs, &job.home_inputs, &job.away_inputs})
      out.inputs.insert(out.inputs.end(), inputs->begin(), inputs->end());
  }
  complete(out, plan);
  if (plan.ended_after) {  // a repetition must have as many pairs as were played
    config::Experiment asked = plan.asked;
    asked.matches = static_cast<int>(2 * *plan.ended_after);
    asked.minutes.reset();
    out.document = config::document_text(asked);
  }
  return out;
}

std::string experiment_standing(const ExperimentView& view) {
  constexpr std::size_t shown = 6;
  const study::ExperimentPlan& plan = view.plan;
  std::vector<std::size_t> measures = measures_in_order(plan);
  measures.resize(std::min(measures.size(), plan.swept() ? 1 : shown));
  Section out("standing", "");
  out.line(title_of(plan));
  Table table = means_table(view, measures);
  if (plan.swept()) {  // a sweep has only one measure, whose name is above the table
    out.line(with_unit(plan.measures[measures.front()]));
    table.headings.front().readers = Readers::page;
  }
  out.table(std::move(table));
  return section_text(out);
}

Outline experiment_outline(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  Outline out;
  out.kind = "Experiment";
  out.title = title_of(plan);
  out.question = plan.asked.question;
  out.headline = experiment_headline(view);
  if (const std::uint64_t pairs = view.course.unplayed_pairs(); pairs > 0)
    out.beside.push_back(unplayed_sentence(pairs));
  out.tiles = tiles_of(view);
  if (const auto names = names_of_experiment_figures(plan); study::primary_measure(plan)) out.lead = names.front();
  out.played = what_was_played(plan);
  out.add(findings_section(view));
  out.add(figures_section(view));
  out.add(means_section(view));
  out.add(differences_section(view));
  out.add(left_out_section(view));
  out.add(forfeits_section(view.course.forfeits(), forfeit_words(view, "the opponent")));
  out.add(configuration_section(plan.documents, out.played.teams));
  out.remarks = view.course.remarks();
  out.data = [view] { return data_of(view); };
  return out;
}

}  // namespace regista::report
