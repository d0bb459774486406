// SPDX-License-Identifier: MIT
// Testing the mean of bounded values by betting: a gambler who thinks that the mean is not m stakes a share of the
// capital on every next value, at odds that are fair if it is m. Then the capital exceeds 1/alpha at any time at all
// with probability alpha or less (J. Ville, 1939), whatever the law of the values within their bounds and however often
// one looks. The means at which no gambler got rich are a confidence sequence. I. Waudby-Smith and A. Ramdas,
// "Estimating means of bounded random variables by betting", Journal of the Royal Statistical Society B 86, 2024:
// predictable plug-in bets (their equations 24 to 26) and the hedged capital of theorem 3, with a half staked on either
// side.
//
// For goal differences the mercy rule gives the bounds. The values come in the order of the schedule; given those
// before, each has the same mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "statistics/interval.hpp"

namespace regista::statistics {

// One gambler's capital, from 1 on: the product of 1 + bet (value - mean). Kept as a product, so that a logarithm is
// taken for each look at it and not for each bet.
class Capital {
 public:
  // Precondition: the factor is between 1e-50 and 1e50.
  void bet(double stake, double value, double mean) {
    product_ *= 1.0 + stake * (value - mean);
    if (product_ > most || product_ < 1.0 / most) fold();
  }
  double log() const;  // nats

 private:
  static constexpr double most = 1e100;
  void fold();

  double product_ = 1.0;
  std::int64_t twos_ = 0;  // factors of 2 besides
};

// The two gamblers against one mean: all in units of the range, values and mean in [0, 1].
class HedgedCapital {
 public:
  // Takes a value and the stake that was chosen before it was known, 0 or more. It is cut so that no value can take
  // more than three quarters of a capital.
  void bet(double stake, double value, double mean);
  double log_above() const { return above_.log(); }  // of the one who thinks that the true mean is larger
  double log_below() const { return below_.log(); }

 private:
  Capital above_, below_;
};

// How much to stake on the next value, from those before it: sqrt(2 ln(2/alpha) / (variance t ln(t + 1))), t its
// number.
class PlugInStake {
 public:
  // variance: what is expected of the values, before any is known; see BettingDesign.
  explicit PlugInStake(double alpha, double variance = 0.25);
  double next() const;
  void learn(double value);  // in [0, 1]

 private:
  double log_level_, expected_variance_;
  std::int64_t count_ = 0;
  double sum_ = 0.0, squares_ = 0.0;
};

// Values of [low, high], low < high, in any unit; alpha in (0, 1).
struct BettingDesign {
  double low, high;
  double alpha = 0.05;
  // What their standard deviation is expected to be; it counts as one value. All promises hold whatever is expected; a
  // good guess makes the first stakes worth while. 0: half the range, the largest there is.
  double expected_deviation = 0.0;

  // In units of the range.
  double expected_variance() const {
    const double share = expected_deviation > 0.0 ? expected_deviation / (high - low) : 0.5;
    return share * share;
  }
};

// The test of one mean, in constant time and memory per value.
class BettingTest {
 public:
  // mean in (low, high)
  BettingTest(const BettingDesign& design, double mean);

  // Precondition: the value is of [low, high].
  void add(double value);

  enum class Finding { none, below, above };  // where the true mean is, seen from the tested one
  // Once found, it stays. With probability alpha or less it is ever other than none though the mean is the tested one.
  Finding finding() const { return finding_; }
  // ln of the evidence now: the larger capital, halved. At ln(1/alpha) it is enough.
  double log_evidence() const;
  double p() const;  // min(1, 1 / the largest evidence so far): valid at all times

 private:
  BettingDesign design_;
  double mean_;  // of [0, 1]
  PlugInStake stake_;
  HedgedCapital capital_;
  double most_ = 0.0;
  Finding finding_ = Finding::none;
};

// The confidence sequence for the mean, which remembers all values: 16 bytes each, and some fifty passes over them for
// an interval.
class BettingSequence {
 public:
  explicit BettingSequence(const BettingDesign& design);

  // Precondition: the value is of [low, high].
  void add(double value);

  // Contains the true mean at all times together with probability 1 - alpha. [low, high] before the first value.
  // It excludes exactly the means that a BettingTest would at this moment.
  Interval interval() const;
  double mean() const;  // of the values; the middle of the range before the first
  std::size_t values() const { return past_.size(); }

 private:
  struct Bet {
    double stake, value;
  };
  double log_evidence(double mean) const;
  double bound(double from, double inside) const;

  BettingDesign design_;
  PlugInStake stake_;
  std::vector<Bet> past_;
  double sum_ = 0.0;
};

}  // namespace regista::statistics
