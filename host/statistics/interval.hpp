// SPDX-License-Identifier: MIT
// A number with the interval of what it may truly be. A bound that the data do not give is infinite.
#pragma once

#include <cmath>
#include <limits>

namespace regista::statistics {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

struct Interval {
  double low, high;

  bool bounded() const { return std::isfinite(low) && std::isfinite(high); }
  bool unbounded() const { return std::isinf(low) && std::isinf(high); }
  bool contains(double value) const { return low <= value && value <= high; }
};

struct Estimate {
  double value;
  Interval interval;

  // Half the width of the interval: the number after "+-".
  double margin() const { return (interval.high - interval.low) / 2.0; }
};

}  // namespace regista::statistics
