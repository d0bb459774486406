// SPDX-License-Identifier: MIT
#include "match/ospa.hpp"

#include <algorithm>
#include <utility>

namespace regista::match {

Ospa::Ospa(double cutoff, std::size_t most) : cutoff_(cutoff) {
  cost_.reserve(most * most);
  assignment_.reserve(most, most);
}

OspaParts Ospa::operator()(std::span<const Vector> a, std::span<const Vector> b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.empty()) return {};
  cost_.clear();
  for (const Vector& one : a) {
    for (const Vector& other : b) cost_.push_back(std::min(cutoff_, length(one - other)));
  }
  const auto count = static_cast<double>(b.size());
  return {assignment_.solve(cost_, a.size(), b.size()) / count,
          cutoff_ * static_cast<double>(b.size() - a.size()) / count};
}

}  // namespace regista::match
