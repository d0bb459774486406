// SPDX-License-Identifier: MIT
// The distance between two sets of points: how far off the estimates are, with a price for each that is missing or
// too many. For tests of predictors of several robots.
//
//   const double error = ospa({{0.1, 2.0}}, {{0.0, 2.0}, {3.0, 1.0}}, 1.0);   // estimates, truth, cut-off
//
// Source: Schuhmacher, Vo, Vo, "A Consistent Metric for Performance Evaluation of Multi-Object Filters" (OSPA, IEEE
// Trans. Signal Processing 56, 2008), equations (3) and (4).
#pragma once

#include <vector>

namespace regista::testkit {

struct PlanePoint {
  double x, y;  // m
};

// m, in [0, cutoff]; cutoff > 0, order >= 1. Exact, by dynamic programming over subsets: throws std::length_error when
// a set has more than 20 points.
double ospa(const std::vector<PlanePoint>& a, const std::vector<PlanePoint>& b, double cutoff, double order = 1.0);

}  // namespace regista::testkit
