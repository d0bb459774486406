// SPDX-License-Identifier: MIT
// The wall time that a search may take. It is the one thing of a study that no plan and no result decides: where the
// search was ended is part of the results, so that whoever reads them ends it there.
#pragma once

#include "campaign/store.hpp"
#include "study/tuning/pair_search.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

// Whether a search that has come so far is out of time; see OutOfTime. The store outlives what they return. Throw
// campaign::StoreError.

// As it is played: counts the time of this run and of those before it, and keeps it.
OutOfTime search_clock(campaign::Store& store, const TuningPlan& plan);

// As it was played.
OutOfTime stored_end_of_search(const campaign::Store& store);

}  // namespace regista::study
