// SPDX-License-Identifier: MIT
#include "statistics/multiplicity.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <numeric>

namespace regista::statistics {
namespace {

// Indices by ascending p; equal ones as they come, so that every compiler gives the same order.
std::vector<std::size_t> ascending(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  return order;
}

}  // namespace

std::vector<double> holm(std::span<const double> p) {
  const std::vector<std::size_t> order = ascending(p);
  std::vector<double> adjusted(p.size());
  double largest = 0.0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    assert(p[order[rank]] >= 0.0 && p[order[rank]] <= 1.0);
    largest = std::max(largest, std::min(1.0, static_cast<double>(p.size() - rank) * p[order[rank]]));
    adjusted[order[rank]] = largest;
  }
  return adjusted;
}

std::vector<double> benjamini_hochberg(std::span<const double> p) {
  const std::vector<std::size_t> order = ascending(p);
  std::vector<double> adjusted(p.size());
  double smallest = 1.0;
  for (std::size_t rank = order.size(); rank-- > 0;) {
    assert(p[order[rank]] >= 0.0 && p[order[rank]] <= 1.0);
    smallest = std::min(smallest, static_cast<double>(p.size()) * p[order[rank]] / static_cast<double>(rank + 1));
    adjusted[order[rank]] = smallest;
  }
  return adjusted;
}

}  // namespace regista::statistics
