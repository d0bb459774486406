// SPDX-License-Identifier: MIT
// From a tuning's document to its plan: what its planner (tuning_planner.hpp) reads of every search, and the stages
// after it. Everything that can be wrong is found before the first match.
#pragma once

#include <string>
#include <vector>

#include "campaign/options.hpp"
#include "config/mistakes.hpp"
#include "plugin/catalogue.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

struct TuningRequest : campaign::Options {
  std::string file;
  std::vector<std::string> overrides;  // of the tuning's document
  std::string matches;                 // of the search, instead of what the document says; empty: as it says
};

// Throws config::BadInput and config::Error, at the place in the tuning's document that asks for what is not there.
TuningPlan planned_tuning(const TuningRequest& options, const plugin::Catalogue& catalogue);

// Whether it can be planned: lists every mistake in algorithm, opponents, parameters, openings and objective.
void check_tuning(const TuningRequest& options, const plugin::Catalogue& catalogue, config::Mistakes& mistakes);

// What is unusual but allowed, a line each: an opponent that is the base team itself.
std::vector<std::string> notes_on(const TuningPlan& plan);

}  // namespace regista::study
