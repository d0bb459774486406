// SPDX-License-Identifier: MIT
// The course of an experiment: takes the results in the order of the schedule and keeps, for every condition and
// measure, one value per pair of matches: of a time its minutes in 60 minutes of play, summed over both matches; of
// everything else the mean of the two. A pair with a forfeited match has no values: what a match would have shown is
// not known. Neither has one with a match that could not be played; but of these nobody may gain, so findings have to
// hold whatever they would have shown (either_way.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "campaign/job.hpp"
#include "study/experiment_plan.hpp"
#include "study/forfeits.hpp"
#include "study/match_remarks.hpp"
#include "study/measure.hpp"
#include "study/packets_spent.hpp"
#include "study/paired_estimates.hpp"
#include "study/study.hpp"

namespace regista::study {

class Experiment final : public Study {
 public:
  // The plan outlives it.
  explicit Experiment(const ExperimentPlan& plan);

  const char* what() const override { return "experiment"; }
  std::string unplayable() const override { return unplayable_; }
  std::uint64_t most_matches() const override { return plan_.matches(); }
  std::uint64_t counted() const override { return next_; }
  campaign::Metrics metrics() const override { return campaign::Metrics::wanted; }
  campaign::Limits limits() const override { return plan_.limits(); }
  const std::string& folder() const override { return plan_.folder; }
  std::string plan() const override { return to_json(plan_); }
  std::vector<std::string> differences(const std::string& before) const override {
    return study::differences(experiment_plan_from_json(before), plan_);
  }
  void run(const PlayRound& play) override;

  // Precondition: match 0, then 1, ...
  void take(const campaign::Decided& decided);

  std::uint64_t taken() const { return next_; }
  bool complete() const { return next_ == plan_.matches(); }

  // By pair, in the unit of the measure; no number where it is missing. measure: index into the plan's measures.
  std::span<const double> values(std::size_t condition, std::size_t measure) const;
  // The mean of the matches of a pair as they stand: times in seconds.
  std::span<const double> per_match(std::size_t condition, std::size_t measure) const;

  MeanEstimate mean(std::size_t condition, std::size_t measure) const;
  MeanEstimate difference(const Comparison& comparison, std::size_t measure) const;

  // In the phase Playing: of all matches that were not forfeited; nothing before the first of them.
  double playing_seconds(std::size_t condition) const { return playing_seconds_[condition]; }
  std::optional<double> playing_seconds_of_a_match(std::size_t condition) const;
  // Of its team in short games, in pairs that have values; of none where they are whole matches.
  const PacketsSpent& packets(std::size_t condition) const { return packets_[condition]; }
  const ForfeitList& forfeits() const { return forfeits_; }  // by condition; last: the opponent
  const MatchRemarks& remarks() const { return remarks_; }
  // By pair: a match of it could not be played.
  const std::vector<bool>& unplayed(std::size_t condition) const { return unplayed_[condition]; }
  std::uint64_t unplayed_pairs(std::size_t condition) const;
  std::uint64_t unplayed_pairs() const;  // of all conditions

 private:
  struct Values {
    std::vector<double> in_unit, per_match;  // by pair
  };
  const Values& at(std::size_t condition, std::size_t measure) const;

  const ExperimentPlan& plan_;
  std::vector<Values> values_;  // by condition, then measure
  std::vector<double> playing_seconds_;
  std::vector<std::uint64_t> played_;     // matches that were not forfeited, by condition
  std::vector<PacketsSpent> packets_;     // by condition
  std::optional<MatchMeasures> at_home_;  // of the pair under way
  bool at_home_unplayed_ = false;
  std::vector<std::vector<bool>> unplayed_;  // by condition, then pair
  std::vector<std::uint64_t> set_aside_;     // matches, by condition
  std::string unplayable_;
  ForfeitList forfeits_;
  MatchRemarks remarks_;
  std::uint64_t next_ = 0;
};

// What the test says about one comparison of the primary measure.
struct Finding {
  Comparison comparison;
  MeanEstimate difference;
  // Without pairs that could not be played; adjusted: by Holm, for all comparisons of the plan, and with these pairs
  // counted for whichever side makes it larger.
  std::optional<double> p, adjusted;
  PairMethod by = PairMethod::student_t;
  bool found = false;                // adjusted <= 1 - confidence
  std::uint64_t unplayed_pairs = 0;  // of either condition
  bool prevented = false;            // it would be found but for these pairs
};

// Of all comparisons, in the plan's order; empty without a primary measure. p and adjusted only of an experiment that
// was played to its end: its number of matches was fixed beforehand, that of one that was stopped was not.
std::vector<Finding> findings(const ExperimentPlan& plan, const Experiment& course);

// Index of the primary measure; nothing where there is none.
std::optional<std::size_t> primary_measure(const ExperimentPlan& plan);

}  // namespace regista::study
