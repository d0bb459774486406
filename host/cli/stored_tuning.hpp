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

// How far the search had come when it was last looked at, and the wall time that it had taken until then.
struct SearchTime {
  std::uint64_t evaluations = 0;
  double seconds = 0.0;
};
SearchTime stored_time_of_search(const campaign::Store& store);  // zeros where there is none
void store_time_of_search(campaign::Store& store, const SearchTime& time);

// fingerprint: called for each match, in order. Throws campaign::StoreError, std::invalid_argument for damaged metrics.
void stored_tuning(const campaign::Store& store, const study::TuningPlan& plan, study::TuningRecord& record,
                   const std::function<void(std::uint64_t row, const campaign::Decided& decided)>& each = {});

}  // namespace regista::cli
