// SPDX-License-Identifier: MIT
// The search of an algorithm over the values of a team, where a point is worth what its pairs of matches say. It turns
// the algorithm's questions into batches of matches, plays nothing twice, keeps to the budget, and keeps every score.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "study/tuning/algorithm.hpp"
#include "study/tuning/match_tally.hpp"
#include "study/tuning/played_score.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

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

// What some values scored on one of the search's sets of pairs.
struct SetScores {
  std::vector<double> scores;  // by pair; not a number where a match has none
  PlayedScore played;
};

// By values, then by the number of the set.
using SearchScores = std::map<std::pair<ParameterValues, std::uint64_t>, SetScores>;

// Over all pairs of the search that these values played; nothing where they played none.
std::optional<PlayedScore> seen_in_search(const SearchScores& scores, const ParameterValues& values, double confidence);

struct SearchFindings {
  std::vector<ParameterValues> recommended;  // one or more, best first; rounding may have made some of them equal
  std::string ended;                         // why
  SearchScores scores;
  double worst = HUGE_VAL;  // the least of all scores
};

// Before each question but the first, with the points tried so far: true ends the search with what it has, as for want
// of time. Empty: never.
using OutOfTime = std::function<bool(std::uint64_t evaluations)>;

// steps: empty; each point is added to it once it has been played. Throws TuningError (base_team_check.hpp), and what
// the source's `play` throws.
SearchFindings search_over_pairs(const MatchSource& source, const OutOfTime& out_of_time,
                                 std::vector<SearchStep>& steps);

}  // namespace regista::study
