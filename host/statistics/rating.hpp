// SPDX-License-Identifier: MIT
// What counts say about strength, as numbers people know: Elo, normalised Elo, likelihood of superiority, pair ratio.
//
// Elo: A. E. Elo, "The Rating of Chessplayers, Past and Present", 1978: a team that scores the share s of the points is
// -400 log10(1/s - 1) stronger. Normalised Elo: M. Van den Bergh, "Normalized Elo", 2021: the mean score above 1/2 in
// standard deviations of one game's score, times 800/ln 10 so that it is close to Elo where few games are drawn; it
// says how many games it takes to see a difference, which Elo does not. Its interval: E. Mertens, "Comments on variance
// of the IID estimator in Lo (2002)", 2002, as the effect is a Sharpe ratio.
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

// 347.44 (mean - 1/2) / sd of one game; for pairs, sd of one game = sqrt(2 variance).
//
// The interval is that of the effect d = (mean - 1/2) / sd by the delta method, in which the spread is uncertain, too:
// d +- t sqrt((1 - d skewness + d^2 (kurtosis - 1) / 4) / (units - 1)), with skewness and kurtosis (3 of a normal law)
// of the scores of units, and t by Student's law: units - 1 degrees of freedom, or fewer where a few units make most of
// that variance. Infinite on both sides where few_for_spread().
Estimate normalized_elo(const ScoreLaw& law, double confidence = 0.95);

// Why the units do not tell the spread well enough for an interval of normalised Elo. By simulation
// (benchmarks/statistics/coverage.cpp), intervals of fewer would hold the truth in less than 90 % of cases.
enum class FewForSpread {
  no,
  uneven,  // fewer than fewest_uneven units did not score 1/2
  won,     // the leading team won every one: what it takes to lose points was not seen
};
inline constexpr Count fewest_uneven = 10;
FewForSpread few_for_spread(const ScoreLaw& law);

// Likelihood of superiority, in [0, 1]: Phi((mean - 1/2) / sqrt(variance / units)), 1/2 where no difference was seen.
// Where all of n units scored the same there is no variance to go by; then it is the posterior probability that units
// of this kind are the more frequent ones, by Bayes and a uniform prior: 1 - 2^-(n+1) for wins, 2^-(n+1) for losses.
double likelihood_of_superiority(const ScoreLaw& law);

// Pairs won to pairs lost: (WD + WW) / (LL + LD). Nothing where no pair was lost.
std::optional<double> pair_ratio(const PairCounts& counts);

}  // namespace regista::statistics
