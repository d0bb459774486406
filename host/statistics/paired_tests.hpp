// SPDX-License-Identifier: MIT
// Tests whether one value per pair of matches, such as the goal difference, has mean 0. Precondition: the number of
// pairs was fixed beforehand. Repeated looks make such a test reject far too often; anytime_valid_tests.hpp has tests
// for them. This file also computes the number of pairs that a test needs, and adjusts p-values of several comparisons.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "statistics/counts.hpp"
#include "statistics/moments.hpp"

namespace regista::statistics {

// Student's t test: Student, "The Probable Error of a Mean", Biometrika 6, 1908.
struct PairedT {
  std::int64_t pairs;
  double mean, standard_deviation;  // of the values, in their unit
  double t;                         // mean / (standard deviation / sqrt(pairs)), pairs - 1 degrees of freedom
  double p;                         // two-sided, in [0, 1]
  Interval interval;                // confidence interval of the mean
};

// Precondition: finite values; confidence in (0, 1). Returns nothing for fewer than two values or if all values are
// equal: equal values do not show the uncertainty of the mean.
std::optional<PairedT> paired_t(std::span<const double> values, double confidence = 0.95);
// Computes the t test from the moments of the values.
std::optional<PairedT> paired_t(const Moments& moments, double confidence = 0.95);

// --- The sign-flip test. If two teams are equal, the difference of each pair has either sign with probability 1/2. The
// test is exact for the given sizes of differences. R. A. Fisher, "The Design of Experiments", 1935, section 21.

// The count of each whole number. In a tournament the number is the goal difference of both matches of a pair together.
using WholeCounts = std::map<std::int64_t, Count>;

// Returns the two-sided p, in (0, 1]: the probability that random signs of all numbers except 0 give a sum at least as
// far from 0 as the observed sum. p is exact, by convolution of binomial distributions. Exception: if a size occurs
// more than 4096 times and the sum is beyond 12 standard deviations, p is W. Hoeffding's larger bound (1963).
double sign_flip_p(const WholeCounts& seen);

// Computes sign_flip_p() for one finite value per pair, such as the difference of two teams. The result is exact if all
// values are multiples of 1/2, like means of two matches, and for up to 32 values other than 0. In other cases the
// function uses the normal distribution.
double sign_flip_p_of_values(std::span<const double> values);
bool sign_flip_of_values_is_exact(std::span<const double> values);

// --- Power: the number of pairs that a test needs to find a difference, and the smallest difference that a number of
// pairs can show. J. Cohen, "Statistical Power Analysis for the Behavioral Sciences", 2nd edition, 1988, chapter 2:
// two-sided, by noncentral t with pairs - 1 degrees of freedom.
//
// The p values of a sign-flip test of N uneven pairs are multiples of 2/2^N. Where nearly all pairs are uneven and
// their sizes differ, its power is the power of Student's t at the largest multiple within the level. At level 0.05,
// six pairs reach 2/64; five pairs can find nothing.
//
// Even pairs do not count in sign flips; their number is binomial. With many of them, or differences of few sizes,
// the power is that of a sign test with the same mean square of differences. By Cauchy and Schwarz a mean difference
// needs a share of uneven pairs of mean^2 / mean square.

enum class PairedTest { sign_flip, student_t };

struct PowerDesign {
  double alpha = 0.05;      // in (0, 1)
  std::int64_t family = 1;  // comparisons that share alpha by Holm, 1 or more: each uses alpha / family
  double power = 0.8;       // probability of finding the difference, in (alpha, 1)
  PairedTest test = PairedTest::sign_flip;
};

// Returns the least number of pairs (sign flips: uneven pairs) that allows a rejection. At level 0.05 this number is 6,
// and in a family of three tests 7.
std::int64_t smallest_pairs(const PowerDesign& design);

// How the difference of a pair spreads. Differences are means of pairs.
struct Spread {
  Spread(double of_pairs, double share = 1.0, double step = 0.0) : deviation(of_pairs), uneven(share), unit(step) {}
  explicit Spread(const Moments& of)  // two or more values, not all equal
      : Spread(of.standard_deviation(), static_cast<double>(of.uneven()) / static_cast<double>(of.count()), of.unit()) {
  }

  double deviation;     // standard deviation, in the unit of the differences, above 0
  double uneven, unit;  // share of differences other than 0, in (0, 1]; all are multiples of the unit (0: any numbers)
};

// Returns the probability of finding a difference with this number of pairs; 0 if the test cannot find anything.
double power_of(std::int64_t pairs, double difference, const Spread& spread, const PowerDesign& design);

inline constexpr std::int64_t most_pairs_asked = 1'000'000'000;

// Returns the number of pairs that finds `difference` (not 0, any sign); nothing if it exceeds most_pairs_asked.
std::optional<std::int64_t> pairs_needed(double difference, const Spread& spread, const PowerDesign& design);

// Returns the smallest difference that the test finds with this power. Returns nothing if no difference can be found.
std::optional<double> difference_found(std::int64_t pairs, const Spread& spread, const PowerDesign& design);

// Returns the ends of the 95 % confidence interval of a deviation that was estimated from `values` values, 2 or more:
// the wider of the interval of normal values (chi squared; ten values give 0.69 to 1.83 times the estimate) and that of
// the share of uneven pairs (Clopper and Pearson), with which the variance goes.
std::array<Spread, 2> spread_interval(const Spread& spread, std::int64_t values);

// Adjusts the p-values of several comparisons, in [0, 1] in any order. Order and ties stay the same. A caller may
// compare each adjusted p-value with the level as if there were no other comparison. Then the level bounds the
// probability of any false rejection. S. Holm, "A Simple Sequentially Rejective Multiple Test Procedure", Scandinavian
// Journal of Statistics 6, 1979.
std::vector<double> holm(std::span<const double> p);

}  // namespace regista::statistics
