// SPDX-License-Identifier: MIT
// A sequential test of the centre of values that lie symmetrically around it, of any law and any bounds: if the centre
// is m, exp(b S - b^2 Q / 2) is a nonnegative supermartingale for every b, with S the sum of value - m and Q the sum of
// their squares (V. H. de la Pena, "A General Class of Exponential Inequalities for Martingales and Ratios", Annals of
// Probability 27, 1999). Mixed over b by a normal law of variance tau^2 around 0 it is
//   exp(tau^2 S^2 / (2 (1 + tau^2 Q))) / sqrt(1 + tau^2 Q),
// which exceeds 1/alpha at any time at all with probability alpha or less (J. Ville, 1939).
//
// The differences of two teams whose labels could as well be exchanged are symmetric. Those of teams that are merely
// equal on average need not be, and then it may be wrong too often: of values that mostly gain 0.1 and lose 0.9 one
// time in ten, whose mean is 0, it rejects a mean of 0 in a tenth of all runs instead of a twentieth (500 values), of
// rarer and larger losses in a quarter. betting.hpp holds for any law within known bounds. In exchange this one does
// not need to know any, and loses nothing to bounds that are far away.
#pragma once

#include <cstdint>

#include "statistics/interval.hpp"

namespace regista::statistics {

class SymmetricTest {
 public:
  // deviation > 0: what the standard deviation of a value is expected to be, in the unit of the values. All promises
  // hold whatever is expected; a good guess finds soonest. alpha in (0, 1): of the interval.
  SymmetricTest(double deviation, double alpha);

  void add(double value);

  std::int64_t values() const { return count_; }
  double mean() const { return count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_); }
  double p() const;  // that the centre is 0: min(1, 1 / the largest evidence so far), two-sided, valid at all times
  // When that evidence was largest, the mean was above 0.
  bool above() const { return above_; }
  // Contains the centre at all times together with probability 1 - alpha; infinite where the values do not bound it.
  Interval interval() const;

 private:
  double log_evidence(double centre) const;
  double bound(double direction) const;

  double mixing_variance_, log_level_;
  std::int64_t count_ = 0;
  double sum_ = 0.0, squares_ = 0.0;
  double most_ = 0.0;
  bool above_ = false;
};

}  // namespace regista::statistics
