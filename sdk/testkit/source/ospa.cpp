// SPDX-License-Identifier: MIT
// Dynamic programming over subsets.
#include <regista/testkit/ospa.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace regista::testkit {

double ospa(const std::vector<PlanePoint>& a, const std::vector<PlanePoint>& b, double cutoff, double order) {
  const auto& few = a.size() <= b.size() ? a : b;
  const auto& many = a.size() <= b.size() ? b : a;
  if (many.empty()) return 0.0;
  if (many.size() > 20) throw std::length_error("ospa: sets of at most 20 points");
  const auto price = [&](const PlanePoint& p, const PlanePoint& q) {
    const double distance = std::min(cutoff, std::sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y)));
    return order == 1.0 ? distance : std::pow(distance, order);
  };
  // least[s]: the first points of `few` paired with those of `many` in s, as many as s has.
  std::vector<double> least(std::size_t{1} << many.size(), std::numeric_limits<double>::infinity());
  least[0] = 0.0;
  double best = few.empty() ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t used = 0; used < least.size(); ++used) {
    const auto row = static_cast<std::size_t>(std::popcount(std::uint64_t{used}));
    if (row >= few.size()) {
      if (row == few.size()) best = std::min(best, least[used]);
      continue;
    }
    for (std::size_t j = 0; j < many.size(); ++j) {
      if ((used >> j & 1u) != 0) continue;
      double& next = least[used | std::size_t{1} << j];
      next = std::min(next, least[used] + price(few[row], many[j]));
    }
  }
  const double missing = static_cast<double>(many.size() - few.size());
  const double mean =
      (best + (order == 1.0 ? cutoff : std::pow(cutoff, order)) * missing) / static_cast<double>(many.size());
  return order == 1.0 ? mean : std::pow(mean, 1.0 / order);
}

}  // namespace regista::testkit
