// SPDX-License-Identifier: MIT
// The figures of an experiment: tables and how they are drawn, a pure function of what was played.
#pragma once

#include <string_view>
#include <vector>

#include "report/experiment.hpp"
#include "report/figure.hpp"

namespace regista::report {

// Without a sweep "roles", the bar chart of Affinita et al. 2023, section 4: minutes of overlap by role, a colour for
// each arm; beside it uncovered time and switches. With one a curve for each measure, "sweep_1", ... A figure that has
// nothing to show is left out.
std::vector<Figure> experiment_figures(const ExperimentView& view);

// Whether figures of some experiment are called so.
bool is_experiment_figure(std::string_view name);

}  // namespace regista::report
