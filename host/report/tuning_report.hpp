// SPDX-License-Identifier: MIT
// The report of a tuning: its numbers, which text, JSON, figures and page share, and its sentences. A sentence calls
// values "better" only if they were better on seeds that the search did not use. No sentence claims that two
// teams are equal. The report contains no times and no rates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/match_remarks.hpp"
#include "report/outline.hpp"
#include "report/study_report.hpp"
#include "study/paired_estimates.hpp"
#include "study/tuning/tuning_plan.hpp"
#include "study/tuning/tuning_study.hpp"

namespace regista::report {

struct TuningView {
  const study::TuningPlan& plan;
  const study::TuningRecord& record;
  std::string tuned_file;  // path of the tuned team's file; empty: no file was written
};

// Converts scores of the study, or differences of scores, into values of the user's objective. A larger score is always
// better, so these functions change the sign if the user minimises the objective.
double of_objective(const study::TuningObjective& objective, double score);
statistics::Estimate of_objective(const study::TuningObjective& objective, const statistics::Estimate& score);
study::MeanEstimate of_objective(const study::TuningObjective& objective, study::MeanEstimate score);

// Returns "per match" or "min per 60 min"; empty for a weighted sum, because its terms have different units.
std::string unit_of(const study::TuningObjective& objective);

// The numbers of counted matches in each stage. A verification that stops early counts fewer matches than it requested.
struct MatchesByStage {
  std::uint64_t search = 0, selection = 0, verification = 0, slices = 0;
};
MatchesByStage matches_by_stage(const TuningView& view);

// Returns the best evaluation so far, or null before the first evaluation. The value of this evaluation is too
// optimistic, because it is the largest of many noisy values.
const study::SearchStep* best_step(const study::TuningRecord& record);

enum class RangeEnd { none, lower, upper };
struct TunedValue {
  std::size_t parameter = 0;  // index of the parameter in the plan
  double base = 0.0, tuned = 0.0;
  RangeEnd at = RangeEnd::none;  // end of the range if `tuned` is closer to this end than a hundredth of the range
};
// Returns the base and tuned values of the free parameters. The tuned values are those of the finalist record.tuned():
// the first candidate found better than the base team, or else the first. Empty if there are no candidates.
std::vector<TunedValue> tuned_values(const TuningView& view);

// Returns the index of the finalist whose values are the centre of the slices: record.tuned() or, if there are no
// candidates, the first finalist. Returns nothing if there are no finalists.
std::optional<std::size_t> slice_centre(const study::TuningRecord& record);

// The result of the verification for one finalist. A finalist in the verification is called a candidate.
struct CandidateVerdict {
  std::size_t candidate = 0, finalist = 0;
  study::VerifiedAs finding = study::VerifiedAs::undecided;
  bool forfeited = false;                          // true: the candidate forfeited a match of the verification
  study::PacketsSpent packets;                     // packets in the verification
  std::optional<study::MeanEstimate> seen;         // candidate's value in the search
  study::MeanEstimate selected;                    // candidate's value in the selection
  std::optional<study::MeanEstimate> value, base;  // values of candidate and base team in the verification; missing if
                                                   // candidate and base team play each other
  std::int64_t pairs = 0;                          // number of pairs in which candidate and base team have a value
  statistics::Estimate difference;  // candidate minus base team, valid at any time; infinite without pairs
  double p = 1.0, adjusted = 1.0;
  // The score in the search minus the score in the verification. If candidate and base team play each other, the score
  // in the selection replaces the score in the verification. Positive: the search was too optimistic.
  std::optional<double> optimism;
};
std::vector<CandidateVerdict> candidate_verdicts(const TuningView& view);

WhatWasPlayed what_was_played(const study::TuningPlan& plan);
ForfeitWords forfeit_words(const study::TuningPlan& plan);  // the result refers to the plan, which must outlive it

// "weights: 3 parameters of paper.yaml, goal_difference as large as possible"
std::string problem_title(const study::TuningPlan& plan);

std::vector<Sentence> setup_sentences(const study::TuningPlan& plan);  // about objective, search, verification, budget
std::vector<Sentence> search_sentences(const TuningView& view);        // about end and best value of the search

struct TuningVerdict {
  std::string headline;
  std::vector<std::string> beside;  // sentences about each candidate, then explanations of the numbers
};
TuningVerdict tuning_verdict(const TuningView& view);

const char* name(study::VerifiedAs finding);                // for example "undecided"
bool has_unit(const study::Parameter& parameter);           // false if the unit is "1", a plain number
std::string range_text(const study::Parameter& parameter);  // for example "0.1 to 10 m"
std::string importance_text(const study::Slice& slice);     // for example "no more than chance"
bool more_than_chance(const study::Slice& slice);
std::string slices_note(const TuningView& view);

// Returns a few lines about a running tuning: stage, evaluation, best value so far, finalists, verification.
std::string tuning_standing(const TuningView& view);

Outline tuning_outline(const TuningView& view);  // also of a tuning that has not ended

// Returns the trace of the search as a table: a header, then a line for each evaluation.
std::string tuning_csv(const TuningView& view);

// Returns the figures that have data: "verification", "convergence", "history_1", ... (one for each parameter),
// "importance", and "slice_1", ... (one for each parameter, the most important parameter first).
std::vector<Figure> tuning_figures(const TuningView& view);
bool is_tuning_figure(std::string_view name);  // whether a figure of some tuning may have this name

class TuningReport final : public StudyReport {
 public:
  // out_of_time: time limit of the search; see study/tuning/pair_search.hpp.
  TuningReport(study::TuningPlan plan, study::OutOfTime out_of_time)
      : plan_(std::move(plan)), study_(plan_, std::move(out_of_time)) {}

  study::TuningStudy& study() override { return study_; }
  const study::TuningStudy& study() const override { return study_; }
  const study::TuningPlan& plan() const { return plan_; }
  const study::TuningRecord& record() const { return study_.record(); }
  // Sets the path of the file to which the tuned team was written.
  void tuned_file(std::string file) { tuned_file_ = std::move(file); }

  WhatWasPlayed played() const override;
  Outline outline() const override { return tuning_outline(view()); }
  std::vector<std::string> notes() const override;
  std::string standing() const override { return tuning_standing(view()); }
  std::string match(const study::Round& round, std::uint64_t index,
                    const campaign::MatchResult& decided) const override;
  MatchPlayers players(const study::Round& round, std::uint64_t index) const override;
  std::string incomplete() const override;

  bool is_table_of_matches() const override { return false; }
  std::string end_table() const override { return tuning_csv(view()); }
  std::vector<Figure> figures() const override { return tuning_figures(view()); }

 private:
  TuningView view() const { return {plan_, record(), tuned_file_}; }

  study::TuningPlan plan_;
  study::TuningStudy study_;
  std::string tuned_file_;
};

// --- The file of the tuned team. The file has a comment on its origin, then the differences from the base team.

inline constexpr std::string_view tuned_file_begin = "# Tuned by Regista";  // first text of such files

// Returns the content of `file`. The content names the base team's file relative to the folder of `file`. program:
// version of the program that searched. fingerprint: hash of the results. Precondition: record.tuned() has a value.
std::string tuned_file_text(const std::filesystem::path& file, const study::TuningPlan& plan,
                            const study::TuningRecord& record, const std::string& program,
                            const std::string& fingerprint);

}  // namespace regista::report
