// SPDX-License-Identifier: MIT
// How much smaller or larger the errors of a predictor are than those of a baseline, and how sure that is.
//
// Errors of neighbouring starts share a kick, so they are no independent draws: whole blocks of play are drawn with
// replacement (block bootstrap: Kuensch, "The Jackknife and the Bootstrap for General Stationary Observations", Annals
// of Statistics 17, 1989), and the interval holds the middle 95 % of what comes out.
#pragma once

#include <cstddef>
#include <span>

namespace regista::study {

// Of one truth, m.
struct PairedError {
  std::size_t block;  // of play, from 0
  double predictor, baseline;
};

// Quantile of the predictor's errors over that of the baseline's: below 1 the predictor is better.
struct ErrorRatio {
  double value = 1.0, low = 1.0, high = 1.0;
};

struct ErrorRatios {
  ErrorRatio median, ninetieth;
};

// The same errors give the same intervals. One error or more; the baseline's quantiles must not be 0.
ErrorRatios error_ratios(std::span<const PairedError> errors);

}  // namespace regista::study
