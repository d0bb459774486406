// SPDX-License-Identifier: MIT
// Whether a difference between two conditions of an experiment stands whatever the pairs of matches that could not be
// played would have shown. Measures have no bounds, so a single such pair could outweigh all others in their mean: what
// would have been seen cannot be bounded by what was. Two things can be asked, and both are:
//   - by size: the test of the plan with each missing value set to the largest, and to the smallest, that either
//     condition has shown; but who loses its most extreme matches also loses these values, so that this is not enough;
//   - by signs, which need no bounds: a test of the signs of differences with all missing ones against the finding.
// Only a difference that both find, in both directions and for the same side, is found.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "study/paired_estimates.hpp"

namespace regista::study {

// A measure of one condition, by pair; no number where it is missing.
struct PartlyPlayed {
  std::span<const double> values;
  const std::vector<bool>& unplayed;  // as many: it is missing because a match could not be played
};

// Pairs of which either condition's could not be played.
std::uint64_t unplayed_pairs(const PartlyPlayed& first, const PartlyPlayed& second);

// The largest of the p of "no difference", two-sided: without those pairs, and of the four ways above to count them. 1
// where these do not speak for the same side. Without such pairs that of p_of_difference(), or 1 where there is none.
double p_either_way(const PartlyPlayed& first, const PartlyPlayed& second, PairTest test);

}  // namespace regista::study
