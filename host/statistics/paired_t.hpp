// SPDX-License-Identifier: MIT
// Student's t test on one value per pair, such as its goal difference, against a mean of 0. Student, "The Probable
// Error of a Mean", Biometrika 6, 1908. Only for a number of pairs that was fixed beforehand: looked at again and
// again, it rejects far more often than it says. A test for that is in betting.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "statistics/interval.hpp"
#include "statistics/moments.hpp"

namespace regista::statistics {

struct PairedT {
  std::int64_t pairs;
  double mean, standard_deviation;  // of the values, in their unit
  double t;                         // mean / (standard deviation / sqrt(pairs)), pairs - 1 degrees of freedom
  double p;                         // two-sided, in [0, 1]
  Interval interval;                // of the mean
};

// Values are finite; confidence in (0, 1). Nothing where there are fewer than two values or all are equal: without
// spread there is no information about how certain the mean is.
std::optional<PairedT> paired_t(std::span<const double> values, double confidence = 0.95);
// The same of values that were not kept.
std::optional<PairedT> paired_t(const Moments& moments, double confidence = 0.95);

}  // namespace regista::statistics
