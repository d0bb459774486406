// SPDX-License-Identifier: MIT
// What counts say about strength, as numbers people know: Elo, normalised Elo, likelihood of superiority, pair ratio.
//
// Elo: A. E. Elo, "The Rating of Chessplayers, Past and Present", 1978: a team that scores the share s of the points is
// -400 log10(1/s - 1) stronger. Normalised Elo: M. Van den Bergh, "Normalized Elo", 2021: the mean score above 1/2 in
// standard deviations of one game's score, times 800/ln 10 so that it is close to Elo where few games are drawn; it
// says how many games it takes to see a difference, which Elo does not.
//
// After a sequential test has stopped, every estimate here is biased towards the side that won the test.
#pragma once

#include <optional>

#include "statistics/counts.hpp"
#include "statistics/interval.hpp"
#include "statistics/score_law.hpp"

namespace regista::statistics {

inline constexpr double normalized_elo_scale = 347.43558552260146;  // 800 / ln 10

// Score in (0, 1) <-> Elo; at 0 and 1 the Elo is infinite.
double elo_of_score(double score);
double score_of_elo(double elo);  // 1 / (1 + 10^(-elo/400))

// Elo of the mean score; the interval is that of mean +- z sqrt(variance / units), mapped. A bound beyond a score of 0
// or 1 is infinite, and both are where no spread was seen: then nothing says how certain the value is.
Estimate elo(const ScoreLaw& law, double confidence = 0.95);

// 347.44 (mean - 1/2) / sd of one game; for pairs, sd of one game = sqrt(2 variance). The interval is
// +- 347.44 z / sqrt(games), the spread taken as known; infinite where no spread was seen.
Estimate normalized_elo(const ScoreLaw& law, double confidence = 0.95);

// Likelihood of superiority, in [0, 1]: Phi((mean - 1/2) / sqrt(variance / units)), 1/2 where no difference was seen.
// Where all of n units scored the same there is no variance to go by; then it is the posterior probability that units
// of this kind are the more frequent ones, by Bayes and a uniform prior: 1 - 2^-(n+1) for wins, 2^-(n+1) for losses.
double likelihood_of_superiority(const ScoreLaw& law);

// Pairs won to pairs lost: (WD + WW) / (LL + LD). Nothing where no pair was lost.
std::optional<double> pair_ratio(const PairCounts& counts);

}  // namespace regista::statistics
