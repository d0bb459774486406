// SPDX-License-Identifier: MIT
// A sequential test that is fed outcome by outcome. It must be fed in the order of the schedule, never in that in which
// matches happen to end: only then do slow matches not bias it, and it stops at the same place for any number of
// workers.
#pragma once

#include "statistics/counts.hpp"
#include "statistics/likelihood_ratio.hpp"
#include "statistics/overshoot.hpp"
#include "statistics/sequential_bounds.hpp"

namespace regista::statistics {

struct SequentialDesign {
  Model model = Model::normalized;
  Hypotheses hypotheses;
  ErrorRates rates;
  bool overshoot_correction = true;  // stop at lower + below(), upper - above()
};

// Counts is PairCounts or GameCounts.
template <class Counts>
class SequentialTest {
 public:
  using Outcome = typename Counts::Outcome;

  explicit SequentialTest(const SequentialDesign& design)
      : design_(design), wald_(sequential_bounds(design.rates)), stopping_(wald_) {}

  // Takes the next outcome. Once there is a verdict, it stands: later outcomes are ignored, and everything below tells
  // of the moment of the verdict.
  Verdict add(Outcome outcome);

  Verdict verdict() const { return verdict_; }
  const Counts& counts() const { return counts_; }
  LogLikelihoodRatio ratio() const { return ratio_; }      // 0 before the first outcome
  SequentialBounds bounds() const { return wald_; }        // without correction, as they are reported
  SequentialBounds stopping() const { return stopping_; }  // with it, as they were at the last outcome
  const SequentialDesign& design() const { return design_; }

 private:
  SequentialDesign design_;
  SequentialBounds wald_, stopping_;
  Counts counts_{};
  LogLikelihoodRatio ratio_{0.0, Method::exact};
  Overshoot overshoot_;
  Verdict verdict_ = Verdict::inconclusive;
};

extern template class SequentialTest<GameCounts>;
extern template class SequentialTest<PairCounts>;

// The verdict on one ratio.
Verdict verdict_on(LogLikelihoodRatio ratio, SequentialBounds bounds);

}  // namespace regista::statistics
