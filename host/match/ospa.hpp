// SPDX-License-Identifier: MIT
// How far a set of estimated places is from the set of true ones: the OSPA metric of order 1, D. Schuhmacher, B.-T. Vo
// and B.-N. Vo, "A Consistent Metric for Performance Evaluation of Multi-Object Filters", IEEE Transactions on Signal
// Processing 56(8), 2008. With m <= n places in the two sets and distances cut off at c,
//
//   OSPA = (min over assignments of the m to different ones of the n: sum of min(c, distance) + c (n - m)) / n
//
// and 0 when both sets are empty. Order 1, because then the part of the places and the part of the numbers add up.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "match/geometry.hpp"
#include "mind/coordination/least_cost_assignment.hpp"

namespace regista::match {

struct OspaParts {
  double location = 0.0;     // m: of those assigned
  double cardinality = 0.0;  // m: of those too few or too many
  double sum() const { return location + cardinality; }
};

class Ospa {
 public:
  // Metres; cutoff > 0. most: so many places in a set need no memory later.
  Ospa(double cutoff, std::size_t most);

  OspaParts operator()(std::span<const Vector> a, std::span<const Vector> b);

 private:
  double cutoff_;
  std::vector<double> cost_;  // rows x columns, row by row
  mind::LeastCostAssignment assignment_;
};

}  // namespace regista::match
