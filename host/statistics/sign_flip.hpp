// SPDX-License-Identifier: MIT
// How surprising the scores of pairs are if the teams are equal: then each pair could as well have gone the other way
// round, and the sum of the scores above 1/2 is as likely to have any of its signs. Exact for any number of pairs,
// given which of them were decided and by how much. R. A. Fisher, "The Design of Experiments", 1935, section 21.
#pragma once

#include <span>

#include "statistics/counts.hpp"

namespace regista::statistics {

// Two-sided, in (0, 1]: the probability of a sum as far from 0 or farther, over all 2^N signs. 1 where every pair was
// even. Beyond a few thousand decided pairs by the normal law with continuity correction.
double sign_flip_p(const PairCounts& pairs);

// The same for one finite value per pair, such as the difference of two teams: of their sum, over all signs that the
// values other than 0 could have. Exact for up to 32 of these, beyond by the normal law without continuity correction.
double sign_flip_p_of_values(std::span<const double> values);
bool sign_flip_of_values_is_exact(std::span<const double> values);

}  // namespace regista::statistics
