// SPDX-License-Identifier: MIT
// Matches that are played together: some candidates on the same pairs, each against every opponent, at home and away.
// What comes of them is a score for each candidate and pair.
//
// Order: pair after pair; in each, every candidate; of each, every opponent; home, then away.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/store.hpp"
#include "study/forfeits.hpp"
#include "study/match_remarks.hpp"
#include "study/packets_spent.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

// Which pairs a batch plays: `first` and those after it.
struct PairRange {
  TuningStage stage = TuningStage::search;
  std::uint64_t first_seed = 0;  // below 2^32
  std::uint64_t first = 0, count = 1;

  std::uint64_t seed(std::uint64_t pair) const {
    return static_cast<std::uint64_t>(stage) << 50 | (first_seed + first + pair);
  }
};

// For whoever plays: fixtures, and the matches in order.
struct MatchList {
  struct Match {
    std::size_t fixture;
    std::uint64_t seed;
  };
  std::vector<campaign::Store::Fixture> fixtures;
  std::vector<Match> matches;
  std::uint64_t first_row = 0;  // place of the first of them among all of the study

  campaign::Job job(std::size_t index) const {
    campaign::Job out = fixtures[matches[index].fixture].job;
    out.seed = matches[index].seed;
    return out;
  }
};

// Plays them, or reads them, and hands each on in order. False from `take`: enough. What it throws ends the tuning.
using TakeMatch = std::function<bool(std::uint64_t index, const campaign::Decided& decided)>;
using PlayMatches = std::function<void(const MatchList& matches, const TakeMatch& take)>;

class PairBatch {
 public:
  // head_to_head: the only opponent is the base team. The plan outlives the batch.
  PairBatch(const TuningPlan& plan, const TunedDocument& document, const std::vector<ParameterValues>& candidates,
            const PairRange& pairs, bool head_to_head = false);

  const MatchList& list() const { return list_; }
  MatchList& list() { return list_; }

  // Precondition: match 0, then 1, ... True when a pair has been completed for all candidates.
  bool take(const campaign::Decided& decided, ForfeitList& forfeits, MatchRemarks& remarks);

  std::uint64_t pairs() const { return pairs_done_; }
  // By pair; not a number where a match has none, as that of an opponent that forfeits. Head-to-head: the candidate's
  // own less the base team's.
  const std::vector<double>& scores(std::size_t candidate) const { return scores_[candidate]; }
  // By pair: a match of it could not be played, so that its score is missing.
  const std::vector<bool>& unplayed(std::size_t candidate) const { return unplayed_[candidate]; }
  std::uint64_t unplayed_pairs() const { return unplayed_pairs_; }  // of all candidates
  // Of this candidate, in its matches.
  const PacketsSpent& packets(std::size_t candidate) const { return packets_[candidate]; }
  // A match of this candidate was forfeited by it.
  bool failed(std::size_t candidate) const { return failed_[candidate]; }

 private:
  void add_fixtures(const TunedDocument& document, const std::vector<ParameterValues>& candidates,
                    const std::vector<std::size_t>& scenes);
  double score(const campaign::Decided& away, bool of_opponent) const;

  const TuningPlan& plan_;
  std::span<const TuningOpponent> opponents_;
  bool head_to_head_;
  std::optional<ScoreBounds> bounds_;  // of scores that are no differences
  MatchList list_;
  std::vector<std::vector<double>> scores_;  // by candidate
  std::vector<std::vector<bool>> unplayed_;  // by candidate
  PacketsOfShortGames short_games_;
  std::vector<PacketsSpent> packets_;  // by candidate
  std::vector<bool> failed_;
  std::uint64_t next_ = 0, pairs_done_ = 0, unplayed_pairs_ = 0;
  campaign::Decided home_;  // of the two matches under way, the first
  double sum_ = 0.0;        // over the opponents of the candidate under way
  bool broken_ = false;     // one of its matches could not be played
};

}  // namespace regista::study
