// SPDX-License-Identifier: MIT
// The results of an experiment in the order of its schedule, from the file they are kept in.
#pragma once

#include <cstdint>
#include <functional>

#include "campaign/store.hpp"
#include "study/experiment_plan.hpp"

namespace regista::cli {

// Calls take(index, decided) for all matches up to the first gap, metrics included. Throws campaign::StoreError.
void stored_trials(const campaign::Store& store, const study::ExperimentPlan& plan,
                   const std::function<void(std::uint64_t index, const campaign::Decided& decided)>& take);

}  // namespace regista::cli
