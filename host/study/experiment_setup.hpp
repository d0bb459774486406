// SPDX-License-Identifier: MIT
// From an experiment's document to its plan: every arm at every value of the sweep is set up and checked before the
// first match, so that nothing is found out after a night of playing.
#pragma once

#include <string>
#include <vector>

#include "config/mistakes.hpp"
#include "config/node.hpp"
#include "plugin/catalogue.hpp"
#include "study/experiment_plan.hpp"

namespace regista::study {

// plugins: folders of the catalogue. Throws config::BadInput and config::Error, at the place that asks for what cannot
// be.
ExperimentPlan planned_experiment(const config::Node& document, const std::vector<std::string>& plugins,
                                  const plugin::Catalogue& catalogue);

// Whether it can be planned: lists every mistake in arms, values and measures.
void check_experiment(const config::Node& document, const std::vector<std::string>& plugins,
                      const plugin::Catalogue& catalogue, config::Mistakes& mistakes);

}  // namespace regista::study
