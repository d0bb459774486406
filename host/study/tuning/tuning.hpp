// SPDX-License-Identifier: MIT
// The course of a tuning: search, selection of the best points on other seeds, verification against the base team on
// seeds nobody has chosen by, slices around what was found. A function of the plan and of the results of matches:
// played or read from a file, on one worker or many, it is the same.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/forfeits.hpp"
#include "study/paired_estimates.hpp"
#include "study/study.hpp"
#include "study/tuning/pair_batch.hpp"
#include "study/tuning/search.hpp"
#include "study/tuning/slices.hpp"
#include "study/tuning/tuning_plan.hpp"
#include "study/tuning/verification.hpp"

namespace regista::study {

// What the matches of a stage said about some values. Scores: larger is better, whatever the objective.
struct PlayedScore {
  MeanEstimate score;    // over pairs
  bool failed = false;   // its plugin forfeited a match
  double counted = 0.0;  // what the search was told: the mean, or of a failed one the worst there is
};

// A point that the search tried. The first is the base team.
struct SearchStep {
  std::uint64_t evaluation = 0;  // from 1
  std::uint64_t pairs_from = 0;  // first pair of the search's that it played
  ParameterValues values;
  PlayedScore played;
  bool repeated = false;      // the same values on the same pairs as before: nothing was played
  double best = 0.0;          // the largest `counted` so far
  std::uint64_t matches = 0;  // of the search so far, with its own
};

struct Finalist {
  ParameterValues values;
  std::optional<PlayedScore>
      seen;  // in the search, over all its pairs; nothing: never played there, as a mean of points
  PlayedScore selected;
};

// A point that a search recommended, in a comparison of algorithms.
struct ComparedRun {
  Algorithm algorithm = Algorithm::sbplx;
  std::uint64_t repeat = 0;
  std::uint64_t evaluations = 0, matches = 0;
  std::string ended;
  ParameterValues values;
  std::optional<double> seen;  // its score in the search
  MeanEstimate judged;         // less the base team's, pair by pair, on seeds no search has seen
};

struct TuningRecord {
  explicit TuningRecord(const TuningPlan& plan)
      : verification(0, plan.confidence, 1.0), forfeits(plan.opponents.size() + 2) {}

  std::optional<TuningStage> stage = TuningStage::search;  // under way; nothing: all is done
  std::vector<SearchStep> trace;
  std::string ended;                    // the search: why
  std::vector<Finalist> finalists;      // best first, once the selection is done
  Verification verification;            // of the first finalists
  std::vector<std::size_t> candidates;  // finalists that are verified: the best ones, up to the base team itself
  std::vector<bool> candidate_failed;   // it forfeited a match of the verification
  std::vector<PacketsSpent> candidate_packets;  // in the verification
  std::vector<Slice> slices;                    // largest importance first
  std::vector<ComparedRun> compared;
  ForfeitList forfeits;              // 0: the tuned team; then the opponents; last: the base team as an opponent
  MatchRemarks remarks;              // of matches as they were asked for, from 0
  std::uint64_t unplayed_pairs = 0;  // of any values; a match of them could not be played
  std::uint64_t matches = 0;         // asked for so far

  // What the verification says so far about a candidate; one that forfeited a match of it is not better.
  VerifiedAs finding(std::size_t candidate) const;
  // The finalist that is kept: the first candidate that was found better; where none was, the first one. Nothing while
  // there is none, or where the search found nothing but the base team.
  std::optional<std::size_t> tuned() const;
  bool verified() const;  // it was found better
};

// The base team forfeits, or has no number for the objective.
class TuningError : public StudyError {
  using StudyError::StudyError;
};

struct TuningHooks {
  PlayMatches play;
  // Before each question of the search but the first: true ends the search with what it has, as for want of time. From
  // a file: where it was ended. May be empty.
  std::function<bool(std::uint64_t evaluations)> out_of_time;
  // After every step and stage. May be empty.
  std::function<void()> progress;
};

// Fills the record as far as it comes. Throws TuningError (the base team forfeits), and what `play` throws.
void tune(const TuningPlan& plan, const TuningHooks& hooks, TuningRecord& record);

}  // namespace regista::study
