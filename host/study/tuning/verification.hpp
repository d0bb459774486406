// SPDX-License-Identifier: MIT
// Whether candidates are better than the base team, pair by pair on held-out seeds: a sequential test
// of a difference of 0, valid however often one looks, adjusted by Holm for the number of candidates. Differences that
// have bounds can be tested by betting on their mean (statistics/betting.hpp), which holds for any law; else they are
// taken to be symmetric (statistics/symmetric_test.hpp), which finds sooner.
#pragma once

#include <array>
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

// prevented: it would be decided but for pairs that could not be played.
enum class VerifiedAs { undecided, better, worse, prevented };

// One candidate's scores and the base team's.
class ScoreDifference {
 public:
  // deviation: of a difference, expected. alpha: of the test. several: so many intervals hold together. widest: the
  // largest difference there can be, tested by betting; nothing: by symmetry. bound: the same, whatever the test;
  // nothing: there is no bound.
  ScoreDifference(double deviation, double alpha, std::size_t several, std::optional<double> widest,
                  std::optional<double> bound);

  void add(double candidate, double base);
  // A pair that could not be played. It is not counted, but from the first one on the test is also fed with all of them
  // counted for the base team, and for the candidate: as the largest difference there can be. Where there is no bound,
  // nothing says what such a pair might have shown: then nothing can be found any more.
  void add_unplayed();

  const statistics::Moments& candidate() const { return candidate_; }
  const statistics::Moments& base() const { return base_; }
  const statistics::Moments& difference() const { return counted_.seen; }
  statistics::Estimate estimate() const;     // of the mean difference, at all times together
  double p() const { return counted_.p(); }  // of "no difference", two-sided, valid at all times, not adjusted
  bool candidate_more() const { return counted_.candidate_more(); }  // as the strongest evidence pointed
  std::uint64_t unplayed_pairs() const { return unplayed_; }
  // The largest of p() and its likes with those pairs counted for either; 1 where these point to different sides.
  double p_either_way() const;

 private:
  struct OnMean {
    statistics::BettingTest test;
    statistics::BettingGrid sequence;
  };
  struct Evidence {
    std::variant<statistics::SymmetricTest, OnMean> test;
    statistics::Moments seen;  // differences

    void add(double difference);
    double p() const;
    bool candidate_more() const;
  };
  statistics::Moments candidate_, base_;
  Evidence counted_;
  std::optional<double> bound_;
  std::optional<std::array<Evidence, 2>> either_way_;  // those pairs counted for the base team, for the candidate
  std::uint64_t unplayed_ = 0;
};

// Its test is two-sided with a probability of 1 - confidence for any false finding at all; intervals hold for all
// candidates together.
class Verification {
 public:
  // deviation: what the standard deviation of a candidate's score over pairs is expected to be, above 0; from matches
  // that decide nothing here.
  // widest, bound: see ScoreDifference.
  Verification(std::size_t candidates, double confidence, double deviation, std::optional<double> widest = {},
               std::optional<double> bound = {});

  // Scores of a pair, of all candidates; not a number: its match has none, and the pair is left out for it.
  // Head-to-head these are differences already, and the base's are 0. unplayed: of which candidates the pair, their own
  // or that of the base team they are compared with, could not be played; empty: of none.
  void add(double base, std::span<const double> candidates, const std::vector<bool>& unplayed = {});

  std::uint64_t pairs() const { return pairs_; }
  const std::vector<ScoreDifference>& of() const { return of_; }  // by candidate
  std::vector<double> adjusted() const;                           // p either way by Holm, by candidate
  std::uint64_t unplayed_pairs() const { return unplayed_; }      // of any candidate, or the base team
  std::vector<VerifiedAs> findings() const;
  // Nothing more is needed: all candidates are decided, or will never be.
  bool decided() const;

 private:
  double alpha_;
  std::vector<ScoreDifference> of_;
  std::optional<double> bound_;
  std::uint64_t pairs_ = 0, unplayed_ = 0;
};

}  // namespace regista::study
