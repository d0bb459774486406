// SPDX-License-Identifier: MIT
#include "report/experiment_report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "report/experiment.hpp"
#include "report/experiment_figures.hpp"
#include "report/fingerprint.hpp"
#include "report/match_remarks.hpp"
#include "study/experiment.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

class ExperimentReport final : public StudyReport {
 public:
  ExperimentReport(study::ExperimentPlan plan, CommandOf again)
      : plan_(std::move(plan)), course_(plan_), again_(std::move(again)) {}
  ExperimentReport(const ExperimentReport&) = delete;
  ExperimentReport& operator=(const ExperimentReport&) = delete;

  study::Study& study() override { return course_; }
  const study::Study& study() const override { return course_; }

  std::vector<std::string> teams() const override {
    std::vector<std::string> out;
    for (const config::Experiment::Arm& each : plan_.asked.arms) out.push_back(each.name);
    out.push_back(plan_.asked.opponent);
    return out;
  }
  WhatWasPlayed played() const override { return what_was_played(plan_); }
  Outline outline() const override { return experiment_outline(view()); }
  Outline page_outline(const PageFiles& /*files*/) const override {
    Outline out = outline();
    out.fingerprint = fingerprint_.text();
    return out;
  }
  std::vector<std::string> notes() const override;
  std::string standing() const override { return experiment_standing(view()); }
  std::string match(const study::Round& round, std::uint64_t index, const campaign::Decided& decided) const override;

  std::string incomplete() const override {
    if (course_.complete()) return {};
    return fmt::format("{} of {} matches without a gap: the experiment is not at its end", course_.taken(),
                       plan_.matches());
  }

  std::string begin_table(const TableWish& wish) override {
    measures_ = wish.all_metrics ? CsvMeasures::all : CsvMeasures::shown;
    return experiment_csv_head(plan_);
  }
  std::string table_lines(const study::Round& /*round*/, std::uint64_t index,
                          const campaign::Decided& decided) override {
    return experiment_csv_lines(plan_, index, decided, measures_);
  }

  std::string summary_table() const override { return experiment_summary_csv(view()); }

  void take(const study::Round& /*round*/, std::uint64_t index, const campaign::Decided* decided) override {
    fingerprint_.take(index, *decided);
  }
  std::vector<Figure> figures() const override { return experiment_figures(view()); }

 private:
  campaign::Job job(std::uint64_t index) const { return study::job(plan_, study::trial(plan_, index)); }
  ExperimentView view() const {
    return {plan_, course_, [this](std::uint64_t index) { return again_(job(index)); }};
  }

  study::ExperimentPlan plan_;
  study::Experiment course_;
  CommandOf again_;
  CsvMeasures measures_ = CsvMeasures::shown;  // of the table that was begun
  Fingerprint fingerprint_;
};

std::vector<std::string> ExperimentReport::notes() const {
  std::vector<std::string> out;
  for (const study::Comparison& each : plan_.comparisons()) {
    if (!study::equal_conditions(plan_, each)) continue;
    out.push_back(fmt::format("A/A: {} and {} are equal, so they do not differ by construction",
                              texts::one_line(label(plan_, each.first)), texts::one_line(label(plan_, each.second))));
  }
  return out;
}

std::string ExperimentReport::match(const study::Round& /*round*/, std::uint64_t index,
                                    const campaign::Decided& decided) const {
  const study::Trial trial = study::trial(plan_, index);
  const std::string scene =
      plan_.openings.empty() ? "" : ", " + std::filesystem::path(plan_.openings[trial.opening].file).stem().string();
  const std::string arm = label(plan_, trial.condition);
  std::string out =
      fmt::format("seed {}{}: {} {} {}:{}", trial.seed, scene, texts::one_line(arm),
                  trial.side == 0 ? "at home" : "away", decided.score[trial.side], decided.score[1 - trial.side]);
  if (decided.set_aside()) out += ", could not be played: " + texts::one_line(decided.why_set_aside);
  if (decided.failure) {
    const bool own = static_cast<std::size_t>(decided.failure->side) == trial.side;
    out += ", " + forfeit_text(own ? arm : "the opponent", *decided.failure);
  }
  return out;
}

}  // namespace

std::unique_ptr<StudyReport> experiment_report(study::ExperimentPlan plan, CommandOf again) {
  return std::make_unique<ExperimentReport>(std::move(plan), std::move(again));
}

}  // namespace regista::report
