// SPDX-License-Identifier: MIT
// Mean and variance of values as they come, in any unit: B. P. Welford, "Note on a Method for Calculating Corrected
// Sums of Squares and Products", Technometrics 4, 1962, which loses no digits to a large mean.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>

namespace regista::statistics {

class Moments {
 public:
  Moments() = default;
  explicit Moments(std::span<const double> values) {
    for (const double value : values) add(value);
  }

  void add(double value) {
    ++count_;
    const double before = value - mean_;
    mean_ += before / static_cast<double>(count_);
    squares_ += before * (value - mean_);
  }

  std::int64_t count() const { return count_; }
  double mean() const { return mean_; }  // 0 of no value
  // Of a sample, divided by count - 1; 0 of fewer than two values, which is no statement about their spread.
  double variance() const { return count_ < 2 ? 0.0 : squares_ / static_cast<double>(count_ - 1); }
  double standard_deviation() const { return std::sqrt(variance()); }

 private:
  std::int64_t count_ = 0;
  double mean_ = 0.0, squares_ = 0.0;
};

}  // namespace regista::statistics
