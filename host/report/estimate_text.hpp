// SPDX-License-Identifier: MIT
// Estimates and their intervals as all reports write them. Two ways of choosing digits: as many as are asked for, and
// as many as the width of the interval leaves a meaning.
#pragma once

#include <optional>
#include <string>

#include "statistics/interval.hpp"
#include "study/paired_estimates.hpp"

namespace regista::report {

// "[-0.07, 0.12]"
std::string interval_text(const statistics::Interval& interval, int digits);
// "[-0.07, +0.12]"; a side without a bound is ∞.
std::string signed_interval_text(const statistics::Interval& interval, int digits);
// "+0.03 [-0.07, +0.12]"; "+0.03 (no interval)" where neither side has a bound.
std::string signed_text(const statistics::Estimate& estimate, int digits);
// "12.50 +/- 3.10"; with the interval where a side has no bound; "12.50 (no interval)" where neither has.
std::string with_margin(const statistics::Estimate& estimate);

// Half the width; 0 where there is none.
double half_width(const std::optional<statistics::Interval>& interval);
// With as many digits as the margin makes sensible, without exponent: "12.3", "0.045".
std::string rounded(double value, double margin);
// The same, with a plus before what is not negative.
std::string rounded_with_sign(double value, double margin);
// "3.21 ± 0.40"; "3.21" without an interval, "-" without pairs.
std::string estimate_text(const study::MeanEstimate& estimate);

// It has ends, and more between them than rounding makes of values that are all the same.
bool has_width(const statistics::Interval& interval);
// "0.85 [0.40, 1.30]"; "0.85" without an interval that has a width, "-" without a pair.
std::string with_interval(const study::MeanEstimate& estimate);
// "+0.85 [0.40, 1.30]"
std::string signed_with_interval(const statistics::Estimate& estimate);
std::string signed_with_interval(const study::MeanEstimate& difference);

}  // namespace regista::report
