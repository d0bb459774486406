// SPDX-License-Identifier: MIT
// What the figures of an experiment share, and the two kinds there are: of roles, and of one measure.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "report/experiment.hpp"
#include "report/figure.hpp"

namespace regista::report {

inline constexpr int page_width = 1130;  // of a figure as wide as the page

// "mean,low,high"; fields of what is not known are empty, which gnuplot takes for a missing value.
std::string mean_fields(const study::MeanEstimate& mean);

std::string arm_colour(std::size_t arm);

// So many names of arms stand beside each other above a figure as wide as the page.
int key_columns(const study::ExperimentPlan& plan);
int key_rows(const study::ExperimentPlan& plan);

// The bar chart of Affinita et al. 2023, section 4: overlap, uncovered time and switches by role, a colour for each
// arm.
std::optional<Figure> role_figure(const ExperimentView& view);
bool is_in_role_figure(std::string_view measure);

// Without a sweep: a row for each arm, its mean and interval.
std::optional<Figure> arms_figure(const ExperimentView& view, std::size_t measure);

// Over a sweep: a curve for each arm with its interval as a band, if the values are numbers; else a row for each value.
std::optional<Figure> sweep_figure(const ExperimentView& view, std::size_t measure);

}  // namespace regista::report
