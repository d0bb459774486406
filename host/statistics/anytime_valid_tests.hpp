// SPDX-License-Identifier: MIT
// Tests of a mean that stay valid after any number of looks at the result. Bounded values: tests by betting.
// Symmetric values: a supermartingale. Many normal values: a mixture. All three use the inequality of J. Ville, 1939:
// evidence that is fair under the hypothesis has a probability of alpha or less of ever exceeding 1/alpha.
#pragma once

#include <cstdint>
#include <vector>

#include "statistics/moments.hpp"

namespace regista::statistics {

// --- Testing the mean of bounded values by betting. A gambler who believes that the mean is not m stakes a share of
// the capital on every next value, at odds that are fair if the mean is m. The capital is the evidence against m, for
// any distribution of the values within their bounds. The means against which no gambler became rich form a confidence
// sequence. I. Waudby-Smith and A. Ramdas, "Estimating means of bounded random variables by betting", Journal of the
// Royal Statistical Society B 86, 2024: predictable plug-in bets (their equations 24 to 26) and the hedged capital of
// theorem 3: two gamblers with half of the capital each; one bets on a true mean above m, the other on one below it.
//
// For goal differences, the mercy rule gives the bounds. Callers add the values in the order of the schedule.
// Precondition: the expectation of each value, given the values before it, is the same mean.

// The capital of one gambler: the product of all 1 + stake (value - mean), starting at 1. The class stores the product
// and not its logarithm, so that only log() has to compute a logarithm.
class Capital {
 public:
  // Precondition: the factor 1 + stake (value - mean) is between 1e-50 and 1e50.
  void bet(double stake, double value, double mean) {
    product_ *= 1.0 + stake * (value - mean);
    if (product_ > most || product_ < 1.0 / most) fold();
  }
  double log() const;  // nats

 private:
  static constexpr double most = 1e100;
  void fold();

  double product_ = 1.0;
  std::int64_t twos_ = 0;  // the capital is product_ times 2^twos_
};

// The capitals of two gamblers against one mean: one believes that the true mean is larger, the other that the true
// mean is smaller. Values and mean are in units of the range, in [0, 1].
class HedgedCapital {
 public:
  // stake: 0 or more, chosen before the value was known. The function limits the stake so that one value takes at most
  // three quarters of either capital.
  void bet(double stake, double value, double mean);
  double log_above() const { return above_.log(); }  // nats; the gambler who believes that the true mean is larger
  double log_below() const { return below_.log(); }  // nats; the gambler who believes that the true mean is smaller

 private:
  Capital above_, below_;
};

// Computes the stake for value number t from the values before it: sqrt(2 ln(2/alpha) / (variance t ln(t + 1))).
class PlugInStake {
 public:
  // variance: the expected variance of the values; see BettingDesign.
  explicit PlugInStake(double alpha, double variance = 0.25);
  double next() const;
  void learn(double value);  // value in [0, 1]

 private:
  double log_level_, expected_variance_;
  std::int64_t count_ = 0;
  double sum_ = 0.0, squares_ = 0.0;
};

// The values are in [low, high] with low < high, in any unit; alpha is in (0, 1).
struct BettingDesign {
  double low, high;
  double alpha = 0.05;
  // The expected standard deviation of the values; 0: half the range, the largest possible deviation. PlugInStake
  // counts this expectation like one observed value. The error rates hold for every expectation; a good expectation
  // improves the first stakes.
  double expected_deviation = 0.0;

  // Returns the expected variance of the values, in squares of the range.
  double expected_variance() const {
    const double share = expected_deviation > 0.0 ? expected_deviation / (high - low) : 0.5;
    return share * share;
  }
};

// Tests one mean with constant time and memory per value.
class BettingTest {
 public:
  // mean: the tested mean, in (low, high).
  BettingTest(const BettingDesign& design, double mean);

  // Precondition: low <= value <= high.
  void add(double value);

  enum class Finding { none, below, above };  // where the true mean is from the tested mean; none: undecided
  // A finding never changes. If the true mean equals the tested mean, a finding has a probability of at most alpha.
  Finding finding() const { return finding_; }
  // Returns ln of the current evidence, which is half of the larger capital. The test rejects the mean at ln(1/alpha).
  double log_evidence() const;
  double p() const;  // p value, valid at any time: min(1, 1 / the largest evidence so far)

