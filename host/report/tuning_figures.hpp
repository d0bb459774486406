// SPDX-License-Identifier: MIT
// Figures of a tuning: how the search converged, and one slice for each parameter.
#pragma once

#include <string_view>
#include <vector>

#include "report/figure.hpp"
#include "report/tuning.hpp"

namespace regista::report {

// "convergence", "importance", "slice_1", ... in the order of importance. One that has nothing to show is left out.
std::vector<Figure> tuning_figures(const TuningView& view);

// Whether figures of some tuning are called so.
bool is_tuning_figure(std::string_view name);

}  // namespace regista::report
