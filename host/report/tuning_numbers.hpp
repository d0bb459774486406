// SPDX-License-Identifier: MIT
// The numbers that a report shows of a tuning, worked out once for its text, its JSON, its figures and its page; values
// of the objective, and differences of them, as the user's objective has them: within a study of numbers a larger score
// is better, so of a minimised objective the sign is turned back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/tuning.hpp"
#include "statistics/interval.hpp"
#include "study/paired_estimates.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::report {

// From scores, or differences of scores.
double of_objective(const study::TuningObjective& objective, double score);
statistics::Estimate of_objective(const study::TuningObjective& objective, const statistics::Estimate& score);
study::MeanEstimate of_objective(const study::TuningObjective& objective, study::MeanEstimate score);

// "per match", "min per 60 min"; empty for a weighted sum, whose terms have units of their own.
std::string unit_of(const study::TuningObjective& objective);

// Matches that the report rests on, by stage. A verification that stopped early has asked for more.
struct MatchesByStage {
  std::uint64_t search = 0, selection = 0, verification = 0, slices = 0;
};
MatchesByStage matches_by_stage(const TuningView& view);

// The evaluation that the search thinks best so far: its value is the largest of many noisy ones. Nothing before the
// first.
const study::SearchStep* best_step(const study::TuningRecord& record);

enum class RangeEnd { none, lower, upper };
struct TunedValue {
  std::size_t parameter = 0;  // of the plan; only those that could change
  double base = 0.0, tuned = 0.0;
  RangeEnd at = RangeEnd::none;  // within a hundredth of the range
};
// Of the finalist that is kept; empty where there is none.
std::vector<TunedValue> tuned_values(const TuningView& view);

// The slices' point: the finalist that is kept, or the first one. Nothing before there is one.
std::optional<std::size_t> slice_centre(const study::TuningRecord& record);

// What is said of a finalist that was verified.
struct CandidateVerdict {
  std::size_t candidate = 0, finalist = 0;
  study::VerifiedAs finding = study::VerifiedAs::undecided;
  bool forfeited = false;                   // a match of the verification
  study::PacketsSpent packets;              // in the verification
  std::optional<study::MeanEstimate> seen;  // in the search, which chose it by that
  study::MeanEstimate selected;             // on the pairs of the selection
  // On the pairs of the verification. Head to head there is the difference alone.
  std::optional<study::MeanEstimate> value, base;
  std::int64_t pairs = 0;           // that have both values
  statistics::Estimate difference;  // the candidate's less the base team's, at all times; without a pair infinite
  double p = 1.0, adjusted = 1.0;
  // What the search promised beyond what came out (where it is played head to head: at the selection); positive: too
  // much, whatever the objective.
  std::optional<double> optimism;
};
std::vector<CandidateVerdict> candidate_verdicts(const TuningView& view);

}  // namespace regista::report
