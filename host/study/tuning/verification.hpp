// SPDX-License-Identifier: MIT
// Whether candidates are better than the base team, pair by pair on seeds that nobody has chosen by: a sequential test
// of a difference of 0, valid however often one looks, adjusted by Holm for the number of candidates. Differences that
// have bounds can be tested by betting on their mean (statistics/betting.hpp), which holds for any law; else they are
// taken to be symmetric (statistics/symmetric_test.hpp), which finds sooner.
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
#include "statistics/symmetric_test.hpp"

namespace regista::study {

enum class VerifiedAs { undecided, better, worse };

// One candidate's scores and the base team's.
class ScoreDifference {
 public:
  // deviation: of a difference, expected. alpha: of the test. several: so many intervals hold together. widest: the
  // largest difference there can be, tested by betting; nothing: by symmetry.
  ScoreDifference(double deviation, double alpha, std::size_t several, std::optional<double> widest);

  void add(double candidate, double base);

  const statistics::Moments& candidate() const { return candidate_; }
  const statistics::Moments& base() const { return base_; }
  const statistics::Moments& difference() const { return difference_; }
  statistics::Estimate estimate() const;  // of the mean difference, at all times together
  double p() const;                       // of "no difference", two-sided, valid at all times, not adjusted
  bool candidate_more() const;            // as the strongest evidence pointed

 private:
  struct OnMean {
    statistics::BettingTest test;
    statistics::BettingGrid sequence;
  };
  statistics::Moments candidate_, base_, difference_;
  std::variant<statistics::SymmetricTest, OnMean> test_;
};

// Its test is two-sided with a probability of 1 - confidence for any false finding at all; intervals hold for all
// candidates together.
class Verification {
 public:
  // deviation: what the standard deviation of a candidate's score over pairs is expected to be, above 0; from matches
  // that decide nothing here.
  // widest: see ScoreDifference.
  Verification(std::size_t candidates, double confidence, double deviation, std::optional<double> widest = {});

  // Scores of a pair, of all candidates; not a number: its match has none, and the pair is left out for it.
  // Head-to-head these are differences already, and the base's are 0.
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
