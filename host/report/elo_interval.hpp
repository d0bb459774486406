// SPDX-License-Identifier: MIT
// Whether the interval of Elo and the likelihood of superiority (LOS) may stand beside a verdict. Both take the mean
// score of the pairs for normally distributed, which a few pairs are not, and both answer the same question as the test
// that decides, which they must not contradict.
#pragma once

#include "report/tournament.hpp"
#include "statistics/counts.hpp"
#include "statistics/rating.hpp"
#include "study/tournament.hpp"

namespace regista::report {

// Pairs that are even say nothing of a difference; of the others ten make five to be expected for each team if they are
// equal, the usual rule for taking a binomial law for a normal one. By the exact law (uneven pairs all worth the same,
// however many even ones beside them), the interval of 95 % leaves equal teams out in up to 50 % of cases at two uneven
// pairs, 22 % at six, 15 % at ten or more and 10 % at sixteen or more. What is left of that is caught below: an
// interval is shown only where the exact test agrees with it about nought.
inline constexpr statistics::Count fewest_uneven_pairs = statistics::fewest_uneven;

statistics::Count uneven(const statistics::PairCounts& pairs);
bool enough_for_interval(const statistics::PairCounts& pairs);

enum class IntervalUse {
  shown,
  too_few_pairs,
  not_at_its_end,  // who looks again and again is misled by an interval for one look
  biased,          // a sequential test chose when to stop
  contradicted,    // the test of the verdict says no, and the interval yes, or the other way round
  unbounded,       // one team took all, or nearly all
};

// Precondition: the pairing has a complete pair.
IntervalUse interval_use(const TournamentView& view, std::size_t pairing);

}  // namespace regista::report
