// SPDX-License-Identifier: MIT
// Figures of a tuning: how the search converged, and one slice for each parameter; of a comparison of algorithms, what
// each of them came to.
#pragma once

#include <vector>

#include "report/figure.hpp"
#include "report/tuning.hpp"

namespace regista::report {

std::vector<Figure> tuning_figures(const TuningView& view);

}  // namespace regista::report
