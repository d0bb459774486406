// SPDX-License-Identifier: MIT
// Strengths of several teams from who beat whom: R. A. Bradley and M. E. Terry, "Rank Analysis of Incomplete Block
// Designs", Biometrika 39, 1952. Team i beats j with probability g_i / (g_i + g_j). The maximum of the likelihood by
// the minorisation-maximisation of D. R. Hunter, "MM Algorithms for Generalized Bradley-Terry Models", Annals of
// Statistics 32, 2004: g_i = wins_i / sum_j games_ij / (g_i + g_j).
#pragma once

#include <optional>
#include <vector>

#include "statistics/interval.hpp"
#include "statistics/square_table.hpp"

namespace regista::statistics {

// `points.at(i, j)`: points that i won against j, 0 or more: 1 for a win, 1/2 for a draw. The diagonal is ignored.
// Result: Elo (400 log10 g) of each team, their sum 0, with intervals from the curvature of the likelihood; draws make
// the true intervals narrower than these. Empty for no team; a single team has 0 without interval.
//
// Nothing where the counts do not tell the strengths: there is a team, or a group of them, that took no point from all
// others, or never met them (the condition of L. R. Ford, "Solution of a Ranking Problem from Binary Comparisons",
// American Mathematical Monthly 64, 1957). `drawn_before`, 0 or more, adds so many drawn games between every two teams,
// which always makes an answer exist, drawn a little towards 0.
std::optional<std::vector<Estimate>> bradley_terry(const SquareTable& points, double confidence = 0.95,
                                                   double drawn_before = 0.0);

}  // namespace regista::statistics
