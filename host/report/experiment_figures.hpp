// SPDX-License-Identifier: MIT
// The figures of an experiment: tables and how they are drawn, a pure function of what was played.
#pragma once

#include <string_view>
#include <vector>

#include "report/experiment.hpp"
#include "report/figure.hpp"

namespace regista::report {

// The primary measure first. Without a sweep "roles" for what the measures name of single roles, and "measure_1", ...
// for each other measure: arms with mean and interval. With a sweep "sweep_1", ..., a curve for each measure and arm.
// The number is the place of the measure in the plan. As wide as the page; one that has nothing to show is left out.
std::vector<Figure> experiment_figures(const ExperimentView& view);

// Whether figures of some experiment are called so.
bool is_experiment_figure(std::string_view name);

}  // namespace regista::report
