// SPDX-License-Identifier: MIT
// Whether treatments differ, when each was tried in the same blocks: two-way analysis of variance without interaction.
// R. A. Fisher, "Statistical Methods for Research Workers", 1925, chapter 8.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace regista::statistics {

struct TwoWayAnalysis {
  double f = 0.0;  // mean square of the treatments over that of the residuals; infinite where there are no residuals
  double p = 1.0;  // of an F as large or larger where no treatment does anything
  // Of the treatments' true means: what their observed means vary by, less what the residuals make of it; 0 or more.
  // In squares of the unit of the values.
  double variance_of_rows = 0.0;
};

// values: by treatment, each with a value for every block; not a number where one is missing, which leaves the block
// out. Nothing for fewer than two treatments or two whole blocks.
std::optional<TwoWayAnalysis> two_way_analysis(std::span<const std::vector<double>> values);

}  // namespace regista::statistics
