// SPDX-License-Identifier: MIT
// Estimates with intervals, the mean, variance and quantiles of values, and analyses of variance. Values have any unit.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "statistics/counts.hpp"

namespace regista::statistics {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

// An interval of the possible true values of a number. A bound that the data do not determine is infinite.
struct Interval {
  double low, high;

  bool bounded() const { return std::isfinite(low) && std::isfinite(high); }
  bool unbounded() const { return std::isinf(low) && std::isinf(high); }
  bool contains(double value) const { return low <= value && value <= high; }
};

struct Estimate {
  double value;
  Interval interval;

  // Returns half the width of the interval, which reports write after "+-".
  double margin() const { return (interval.high - interval.low) / 2.0; }
};

// Mean and variance, updated with each value: B. P. Welford, "Note on a Method for Calculating Corrected Sums of
// Squares and Products", Technometrics 4, 1962. With this method a large mean costs no precision.
class Moments {
 public:
  Moments() = default;
  explicit Moments(std::span<const double> values) {
    for (const double value : values) add(value);
  }

  void add(double value) {
    ++count_;
    uneven_ += value != 0.0 ? 1 : 0;
    const double quarters = 4.0 * std::abs(value);
    in_quarters_ = in_quarters_ && quarters < 1e15 && quarters == std::floor(quarters);
    if (in_quarters_) quarters_ = std::gcd(quarters_, static_cast<std::int64_t>(quarters));
    const double before = value - mean_;
    mean_ += before / static_cast<double>(count_);
    squares_ += before * (value - mean_);
  }

  std::int64_t count() const { return count_; }
  std::int64_t uneven() const { return uneven_; }  // number of values other than 0
  // Returns the largest number of which all values are multiples, such as 1/2 for means of two scores; 0 if the values
  // are no multiples of 1/4.
  double unit() const { return in_quarters_ ? static_cast<double>(quarters_) / 4.0 : 0.0; }
  double mean() const { return mean_; }  // 0 without values
  // Sample variance with divisor count - 1. Returns 0 for fewer than two values, although their variance is unknown.
  double variance() const { return count_ < 2 ? 0.0 : squares_ / static_cast<double>(count_ - 1); }
  double standard_deviation() const { return std::sqrt(variance()); }

 private:
  std::int64_t count_ = 0, uneven_ = 0, quarters_ = 0;
  double mean_ = 0.0, squares_ = 0.0;
  bool in_quarters_ = true;
};

// Returns the quantile of type 7 of R. J. Hyndman and Y. Fan, "Sample Quantiles in Statistical Packages", The American
// Statistician 50, 1996. The quantile is linear between the ordered values; probability 0 gives the least value, 1 the
// greatest. values: one or more, finite, in any order. probability: in [0, 1].
double quantile(std::span<const double> values, double probability);

// --- The probability distributions of this folder. Boost.Math computes them in double precision only, so that every
// compiler gives the same digits.

// Student's distribution, degrees of freedom above 0.
double student_t_outside(double t, double degrees);             // probability of a value beyond +-|t|
double student_t_quantile(double probability, double degrees);  // probability in (0, 1)

// Returns the probability of a value above t under noncentral t: (Z + noncentrality) / sqrt(chi squared / degrees).
double noncentral_t_above(double t, double degrees, double noncentrality);

// Returns the quantile of chi squared, degrees of freedom above 0; probability in (0, 1).
double chi_squared_quantile(double probability, double degrees);

// Returns the probability of a value above f (0 or more) under Fisher's F; both degrees of freedom above 0.
double fisher_f_above(double f, double degrees, double residual_degrees);

// Returns the lower bound of Clopper and Pearson for a rate of success: at this rate, `successes` or more of `trials`
// have the probability `tail`. Returns 0 for 0 successes.
double binomial_share_at_least(std::int64_t successes, std::int64_t trials, double tail);

// Returns the probability of `successes` or more of `trials` with a rate in [0, 1].
double binomial_at_least(std::int64_t successes, std::int64_t trials, double rate);

// --- Two-way analysis of variance without interaction tests whether treatments differ. Every treatment is tried in the
// same blocks. R. A. Fisher, "Statistical Methods for Research Workers", 1925, chapter 8.

struct TwoWayAnalysis {
  double f = 0.0;  // mean square of treatments over mean square of residuals; infinite if all residuals are 0
  double p = 1.0;  // probability of this F or a larger F if all treatments are equal
  // Variance of the true means of the treatments, in squares of the unit of the values: the variance of the observed
  // means minus the part that the residuals explain; 0 or more.
  double variance_of_rows = 0.0;
};

// values: one list for each treatment, with one value for each block. The function ignores a block with a missing value
// (NaN). Returns nothing for fewer than two treatments or fewer than two complete blocks.
std::optional<TwoWayAnalysis> two_way_analysis(std::span<const std::vector<double>> values);

// --- The gain of playing in pairs: the variance of the mean of a pair over the variance of the mean of two independent
// games. At 0.5, pairs need half the games for the same certainty. At 1 pairs change nothing; above 1 they are harmful.
// Pairs use common random numbers and antithetic variates: A. M. Law, "Simulation Modeling and Analysis", chapter 11.

// Returns 2 (variance of a pair's score) / (variance of a game's score). `games` may include games outside of the
// pairs. Returns nothing without a pair or a game, or if all games have the same score.
std::optional<double> variance_ratio(const PairCounts& pairs, const GameCounts& games);

// Returns 2 (variance of the means of pairs) / (variance of all values), for values such as goal differences from the
// first team's point of view. means: the mean of each pair; all: every value. Returns nothing for fewer than two pairs
// or if all values are equal.
std::optional<double> variance_ratio(const Moments& means, const Moments& all);

}  // namespace regista::statistics
