// SPDX-License-Identifier: MIT
// What playing in pairs gains: the variance of the mean of a pair over that of two games that have nothing in common.
// At 0.5 pairs need half the games for the same certainty, at 1 pairing changes nothing, above 1 it harms. The idea is
// that of common random numbers and antithetic variates: A. M. Law, "Simulation Modeling and Analysis", chapter 11.
#pragma once

#include <optional>
#include <span>

#include "statistics/counts.hpp"
#include "statistics/moments.hpp"

namespace regista::statistics {

// 2 (variance of a pair's score) / (variance of a game's score). The games may be those of the pairs, or more. Nothing
// where there is no pair, no game, or all games scored the same.
std::optional<double> variance_ratio(const PairCounts& pairs, const GameCounts& games);

// One pair of values, such as the goal differences of two games, both from the first team's point of view.
struct ValuePair {
  double first, second;
};

// The same for values: 2 (variance of (first + second) / 2) / (variance of all). Nothing where there are fewer than two
// pairs, or all values are equal.
std::optional<double> variance_ratio(std::span<const ValuePair> pairs);
// The same of values that were not kept: the means of the pairs, and every value.
std::optional<double> variance_ratio(const Moments& means, const Moments& all);

}  // namespace regista::statistics
