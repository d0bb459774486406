// SPDX-License-Identifier: MIT
#include "statistics/symmetric_test.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace regista::statistics {
namespace {

// In standard deviations: the differences that are to be found soonest.
constexpr double usual_effect = 0.3;

}  // namespace

SymmetricTest::SymmetricTest(double deviation, double alpha)
    : mixing_variance_(usual_effect * usual_effect / (deviation * deviation)), log_level_(-std::log(alpha)) {
  assert(deviation > 0.0 && alpha > 0.0 && alpha < 1.0);
}

void SymmetricTest::add(double value) {
  ++count_;
  sum_ += value;
  squares_ += value * value;
  const double now = log_evidence(0.0);
  if (now <= most_) return;
  most_ = now;
  above_ = sum_ > 0.0;
}

double SymmetricTest::log_evidence(double centre) const {
  const auto n = static_cast<double>(count_);
  const double sum = sum_ - n * centre;
  const double squares = std::max(0.0, squares_ - 2.0 * centre * sum_ + n * centre * centre);
  const double spread = 1.0 + mixing_variance_ * squares;
  return mixing_variance_ * sum * sum / (2.0 * spread) - 0.5 * std::log(spread);
}

double SymmetricTest::p() const { return std::min(1.0, std::exp(-most_)); }

Interval SymmetricTest::interval() const { return {bound(-1.0), bound(1.0)}; }

// The first centre in this direction, seen from the mean, that has enough evidence against it.
double SymmetricTest::bound(double direction) const {
  const double middle = mean();
  const double beyond = direction * std::numeric_limits<double>::infinity();
  if (count_ == 0) return beyond;
  // Far away the evidence falls again, as such values would need a spread that excuses everything.
  double step = 1e-3 / std::sqrt(mixing_variance_ * static_cast<double>(count_));
  double inside = 0.0;
  for (int doublings = 0; log_evidence(middle + direction * step) < log_level_; ++doublings) {
    if (doublings == 120) return beyond;
    inside = step;
    step *= 1.25;
  }
  double outside = step;
  for (int i = 0; i < 60; ++i) {
    const double between = 0.5 * (inside + outside);
    (log_evidence(middle + direction * between) < log_level_ ? inside : outside) = between;
  }
  return middle + direction * outside;
}

}  // namespace regista::statistics
