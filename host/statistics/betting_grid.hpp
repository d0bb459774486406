// SPDX-License-Identifier: MIT
// The confidence sequence of betting.hpp in constant memory: the means of a grid are tested at once, and one that was
// rejected stays rejected, which keeps the promise and makes the interval narrower (the running intersection of
// I. Waudby-Smith and A. Ramdas, 2024). For long studies, whose memory must not grow with the number of matches.
#pragma once

#include <cstdint>
#include <vector>

#include "statistics/betting.hpp"
#include "statistics/interval.hpp"

namespace regista::statistics {

class BettingGrid {
 public:
  // steps, 2 or more: low, high and what lies between them in equal distances are the means tested. An even number has
  // the middle among them.
  BettingGrid(const BettingDesign& design, int steps);

  // Precondition: the value is of [low, high].
  void add(double value);

  // Contains the true mean at all times together with probability 1 - alpha; up to one step wider on either side than
  // the exact sequence. [low, high] before the first value.
  Interval interval() const;

  // Where the true mean is, seen from one of the means tested: none while that is not rejected.
  BettingTest::Finding finding(double mean) const;

  std::int64_t values() const { return values_; }
  double mean() const;  // of the values; the middle of the range before the first

 private:
  double point(int index) const;  // of [0, 1]
  double in_units(double share) const { return design_.low + share * (design_.high - design_.low); }

  BettingDesign design_;
  int steps_;
  int first_ = 0, last_;  // not rejected
  std::vector<HedgedCapital> capitals_;
  PlugInStake stake_;
  std::int64_t values_ = 0;
  double sum_ = 0.0;
};

}  // namespace regista::statistics
