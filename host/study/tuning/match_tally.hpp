// SPDX-License-Identifier: MIT
// What is counted of the matches that searches and verifications ask for, beside their scores; and the one way in which
// a batch of them is asked for. Batches are numbered one after the other, so that each match has a row of its own in
// the file of results.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "study/forfeits.hpp"
#include "study/match_remarks.hpp"
#include "study/tuning/pair_batch.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

struct MatchTally {
  explicit MatchTally(const TuningPlan& plan) : forfeits(plan.opponents.size() + 2) {}

  ForfeitList forfeits;              // 0: the tuned team; then the opponents; last: the base team as an opponent
  MatchRemarks remarks;              // of matches as they were asked for, from 0
  std::uint64_t unplayed_pairs = 0;  // of any values; a match of them could not be played
  std::uint64_t matches = 0;         // asked for so far

  // See Study. All matches count as one pairing: the tuned team is in each of them.
  std::string unplayable() const {
    if (remarks.unplayed().count() < most_set_aside) return {};
    return why_unplayable("the tuned team", remarks.unplayed().listed().back().text);
  }
};

// What every stage asks its matches of. All outlive it.
struct MatchSource {
  const TuningPlan& plan;
  const TunedDocument& document;
  const PlayMatches& play;
  MatchTally& tally;
};

// Plays a batch. after_pair: whether to go on, asked when a pair has been completed for all candidates; empty: yes.
// Throws what `play` throws.
void play_batch(const MatchSource& source, PairBatch& batch, const std::function<bool()>& after_pair = {});

}  // namespace regista::study
