// SPDX-License-Identifier: MIT
// A batch of matches that are played together. Several candidates play the same pairs, against every opponent, at home
// and away. The batch gives one score for each candidate and pair.
//
// The order of matches, from the outer to the inner loop, is: pairs, candidates, opponents, home and away.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "study/measure.hpp"
#include "study/paired_estimates.hpp"
#include "study/study.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

// The pairs of a batch: `count` pairs from pair `first` on.
struct PairRange {
  TuningStage stage = TuningStage::search;
  std::uint64_t first_seed = 0;  // below 2^32
  std::uint64_t first = 0, count = 1;

  std::uint64_t seed(std::uint64_t pair) const {
    return static_cast<std::uint64_t>(stage) << 50 | (first_seed + first + pair);
  }
};

class PairBatch {
 public:
  // head_to_head: true if the base team is the only opponent. The plan must outlive the batch.
  PairBatch(const TuningPlan& plan, const TunedDocument& document, const std::vector<ParameterValues>& candidates,
            const PairRange& pairs, bool head_to_head = false);
  PairBatch(const PairBatch&) = delete;  // the functions of round_ point to this object
  PairBatch& operator=(const PairBatch&) = delete;

  // The round with all matches of the batch. The caller sets `take`, and sets `first_row` if it is not 0.
  const Round& round() const { return round_; }
  Round& round() { return round_; }

  // Precondition: match 0, 1, ... in order. Returns true if the match completes a pair of all candidates.
  bool take(const campaign::MatchResult& decided, ForfeitList& forfeits, MatchRemarks& remarks);

  std::uint64_t pairs() const { return pairs_done_; }
  // For each pair, the score of the candidate or, if it plays the base team (head to head), its score minus the base
  // team's. NaN without a score, for example after a forfeit.
  const std::vector<double>& scores(std::size_t candidate) const { return scores_[candidate]; }
  // For each pair, whether the score is missing because a match could not be played.
  const std::vector<bool>& unplayed(std::size_t candidate) const { return unplayed_[candidate]; }
  std::uint64_t unplayed_pairs() const { return unplayed_pairs_; }  // sum over all candidates
  const PacketsSpent& packets(std::size_t candidate) const { return packets_[candidate]; }
  bool failed(std::size_t candidate) const { return failed_[candidate]; }  // the candidate forfeited a match

 private:
  double score(const campaign::MatchResult& away, bool of_opponent) const;

  const TuningPlan& plan_;
  std::span<const TuningOpponent> opponents_;
  bool head_to_head_;
  std::optional<ScoreBounds> bounds_;  // nullopt: scores have no bounds, or head-to-head
  Round round_;
  std::vector<Round::Place> places_;         // by match
  std::vector<std::vector<double>> scores_;  // by candidate
  std::vector<std::vector<bool>> unplayed_;  // by candidate
  PacketsOfShortGames short_games_;
  std::vector<PacketsSpent> packets_;  // by candidate
  std::vector<bool> failed_;
  std::uint64_t next_ = 0, pairs_done_ = 0, unplayed_pairs_ = 0;
  campaign::MatchResult home_;  // result of the first of the two current matches
  double sum_ = 0.0;            // score of the current candidate, over its opponents so far
  bool broken_ = false;         // a match of the current candidate could not be played
};

// Facts about the matches of all stages, without their scores.
struct MatchTally {
  explicit MatchTally(const TuningPlan& plan) : forfeits(plan.opponents.size() + 2) {}

  ForfeitList forfeits;              // team 0: the tuned team; then the opponents; last: the base team as an opponent
  MatchRemarks remarks;              // matches are numbered from 0 over all rounds
  std::uint64_t unplayed_pairs = 0;  // candidates' pairs with a match that could not be played
  std::uint64_t matches = 0;         // number of matches of all rounds so far
  std::uint64_t taken = 0;           // number of these matches with a result

  // See Study::unplayable(). All matches count as one pairing, because the tuned team plays in each match.
  std::string unplayable() const {
    if (remarks.unplayed.count() < most_set_aside) return {};
    return why_unplayable("the tuned team", remarks.unplayed.listed().back().text);
  }
};

// The objects that every stage uses to play matches. All of them must outlive the MatchSource.
struct MatchSource {
  const TuningPlan& plan;
  const TunedDocument& document;
  const PlayRound& play;
  MatchTally& tally;
};

// Plays a batch. The rows of its matches follow the rows of all earlier batches in the file of results. after_pair:
// called after each pair of all candidates; a result false ends the batch; may be empty. Throws what `play` throws.
void play_batch(const MatchSource& source, PairBatch& batch, const std::function<bool()>& after_pair = {});

// The score of a candidate in its matches, and the number that the search gets for it, even if the team forfeited or no
// match has a value for the objective. A larger score is always better, also for a minimised objective.
struct PlayedScore {
  MeanEstimate score;    // over pairs
  bool failed = false;   // a plugin of the team forfeited a match
  double counted = 0.0;  // number for the search: the mean score; a worst value after a forfeit or without scores
};

// The score of a candidate of a batch. worst: the least score so far; infinite before the first score.
PlayedScore played_score(const TuningPlan& plan, const PairBatch& batch, std::size_t candidate, double worst);

// The least of `worst` and all scores of the batch's first `candidates` candidates.
double worst_of(const PairBatch& batch, std::size_t candidates, double worst);

}  // namespace regista::study
