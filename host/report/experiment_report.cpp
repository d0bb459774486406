// SPDX-License-Identifier: MIT
#include "report/experiment_report.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

std::string arm_fields(const study::ExperimentPlan& plan, std::size_t condition) {
  const study::Condition& each = plan.conditions[condition];
  std::string out = csv_field(plan.asked.arms[each.arm].name);
  if (plan.swept()) out += ',' + csv_field(plan.value(each.value));
  return out;
}

std::string head_of_arm(const study::ExperimentPlan& plan) {
  return plan.swept() ? "arm," + csv_field(plan.sweep()) : std::string("arm");
}

class ExperimentReport final : public StudyReport {
 public:
  ExperimentReport(study::ExperimentPlan plan, CommandOf again)
      : plan_(std::move(plan)), course_(plan_), again_(std::move(again)) {}

  study::Study& study() override { return course_; }
  const study::Study& study() const override { return course_; }

  std::vector<std::string> teams() const override {
    std::vector<std::string> out = texts::names_of(plan_.asked.arms, &config::Experiment::Arm::name);
    out.push_back(plan_.asked.opponent);
    return out;
  }
  WhatWasPlayed played() const override { return what_was_played(plan_); }
  Outline outline() const override { return experiment_outline(view()); }
  void end_after(std::uint64_t pairs) override { plan_.ended_after = pairs; }
  std::vector<std::string> notes() const override {
    std::vector<std::string> out;
    for (const study::Comparison& each : plan_.comparisons()) {
      if (!study::equal_conditions(plan_, each)) continue;
      out.push_back(fmt::format("A/A: {} and {} are equal, so they do not differ by construction",
                                texts::one_line(label(plan_, each.first)), texts::one_line(label(plan_, each.second))));
    }
    add_notes_on_pairs(plan_, out);
    return out;
  }
  std::string standing() const override { return experiment_standing(view()); }
  std::string match(const study::Round& /*round*/, std::uint64_t index,
                    const campaign::MatchResult& decided) const override {
    const study::Trial trial = study::trial(plan_, index);
    const std::string scene = scene_name(plan_.openings, trial.opening);
    const std::string arm = label(plan_, trial.condition);
    std::array<std::string, 2> sides{"the opponent", "the opponent"};
    sides[trial.side] = arm;
    return fmt::format("seed {}{}{}: {} {} {}:{}", trial.seed, scene.empty() ? "" : ", ", scene, texts::one_line(arm),
                       trial.side == 0 ? "at home" : "away", decided.score[trial.side], decided.score[1 - trial.side]) +
           how_it_ended(decided, sides);
  }
  MatchPlayers players(const study::Round& round, std::uint64_t index) const override {
    const study::Trial trial = study::trial(plan_, index);
    MatchPlayers out = StudyReport::players(round, index);
    out.sides[trial.side] = label(plan_, trial.condition);
    return out;
  }

  std::string incomplete() const override {
    if (course_.complete()) return {};
    return fmt::format("{} of {} matches without a gap: the experiment is not at its end", course_.taken(),
                       plan_.matches());
  }

  // The table has a row for each number of each match of an arm's team (RFC 4180, but lines end with \n).
  std::string begin_table(const TableOptions& options) override {
    all_metrics_ = options.all_metrics;
    return fmt::format("row,{},seed,side,opening,ended,measure,value\n", head_of_arm(plan_));
  }
  std::string table_lines(const study::Round& /*round*/, std::uint64_t index,
                          const campaign::MatchResult& decided) override {
    const study::Trial trial = study::trial(plan_, index);
    const std::string before =
        fmt::format("{},{},{},{},{},{},", index + 1, arm_fields(plan_, trial.condition), trial.seed,
                    trial.side == 0 ? "home" : "away", csv_field(scene_name(plan_.openings, trial.opening)),
                    csv_field(decided.ended));
    std::string out;
    const auto line = [&](const std::string& measure, double value) {
      out += fmt::format("{}{},{}\n", before, csv_field(measure), value);
    };
    if (decided.failure || decided.set_aside()) return before + ",\n";  // a match without numbers gets only one line
    const study::MatchMeasures played(decided, static_cast<int>(trial.side));
    const std::string always = "playing_seconds";
    line(always, played.playing_seconds());
    if (!all_metrics_) {
      for (const std::string& measure : plan_.measures) {
        if (const auto value = played.value(measure)) line(measure, *value);
      }
      return out;
    }
    for (const study::NamedValue& each : played.all()) line(each.path, each.value);
    for (const study::NamedValue& each : study::metric_values_of_match(decided.metrics)) {
      if (each.path != always) line(each.path, each.value);
    }
    return out;
  }

  std::string summary_table() const override { return experiment_summary_csv(view()); }

  std::vector<Figure> figures() const override { return experiment_figures(view()); }

 private:
  campaign::Job job(std::uint64_t index) const { return study::job(plan_, study::trial(plan_, index)); }
  ExperimentView view() const {
    return {plan_, course_, [this](std::uint64_t index) { return again_(job(index)); }};
  }

  study::ExperimentPlan plan_;
  study::Experiment course_;
  CommandOf again_;
  bool all_metrics_ = false;  // option of the table in progress
};

}  // namespace

std::unique_ptr<StudyReport> experiment_report(study::ExperimentPlan plan, CommandOf again) {
  return std::make_unique<ExperimentReport>(std::move(plan), std::move(again));
}

std::string experiment_summary_csv(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  std::string out = fmt::format("measure,unit,{},pairs,mean,low,high,mean_per_match\n", head_of_arm(plan));
  const auto number = [](bool known, double value) { return known ? fmt::format("{}", value) : std::string(); };
  for (std::size_t measure = 0; measure < plan.measures.size(); ++measure) {
    for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
      const study::MeanEstimate mean = view.course.mean(i, measure);
      const study::MeanEstimate per_match = study::mean_of(view.course.per_match(i, measure), plan.asked.confidence);
      const bool known = mean.interval.has_value();
      out += fmt::format("{},{},{},{},{},{},{},{}\n", csv_field(plan.measures[measure]),
                         study::unit_of(plan.measures[measure]), arm_fields(plan, i), mean.pairs,
                         number(mean.pairs > 0, mean.mean), number(known, known ? mean.interval->low : 0.0),
                         number(known, known ? mean.interval->high : 0.0), number(per_match.pairs > 0, per_match.mean));
    }
  }
  return out;
}

}  // namespace regista::report
