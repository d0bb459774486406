// SPDX-License-Identifier: MIT
// The selection: what a search recommends is played again on pairs that it did not play, all finalists on the same
// ones, and the best of them go into the verification.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "study/tuning/match_tally.hpp"
#include "study/tuning/pair_search.hpp"
#include "study/tuning/played_score.hpp"

namespace regista::study {

struct Finalist {
  ParameterValues values;
  std::optional<PlayedScore>
      seen;  // in the search, over all its pairs; nothing: never played there, as a mean of points
  PlayedScore selected;
};

// Plays the selection: its finalists, all different, best first. Throws what the source's `play` throws.
std::vector<Finalist> select_finalists(const MatchSource& source, const SearchFindings& found);

// Which of them are to be verified: the best ones, up to the base team itself.
std::vector<std::size_t> candidates_among(const TuningPlan& plan, const std::vector<Finalist>& finalists);

// Standard deviation of a finalist's score over pairs, as the selection saw it, or else the search; above 0, 1 where
// nothing ever varied.
double deviation_of(const std::vector<Finalist>& finalists, const SearchScores& scores);

}  // namespace regista::study
