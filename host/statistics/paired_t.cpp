// SPDX-License-Identifier: MIT
#include "statistics/paired_t.hpp"

#include <algorithm>
#include <cmath>

#include "statistics/distributions.hpp"

namespace regista::statistics {

std::optional<PairedT> paired_t(std::span<const double> values, double confidence) {
  // Compared, not computed: rounding gives equal values such as 0.1 a tiny variance.
  const auto differs = [&](double value) { return value != values.front(); };
  if (values.size() < 2 || std::none_of(values.begin(), values.end(), differs)) return std::nullopt;
  return paired_t(Moments(values), confidence);
}

std::optional<PairedT> paired_t(const Moments& moments, double confidence) {
  if (moments.count() < 2) return std::nullopt;
  const double error = moments.standard_deviation() / std::sqrt(static_cast<double>(moments.count()));
  if (!(error > 0.0)) return std::nullopt;
  const double degrees = static_cast<double>(moments.count() - 1);
  const double t = moments.mean() / error;
  const double margin = student_t_quantile(0.5 + confidence / 2.0, degrees) * error;
  return PairedT{moments.count(),
                 moments.mean(),
                 moments.standard_deviation(),
                 t,
                 student_t_outside(t, degrees),
                 {moments.mean() - margin, moments.mean() + margin}};
}

}  // namespace regista::statistics
