// SPDX-License-Identifier: MIT
// The report of a tuning.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "report/fingerprint.hpp"
#include "report/study_report.hpp"
#include "report/tuning.hpp"
#include "report/tuning_figures.hpp"
#include "report/tuning_sentences.hpp"
#include "study/tuning/tuning_study.hpp"

namespace regista::report {

class TuningReport final : public StudyReport {
 public:
  // out_of_time: of the search; see study/tuning/search_time.hpp.
  TuningReport(study::TuningPlan plan, study::OutOfTime out_of_time)
      : plan_(std::move(plan)), study_(plan_, std::move(out_of_time)) {}
  TuningReport(const TuningReport&) = delete;
  TuningReport& operator=(const TuningReport&) = delete;

  study::TuningStudy& study() override { return study_; }
  const study::TuningStudy& study() const override { return study_; }
  const study::TuningPlan& plan() const { return plan_; }
  const study::TuningRecord& record() const { return study_.record(); }
  const std::string& fingerprint() const { return fingerprint_.text(); }
  // Where the tuned team was written to.
  void tuned_file(std::string file) { tuned_file_ = std::move(file); }

  WhatWasPlayed played() const override { return what_was_played(plan_); }
  Outline outline() const override { return tuning_outline(view()); }
  Outline page_outline(const PageFiles& files) const override;
  std::vector<std::string> notes() const override;
  std::string standing() const override { return tuning_standing(view()); }
  std::string match(const study::Round& round, std::uint64_t index, const campaign::Decided& decided) const override;
  std::string incomplete() const override;

  bool is_table_of_matches() const override { return false; }
  std::string begin_table(const TableWish& /*wish*/) override { return {}; }
  std::string table_lines(const study::Round& /*round*/, std::uint64_t /*index*/,
                          const campaign::Decided& /*decided*/) override {
    return {};
  }
  std::string end_table() const override { return tuning_csv(view()); }

  void take(const study::Round& round, std::uint64_t index, const campaign::Decided* decided) override {
    fingerprint_.take(round.first_row + index, *decided);
  }
  std::vector<Figure> figures() const override { return tuning_figures(view()); }

 private:
  TuningView view() const { return {plan_, record(), tuned_file_}; }

  study::TuningPlan plan_;
  study::TuningStudy study_;
  Fingerprint fingerprint_;
  std::string tuned_file_;
};

}  // namespace regista::report
