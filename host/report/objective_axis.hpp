// SPDX-License-Identifier: MIT
// The axis of a figure on which values of an objective stand.
#pragma once

#include <limits>
#include <string>

#include "study/paired_estimates.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::report {

// From the least to the largest value that was taken, with a little room.
class AxisRange {
 public:
  void take(double value);                         // one that is not finite is left out
  void take(const study::MeanEstimate& estimate);  // with its interval

  bool empty() const { return low_ > high_; }
  double bottom() const { return low_ - room(); }
  std::string axis() const;  // as gnuplot wants it

 private:
  double room() const;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

// "goal_difference, per match", or the unit alone where an axis of `length` units of the figure has no room for more;
// for gnuplot.
std::string value_label(const study::TuningObjective& objective, int length);

}  // namespace regista::report
