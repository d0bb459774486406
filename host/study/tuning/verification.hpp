// SPDX-License-Identifier: MIT
// Whether candidates are better than the base team, pair by pair on seeds that nobody has chosen by: a sequential test of
// a mean difference of 0, valid however often one looks, adjusted by Holm for the number of candidates.
//
// Scores that have bounds (points, goal differences) are tested by betting on their mean; of those that have none the
// signs are, which holds for any law.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "statistics/betting.hpp"
#include "statistics/betting_grid.hpp"
#include "statistics/interval.hpp"
#include "statistics/moments.hpp"
#include "study/metric_difference.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

enum class VerifiedAs { undecided, better, worse };

// One candidate's scores and the base team's.
class ScoreDifference {
 public:
  // alpha: of the test. several: so many candidates share the confidence of the interval.
  ScoreDifference(const TuningPlan& plan, double alpha, std::size_t several);

  void add(double candidate, double base);

  const statistics::Moments& candidate() const { return candidate_; }
  const statistics::Moments& base() const { return base_; }
  const statistics::Moments& difference() const { return difference_; }
  // Of the mean difference, at all times together, for all candidates together.
  statistics::Estimate estimate() const;
  double p() const;            // of "no difference", two-sided, valid at all times, not adjusted
  bool candidate_more() const; // as the evidence points

 private:
  struct OnMean {
    statistics::BettingTest test;
    statistics::BettingGrid sequence;
  };
  statistics::Moments candidate_, base_, difference_;
  std::variant<OnMean, MetricDifference> test_;
};

class Verification {
 public:
  Verification(const TuningPlan& plan, std::size_t candidates);

  // Scores of a pair, of all candidates; not a number: its match has none, and the pair is left out for it. Head-to-head
  // these are differences already, and the base's are 0.
  void add(double base, std::span<const double> candidates);

  std::uint64_t pairs() const { return pairs_; }
  const std::vector<ScoreDifference>& of() const { return of_; }  // by candidate
  std::vector<double> adjusted() const;                           // p by Holm, by candidate
  std::vector<VerifiedAs> findings() const;
  // Nothing more is needed: all candidates are decided.
  bool decided() const;

 private:
  double alpha_;
  std::vector<ScoreDifference> of_;
  std::uint64_t pairs_ = 0;
};

}  // namespace regista::study
