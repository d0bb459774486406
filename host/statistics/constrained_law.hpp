// SPDX-License-Identifier: MIT
// The most likely law of scores under a hypothesis: of all laws on the same scores whose mean score, or whose effect
// size (mean - 1/2) / sd, is a given number, the one under which the counts are most probable. Its optimum is
// q = p / (1 + theta phi), where theta makes the constraint hold: M. Van den Bergh, "The generalized sequential
// probability ratio test", 2019, section 3; for the mean it is the empirical likelihood of A. Owen, "Empirical
// Likelihood", 2001, chapter 2.
#pragma once

#include <array>
#include <optional>

#include "statistics/score_law.hpp"

namespace regista::statistics {

using Probabilities = std::array<double, 5>;  // the first law.outcomes are used

// The mean score is `mean`, of (0, 1): phi = score - mean. Nothing only where rounding leaves no room between `mean`
// and 0 or 1.
std::optional<Probabilities> most_likely_with_mean(const ScoreLaw& law, double mean);

// (mean - 1/2) / sd is `effect`, any finite number. The constraint is not linear; it is made so around the last law,
// from the uniform law on, for at most ten rounds: phi = score - 1/2 - effect sd (1 + ((score - mean) / sd)^2) / 2.
// Nothing where a round has no solution, as happens for effects far beyond what these scores can show.
std::optional<Probabilities> most_likely_with_effect(const ScoreLaw& law, double effect);

}  // namespace regista::statistics
