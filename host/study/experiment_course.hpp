// SPDX-License-Identifier: MIT
// The course of an experiment: what its results so far add up to. The class Experiment takes the results in the order
// of the schedule. For every condition and measure, it keeps one value per pair of matches. For a measure of time, this
// value is in minutes per 60 minutes of play in both matches. For any other measure, this value is the mean over both
// matches. A pair with a forfeit has no values, because the result without the forfeit is unknown. A pair with a match
// that could not be played has no values either. No side may gain by such a pair, so a finding must hold for every
// result that the pair could have had (paired_estimates.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "campaign/job.hpp"
#include "study/experiment_plan.hpp"
#include "study/measure.hpp"
#include "study/paired_estimates.hpp"
#include "study/study.hpp"

namespace regista::study {

class Experiment final : public Study {
 public:
  // The plan must outlive this object.
  explicit Experiment(const ExperimentPlan& plan);

  const char* what() const override { return "experiment"; }
  std::string unplayable() const override { return unplayable_; }
  std::uint64_t most_matches() const override { return end(); }
  std::uint64_t counted() const override { return next_; }
  campaign::Metrics metrics() const override { return campaign::Metrics::wanted; }
  campaign::Limits limits() const override { return plan_.limits(); }
  const std::string& folder() const override { return plan_.folder; }
  std::string plan() const override { return to_json(plan_); }
  std::vector<std::string> differences(const std::string& before) const override {
    return study::differences(experiment_plan_from_json(before), plan_);
  }
  void run(const PlayRound& play) override;

  // Precondition: the caller passes match 0, 1, ... in this order.
  void take(const campaign::MatchResult& decided);

  std::uint64_t taken() const { return next_; }
  bool complete() const { return next_ >= end(); }

  // Values by pair, in the unit of the measure; NaN if a pair has no value. measure: index into the plan's measures.
  std::span<const double> values(std::size_t condition, std::size_t measure) const {
    return conditions_[condition].values[measure].in_unit;
  }
  // For each pair, the mean of the measure over both matches. A time is in seconds.
  std::span<const double> per_match(std::size_t condition, std::size_t measure) const {
    return conditions_[condition].values[measure].per_match;
  }

  MeanEstimate mean(std::size_t condition, std::size_t measure) const;
  MeanEstimate difference(const Comparison& comparison, std::size_t measure) const;
  // The slope of a measure over the values of the sweep, for one arm. Precondition: has_trends(plan).
  MeanEstimate slope(std::size_t arm, std::size_t measure) const;

  // Seconds in the phase Playing: sum and mean over matches without a forfeit (mean: nullopt without such a match).
  double playing_seconds(std::size_t condition) const { return conditions_[condition].playing_seconds; }
  std::optional<double> playing_seconds_of_a_match(std::size_t condition) const;
  // The packets that the condition's team sent in short games (measure.hpp). Only pairs with values count.
  const PacketsSpent& packets(std::size_t condition) const { return conditions_[condition].packets; }
  const ForfeitList& forfeits() const { return forfeits_; }  // teams: the conditions, then the opponent
  const MatchRemarks& remarks() const { return remarks_; }
  // For each pair, whether a match of the pair could not be played.
  const std::vector<bool>& unplayed(std::size_t condition) const { return conditions_[condition].unplayed; }
  std::uint64_t unplayed_pairs(std::size_t condition) const;
  std::uint64_t unplayed_pairs() const;  // sum over all conditions

 private:
  struct Values {
    std::vector<double> in_unit, per_match;  // by pair
  };
  struct OfCondition {
    std::vector<Values> values;  // by measure
    double playing_seconds = 0.0;
    std::uint64_t played = 0, set_aside = 0;  // matches that were played to the end; that could not be played
    PacketsSpent packets{};
    std::vector<bool> unplayed{};  // by pair
  };
  std::uint64_t end() const { return 2 * plan_.pairs_to_its_end() * plan_.conditions.size(); }

  const ExperimentPlan& plan_;
  std::vector<OfCondition> conditions_;
  std::optional<MatchMeasures> at_home_;  // measures of the home match of the current pair
  bool at_home_unplayed_ = false;
  std::string unplayable_;
  ForfeitList forfeits_;
  MatchRemarks remarks_;
  std::uint64_t next_ = 0;
};

// The test result of one comparison or one trend of the primary measure.
struct Tested {
  // p: the p-value without the unplayed pairs. adjusted: the largest p-value with the unplayed pairs counted for either
  // side (p_either_way()), adjusted by Holm's method for all comparisons and trends of the plan.
  std::optional<double> p, adjusted;
  PairMethod by = PairMethod::student_t;
  bool found = false;                // adjusted <= 1 - confidence
  std::uint64_t unplayed_pairs = 0;  // pairs not played in one or more of the tested conditions
  bool prevented = false;            // true: the test finds a difference only if it omits unplayed pairs
};

struct Finding : Tested {
  Comparison comparison;
  MeanEstimate difference;
};

struct Trend : Tested {
  std::size_t arm = 0;
  MeanEstimate slope;  // change of the measure, in its unit, if the swept value grows by 1
};

// All findings in the order of the plan. Each arm has a trend if has_trends(plan) (paired_estimates.hpp).
struct Findings {
  std::vector<Finding> comparisons;
  std::vector<Trend> trends;
};

// The result is empty if the plan has no primary measure. p and adjusted have values only after the last match of the
// experiment, because the test needs a number of matches that was fixed beforehand.
Findings findings(const ExperimentPlan& plan, const Experiment& course);

// Indices of the measure with this name and of the primary measure; nullopt if the plan does not have it.
std::optional<std::size_t> measure_index(const ExperimentPlan& plan, const std::string& measure);
std::optional<std::size_t> primary_measure(const ExperimentPlan& plan);

}  // namespace regista::study
