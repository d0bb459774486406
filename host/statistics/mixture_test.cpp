// SPDX-License-Identifier: MIT
#include "statistics/mixture_test.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace regista::statistics {
namespace {

bool informative(const MixtureSample& sample) {
  assert(sample.values >= 0 && sample.variance >= 0.0 && sample.mixing_variance > 0.0);
  return sample.values > 0 && sample.variance > 0.0;
}

}  // namespace

double mixture_log_ratio(const MixtureSample& sample) {
  if (!informative(sample)) return 0.0;
  const double n = static_cast<double>(sample.values), s2 = sample.variance, tau2 = sample.mixing_variance;
  const double mixed = s2 + n * tau2;
  return 0.5 * std::log(s2 / mixed) + n * n * tau2 * sample.mean * sample.mean / (2.0 * s2 * mixed);
}

double mixture_p(const MixtureSample& sample) { return std::min(1.0, std::exp(-mixture_log_ratio(sample))); }

double mixture_half_width(const MixtureSample& sample, double alpha) {
  assert(alpha > 0.0 && alpha < 1.0);
  if (!informative(sample)) return std::numeric_limits<double>::infinity();
  const double n = static_cast<double>(sample.values), s2 = sample.variance, tau2 = sample.mixing_variance;
  const double mixed = s2 + n * tau2;
  return std::sqrt(s2 * mixed / (n * n * tau2) * (std::log(mixed / s2) - 2.0 * std::log(alpha)));
}

}  // namespace regista::statistics
