// SPDX-License-Identifier: MIT
// From a tuning's document and a list of algorithms to the plan of their comparison: everything that can be wrong is
// found before the first match.
#pragma once

#include <string>

#include "plugin/catalogue.hpp"
#include "study/tuning/search_comparison_plan.hpp"
#include "study/tuning/tuning_setup.hpp"

namespace regista::study {

struct SearchComparisonRequest : TuningRequest {
  std::string compare;  // algorithms, divided by commas
  std::string repeats;  // of each; empty: 5
};

// Throws config::BadInput and config::Error, at the place in the tuning's document that asks for what is not there.
SearchComparisonPlan planned_search_comparison(const SearchComparisonRequest& options,
                                               const plugin::Catalogue& catalogue);

}  // namespace regista::study
