// SPDX-License-Identifier: MIT
// From a tuning's document to its plan: opponents, parameters, openings, objective, budgets. Everything that can be
// wrong is found before the first match.
#pragma once

#include <string>
#include <vector>

#include "config/mistakes.hpp"
#include "config/node.hpp"
#include "plugin/catalogue.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

// plugins: folders of the catalogue. Throws config::BadInput and config::Error, at the place that asks for what cannot
// be.
TuningPlan planned_tuning(const config::Node& document, const std::vector<std::string>& plugins,
                          const plugin::Catalogue& catalogue);

// Whether it can be planned: lists every mistake in algorithm, opponents, parameters, openings and objective.
void check_tuning(const config::Node& document, const std::vector<std::string>& plugins,
                  const plugin::Catalogue& catalogue, config::Mistakes& mistakes);

// What is unusual but allowed, a line each: an opponent that is the base team itself.
std::vector<std::string> notes_on(const TuningPlan& plan);

}  // namespace regista::study
