// SPDX-License-Identifier: MIT
// Quantiles of a few values: type 7 of R. J. Hyndman and Y. Fan, "Sample Quantiles in Statistical Packages", The
// American Statistician 50, 1996: linear between the ordered values, the least at 0, the greatest at 1.
#pragma once

#include <span>

namespace regista::statistics {

// values: one or more, finite, in any order; probability in [0, 1].
double quantile(std::span<const double> values, double probability);

struct Quartiles {
  double lower, median, upper;
};
Quartiles quartiles(std::span<const double> values);  // of one or more

}  // namespace regista::statistics