 private:
  BettingDesign design_;
  double mean_;  // the tested mean in units of the range, in [0, 1]
  PlugInStake stake_;
  HedgedCapital capital_;
  double most_ = 0.0;
  Finding finding_ = Finding::none;
};

// Computes the confidence sequence in constant memory by testing all means of a grid together. A rejected mean stays
// rejected, which keeps the error rate and narrows the interval (the running intersection of Waudby-Smith and Ramdas).
class BettingGrid {
 public:
  // steps: 2 or more. The tested means divide [low, high] into this number of equal steps, and include both ends. An
  // even number of steps also tests the middle.
  BettingGrid(const BettingDesign& design, int steps);

  // Precondition: low <= value <= high.
  void add(double value);

  // With probability 1 - alpha the interval contains the true mean at all times simultaneously. The interval extends up
  // to one step beyond the means that are not rejected. Before the first value the interval is [low, high].
  Interval interval() const;

  // Returns where the true mean lies relative to `mean`, a tested mean. none: `mean` is not rejected.
  BettingTest::Finding finding(double mean) const;

 private:
  double point(int index) const;  // returns the tested mean with this index, in [0, 1]
  double in_units(double share) const { return design_.low + share * (design_.high - design_.low); }

  BettingDesign design_;
  int steps_;
  int first_ = 0, last_;  // indices of the first and the last mean that is not rejected
  std::vector<HedgedCapital> capitals_;
  PlugInStake stake_;
};

// --- A sequential test of the centre of values whose distribution is symmetric around the centre. The distribution may
// have any form and any bounds. If the centre is m, exp(b S - b^2 Q / 2) is a nonnegative supermartingale for every b,
// where S is the sum of value - m and Q is the sum of (value - m)^2 (V. H. de la Pena, "A General Class of Exponential
// Inequalities for Martingales and Ratios", Annals of Probability 27, 1999). The mixture over b with a normal
// distribution of variance tau^2 around 0 is
//   exp(tau^2 S^2 / (2 (1 + tau^2 Q))) / sqrt(1 + tau^2 Q).
//
// If two teams are equal in every respect, the distribution of their differences is symmetric. If the teams are equal
// only on average, the distribution may be asymmetric, and the test may reject too often. Example: a value is -0.9 one
// time in ten and otherwise 0.1, so the mean is 0. With 500 values the test rejects this mean in a tenth of all runs
// instead of a twentieth; with rarer and larger losses, in a quarter. Wide bounds weaken the tests by betting, which
// hold for any distribution within known bounds. This test needs no bounds.

class SymmetricTest {
 public:
  // deviation > 0: the expected standard deviation of a value, in the unit of the values. The error rates hold for
  // every expectation; a good expectation makes the test fastest. alpha in (0, 1): error rate of the interval.
  SymmetricTest(double deviation, double alpha);

  void add(double value);

  double mean() const { return count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_); }
  double p() const;  // two-sided p value of centre 0, valid at any time: min(1, 1 / the largest evidence so far)
  // Returns whether the mean was above 0 at the time of the largest evidence.
  bool above() const { return above_; }
  // With probability 1 - alpha the interval contains the centre at all times simultaneously. The interval is infinite
  // if the values do not bound the centre.
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

// --- The mixture sequential probability ratio test of the hypothesis that the mean of values is 0. The test is valid
// after any number of looks. H. Robbins, "Statistical Methods Related to the Law of the Iterated Logarithm", Annals of
// Mathematical Statistics 41, 1970; R. Johari et al., "Always Valid Inference", Operations Research 70, 2022.
//
// The test assumes normal values of known variance. With a variance that is estimated from the same values, the test
// holds only for many values. For bounded values, such as goal differences under a mercy rule, the tests by betting
// hold for any number of values.

// values: number of values. variance: of one value. mixing_variance tau^2 > 0: the square of the mean that the test
// finds fastest. Both variances are in squares of the unit of the values.
struct MixtureSample {
  std::int64_t values;
  double variance, mixing_variance;
};

// Returns a half width h: with probability 1 - alpha, alpha in (0, 1), the true mean is within h of the mean of the
// values at all times. At distance h the mixture ratio sqrt(s2 / (s2 + n tau2)) exp(n^2 tau2 mean^2 / (2 s2 (s2 + n
// tau2))) is 1/alpha. Returns infinity if there are no values or the variance is 0.
double mixture_half_width(const MixtureSample& sample, double alpha);

}  // namespace regista::statistics
