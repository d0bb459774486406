// SPDX-License-Identifier: MIT
// A tuning from the file its results are kept in: its course, taken once more as far as its matches have been played.
#pragma once

#include <cstdint>
#include <optional>

#include "campaign/store.hpp"
#include "study/tuning/tuning.hpp"

namespace regista::cli {

// Whether the objective needs more than scores.
campaign::Metrics metrics_wanted(const study::TuningPlan& plan);

// After so many points the search was ended for want of time; nothing where it was not.
std::optional<std::uint64_t> stored_end_of_search(const campaign::Store& store);
void store_end_of_search(campaign::Store& store, std::uint64_t evaluations);

// Wall time that the search has taken so far, s.
double stored_seconds_of_search(const campaign::Store& store);
void store_seconds_of_search(campaign::Store& store, double seconds);

// fingerprint: called for each match, in order. Throws campaign::StoreError, std::invalid_argument for damaged metrics.
void stored_tuning(const campaign::Store& store, const study::TuningPlan& plan, study::TuningRecord& record,
                   const std::function<void(std::uint64_t row, const campaign::Decided& decided)>& each = {});

}  // namespace regista::cli
