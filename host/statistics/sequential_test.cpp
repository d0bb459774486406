// SPDX-License-Identifier: MIT
#include "statistics/sequential_test.hpp"

namespace regista::statistics {

Verdict verdict_on(LogLikelihoodRatio ratio, SequentialBounds bounds) {
  if (ratio.value >= bounds.upper) return Verdict::accept_h1;
  if (ratio.value <= bounds.lower) return Verdict::accept_h0;
  return Verdict::inconclusive;
}

template <class Counts>
Verdict SequentialTest<Counts>::add(Outcome outcome) {
  if (verdict_ != Verdict::inconclusive) return verdict_;
  counts_.add(outcome);
  ratio_ = log_likelihood_ratio(score_law(counts_), design_.model, design_.hypotheses);
  overshoot_.update(ratio_.value);
  if (design_.overshoot_correction) {
    stopping_ = {wald_.lower + overshoot_.below(), wald_.upper - overshoot_.above()};
  }
  verdict_ = verdict_on(ratio_, stopping_);
  return verdict_;
}

template class SequentialTest<GameCounts>;
template class SequentialTest<PairCounts>;

}  // namespace regista::statistics
