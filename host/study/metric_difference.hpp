// SPDX-License-Identifier: MIT
// A number of two teams compared pair by pair, whatever its law: bets on the sign of the difference decide, its mean is
// reported beside them.
#pragma once

#include <array>
#include <cstdint>

#include "statistics/betting.hpp"
#include "statistics/interval.hpp"
#include "statistics/moments.hpp"

namespace regista::study {

class MetricDifference {
 public:
  explicit MetricDifference(double alpha);

  // A pair's mean values of both teams.
  void add(double first, double second);

  const statistics::Moments& first() const { return first_; }
  const statistics::Moments& second() const { return second_; }
  const statistics::Moments& difference() const { return difference_; }
  // Pairs in which the first team's value was smaller, equal, larger.
  const std::array<std::uint64_t, 3>& signs() const { return signs_; }
  // Bets on the sign of the difference: exact for any metric, whatever its law.
  const statistics::BettingTest& test() const { return test_; }
  // Of the mean difference; valid at any time once there are many pairs, for its variance is estimated.
  statistics::Estimate estimate() const;

 private:
  double alpha_;
  statistics::Moments first_, second_, difference_;
  std::array<std::uint64_t, 3> signs_{};
  statistics::BettingTest test_;
};

}  // namespace regista::study
