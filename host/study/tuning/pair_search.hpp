// SPDX-License-Identifier: MIT
// The search of an algorithm for the best parameter values of a team. Each question of the algorithm becomes a batch of
// matches, within the budget. All scores are kept, so no match is played twice.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "campaign/engine.hpp"
#include "campaign/store.hpp"
#include "study/study.hpp"
#include "study/tuning/pair_batch.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

// Thrown if the base team forfeits or has no value for the objective. The study ends after its first matches then,
// because nothing can be compared with the base team.
class TuningError : public StudyError {
  using StudyError::StudyError;
};

// Throws TuningError if the base team forfeited its first matches or has no score. played: the score of these matches.
// tally: the facts about all matches so far, which give the reason.
void check_base_team(const TuningPlan& plan, const PlayedScore& played, const MatchTally& tally);

// A point that the search tried. The first point is the base team.
struct SearchStep {
  std::uint64_t evaluation = 0;  // number of the point, from 1
  std::uint64_t pairs_from = 0;  // number of the point's first pair in the search
  ParameterValues values;
  PlayedScore played;
  bool repeated = false;      // true: these values had played these pairs before, so no match was played
  double best = 0.0;          // largest `played.counted` so far
  std::uint64_t matches = 0;  // number of matches of the search, up to this step
};

// The scores of one set of values on one set of pairs of the search.
struct SetScores {
  std::vector<double> scores;  // by pair; NaN if a match has no score
  PlayedScore played;
};

// Key: the values, then the number of the set of pairs.
using SearchScores = std::map<std::pair<ParameterValues, std::uint64_t>, SetScores>;

// The score of these values over all their pairs in the search; nullopt if the search has not played these values.
std::optional<PlayedScore> seen_in_search(const SearchScores& scores, const ParameterValues& values, double confidence);

struct SearchFindings {
  std::vector<ParameterValues> recommended;  // one or more, best first; some may be equal after rounding
  std::string ended;                         // why the search ended
  SearchScores scores;
  double worst = HUGE_VAL;  // least score of the whole search
};

// The search calls this function before each question except the first. evaluations: number of points so far. Returns
// true if the time is up; the search then ends with the points that it has. Empty function: no limit of time.
using OutOfTime = std::function<bool(std::uint64_t evaluations)>;

// Runs the search. steps: empty before the call; the search adds each point after the point's matches. Throws
// TuningError, and what the source's `play` throws.
SearchFindings search_over_pairs(const MatchSource& source, const OutOfTime& out_of_time,
                                 std::vector<SearchStep>& steps);

// --- The wall time of a search. Neither the plan nor the results determine how many points fit into this time. So the
// results file stores after which point the search ended, and every reader of the file ends the search at this point.

// The time limit of a search that is played now. The function adds this run's time to the time of earlier runs and
// stores the sum. end_of_time: latest end of this run. If the store already holds the end of the search, returns
// stored_end_of_search(). The store must outlive the function. Throws campaign::StoreError.
OutOfTime search_clock(campaign::Store& store, const TuningPlan& plan, std::optional<campaign::Moment> end_of_time);

// The time limit of a search that is read back: the function ends the search at the stored point. Throws
// campaign::StoreError.
OutOfTime stored_end_of_search(const campaign::Store& store);

}  // namespace regista::study
