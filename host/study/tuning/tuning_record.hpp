// SPDX-License-Identifier: MIT
// What a tuning has found so far, stage after stage, and what that says: which finalist is kept, and whether it was
// found better than the base team.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "study/packets_spent.hpp"
#include "study/tuning/match_tally.hpp"
#include "study/tuning/pair_search.hpp"
#include "study/tuning/selection.hpp"
#include "study/tuning/slices.hpp"
#include "study/tuning/tuning_plan.hpp"
#include "study/tuning/verification.hpp"

namespace regista::study {

struct TuningRecord {
  explicit TuningRecord(const TuningPlan& plan) : verification(0, plan.confidence(), 1.0), tally(plan) {}

  std::optional<TuningStage> stage = TuningStage::search;  // under way; nothing: all is done
  std::vector<SearchStep> trace;
  std::string ended;                            // the search: why
  std::vector<Finalist> finalists;              // best first, once the selection is done
  Verification verification;                    // of the first finalists
  std::vector<std::size_t> candidates;          // finalists that are verified
  std::vector<bool> candidate_failed;           // it forfeited a match of the verification
  std::vector<PacketsSpent> candidate_packets;  // in the verification
  std::vector<Slice> slices;                    // largest importance first
  MatchTally tally;

  // What the verification says so far about a candidate; one that forfeited a match of it is not better.
  VerifiedAs finding(std::size_t candidate) const;
  // The finalist that is kept: the first candidate that was found better; where none was, the first one. Nothing while
  // there is none, or where the search found nothing but the base team.
  std::optional<std::size_t> tuned() const;
  bool verified() const;  // it was found better
};

}  // namespace regista::study
