// SPDX-License-Identifier: MIT
// Whether the base team can be played and has a number for the objective: without that there is nothing to compare
// with, and a study of its numbers ends after its first matches.
#pragma once

#include "study/study.hpp"
#include "study/tuning/match_tally.hpp"
#include "study/tuning/played_score.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

// The base team forfeits, or has no number for the objective.
class TuningError : public StudyError {
  using StudyError::StudyError;
};

// played: of the base team's first matches in a search. tally: of all matches so far, from which the reason is taken.
// Throws TuningError.
void check_base_team(const TuningPlan& plan, const PlayedScore& played, const MatchTally& tally);

}  // namespace regista::study
