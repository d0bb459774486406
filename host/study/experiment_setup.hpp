// SPDX-License-Identifier: MIT
// From an experiment's document to its plan: every arm at every value of the sweep is set up and checked before the
// first match, so that nothing is found out after a night of playing.
#pragma once

#include <string>
#include <vector>

#include "campaign/options.hpp"
#include "config/bad_input.hpp"
#include "config/experiment.hpp"
#include "config/mistakes.hpp"
#include "plugin/catalogue.hpp"
#include "study/experiment_plan.hpp"

namespace regista::study {

struct ExperimentRequest : campaign::Options {
  std::string file;
  std::vector<std::string> overrides;  // of the experiment's document
  std::string minutes, matches;        // instead of what it says; empty: as it says
};

// Throws config::BadInput and config::Error, at the place in the experiment's document that asks for what is not there.
ExperimentPlan planned_experiment(const ExperimentRequest& options, const plugin::Catalogue& catalogue);

// Whether it can be planned: lists every mistake in arms, values and measures.
void check_experiment(const ExperimentRequest& options, const plugin::Catalogue& catalogue, config::Mistakes& mistakes);

}  // namespace regista::study
