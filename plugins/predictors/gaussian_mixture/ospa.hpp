// SPDX-License-Identifier: MIT
// The distance between two sets of points: how far off the estimates are, with a price for each that is missing or
// too many.
//
// Source: Schuhmacher, Vo, Vo, "A Consistent Metric for Performance Evaluation of Multi-Object Filters" (OSPA, IEEE
// Trans. Signal Processing 56, 2008), of order 1.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace gaussian_mixture {

// m, in [0, cutoff]. Exact, by dynamic programming over subsets: the larger set may have up to 20 points.
inline double ospa(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b, double cutoff) {
  const auto& few = a.size() <= b.size() ? a : b;
  const auto& many = a.size() <= b.size() ? b : a;
  if (many.empty()) return 0.0;
  std::vector<double> least(std::size_t{1} << many.size(), std::numeric_limits<double>::infinity());
  least[0] = 0.0;
  double best = few.empty() ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t used = 0; used < least.size(); ++used) {
    const auto row = static_cast<std::size_t>(__builtin_popcountll(used));
    if (row >= few.size()) {
      if (row == few.size()) best = std::min(best, least[used]);
      continue;
    }
    for (std::size_t j = 0; j < many.size(); ++j) {
      if ((used >> j & 1u) != 0) continue;
      double& next = least[used | std::size_t{1} << j];
      next = std::min(next, least[used] + std::min(cutoff, (few[row] - many[j]).norm()));
    }
  }
  return (best + cutoff * static_cast<double>(many.size() - few.size())) / static_cast<double>(many.size());
}

}  // namespace gaussian_mixture
