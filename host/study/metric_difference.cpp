// SPDX-License-Identifier: MIT
#include "study/metric_difference.hpp"

#include <limits>

#include "statistics/mixture_test.hpp"

namespace regista::study {

MetricDifference::MetricDifference(double alpha) : alpha_(alpha), test_({-1.0, 1.0, alpha}, 0.0) {}

void MetricDifference::add(double first, double second) {
  first_.add(first);
  second_.add(second);
  difference_.add(first - second);
  const int sign = first > second ? 1 : first < second ? -1 : 0;
  ++signs_[static_cast<std::size_t>(sign + 1)];
  test_.add(sign);
}

statistics::Estimate MetricDifference::estimate() const {
  const double mean = difference_.mean(), variance = difference_.variance();
  double half = std::numeric_limits<double>::infinity();
  // Finds soonest what one would see in some forty pairs: a quarter of a standard deviation.
  if (variance > 0.0) {
    half = statistics::mixture_half_width({difference_.count(), mean, variance, variance / 16.0}, alpha_);
  }
  return {mean, {mean - half, mean + half}};
}

}  // namespace regista::study
