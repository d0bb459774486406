// SPDX-License-Identifier: MIT
// The course of a tuning: search (pair_search.hpp), selection of the best points on other seeds (selection.hpp),
// verification against the base team on seeds nobody has chosen by (candidate_matches.hpp), slices around what was
// found (slice_matches.hpp). A function of the plan and of the results of matches: played or read from a file, on one
// worker or many, it is the same.
#pragma once

#include "study/tuning/base_team_check.hpp"
#include "study/tuning/pair_batch.hpp"
#include "study/tuning/pair_search.hpp"
#include "study/tuning/tuning_plan.hpp"
#include "study/tuning/tuning_record.hpp"

namespace regista::study {

struct TuningHooks {
  PlayMatches play;
  OutOfTime out_of_time;  // of the search. From a file: where it was ended. May be empty.
};

// Fills the record as far as it comes. Throws TuningError (the base team forfeits), and what `play` throws.
void tune(const TuningPlan& plan, const TuningHooks& hooks, TuningRecord& record);

}  // namespace regista::study
