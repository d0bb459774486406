// SPDX-License-Identifier: MIT
// Strengths of several teams from who beat whom: R. A. Bradley and M. E. Terry, "Rank Analysis of Incomplete Block
// Designs", Biometrika 39, 1952. Team i beats j with probability g_i / (g_i + g_j). The maximum of the likelihood by
// the minorisation-maximisation of D. R. Hunter, "MM Algorithms for Generalized Bradley-Terry Models", Annals of
// Statistics 32, 2004: g_i = wins_i / sum_j games_ij / (g_i + g_j); by Newton's where that takes too many rounds.
//
// A drawn game counts as half a win, and the two games of a pair are not independent, so the likelihood is not that of
// the results and its curvature no measure of certainty. Intervals are by the sandwich A B A (P. J. Huber, "The
// Behavior of Maximum Likelihood Estimates under Nonstandard Conditions", Fifth Berkeley Symposium, 1967): A the
// pseudo-inverse of the curvature, B the covariance of the points that were won, by the spread of pairs.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "statistics/encounter.hpp"
#include "statistics/interval.hpp"
#include "statistics/square_table.hpp"

namespace regista::statistics {

// `points.at(i, j)`: points that i won against j, 0 or more: 1 for a win, 1/2 for a draw. The diagonal is ignored.
// Result: Elo (400 log10 g) of each team, their sum 0. Empty for no team; 0 of a single one.
//
// Nothing where the counts do not tell the strengths: there is a team, or a group of them, that took no point from all
// others, or never met them (the condition of L. R. Ford, "Solution of a Ranking Problem from Binary Comparisons",
// American Mathematical Monthly 64, 1957). `drawn_before`, 0 or more, adds so many drawn games between every two teams,
// which always makes an answer exist, drawn a little towards 0.
std::optional<std::vector<double>> bradley_terry_elo(const SquareTable& points, double drawn_before = 0.0);

// The points of all encounters, as above; the same two teams may meet in several of them.
SquareTable points_won(std::size_t teams, std::span<const Encounter> encounters);

// The same with intervals, which hold for numbers of pairs that were fixed for each encounter beforehand. Pairs are
// independent, single games too. By Student's law, its degrees of freedom by F. E. Satterthwaite, "An Approximate
// Distribution of Estimates of Variance Components", Biometrics Bulletin 2, 1946. Infinite where the pairs and games of
// a team do not tell its spread: fewer than `fewest_uneven` (rating.hpp) were uneven, or all were won, or all lost.
std::optional<std::vector<Estimate>> bradley_terry(std::size_t teams, std::span<const Encounter> encounters,
                                                   double confidence = 0.95);

}  // namespace regista::statistics
