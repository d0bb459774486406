// SPDX-License-Identifier: MIT
// What a tuning found, for people and for programs. Everything here is a function of plan and record, so of the inputs:
// no times, no rates.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "report/outline.hpp"
#include "study/tuning/tuning.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::report {

struct TuningView {
  const study::TuningPlan& plan;
  const study::TuningRecord& record;
  std::string tuned_file;  // that the tuned team was written to; empty: none
};

// How things stand, in a few lines that are shown while it runs: stage, evaluation, best so far with its interval, then
// finalists, verification.
std::string tuning_standing(const TuningView& view);

// The whole report; also of a tuning that was stopped.
Outline tuning_outline(const TuningView& view);
nlohmann::ordered_json tuning_data(const TuningView& view);

// The trace as a table, with a head: a line for each evaluation of the search.
std::string tuning_csv(const TuningView& view);

}  // namespace regista::report
