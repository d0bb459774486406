// SPDX-License-Identifier: MIT
// What each parameter does by itself around the tuned point: a few values over its range, the others as tuned, all on
// the same pairs; and from that, how much it matters.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "study/paired_estimates.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

struct SlicePoint {
  double value = 0.0;       // of the parameter
  MeanEstimate score;       // larger is better
  MeanEstimate difference;  // less that of the tuned point, pair by pair
};

struct Slice {
  std::size_t parameter = 0;  // of the plan
  std::vector<SlicePoint> points;
  // Standard deviation of the true score over the points, in the unit of the objective: what their means vary by beyond
  // what chance does. 0: no more than chance.
  double importance = 0.0;
  // That the parameter does nothing: two-way analysis of variance, points by pairs (R. A. Fisher, 1925). Nothing where
  // there are too few pairs.
  std::optional<double> p;
};

// The values of a parameter that a slice shows: as many as the plan says, spread over its range, each different; the
// tuned one is not among them.
std::vector<double> slice_values(const TuningPlan& plan, const ParameterValues& tuned, std::size_t parameter);

// scores: by point, then pair, in the order of `values`; tuned: of the tuned point, by pair.
Slice slice_of(std::size_t parameter, double tuned_value, std::span<const double> values,
               std::span<const std::vector<double>> scores, const std::vector<double>& tuned, double confidence);

}  // namespace regista::study
