// SPDX-License-Identifier: MIT
#include "statistics/quantile.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace regista::statistics {
namespace {

double at(std::span<const double> ordered, double probability) {
  assert(!ordered.empty() && probability >= 0.0 && probability <= 1.0);
  const double place = probability * static_cast<double>(ordered.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  if (below + 1 >= ordered.size()) return ordered.back();
  return ordered[below] + (place - std::floor(place)) * (ordered[below + 1] - ordered[below]);
}

std::vector<double> in_order(std::span<const double> values) {
  std::vector<double> out(values.begin(), values.end());
  std::ranges::sort(out);
  return out;
}

}  // namespace

double quantile(std::span<const double> values, double probability) { return at(in_order(values), probability); }

Quartiles quartiles(std::span<const double> values) {
  const std::vector<double> ordered = in_order(values);
  return {at(ordered, 0.25), at(ordered, 0.5), at(ordered, 0.75)};
}

}  // namespace regista::statistics
