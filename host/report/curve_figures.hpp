// SPDX-License-Identifier: MIT
// Figures of how a tournament came to where it stands: strength, test and ranking over the pairs played.
#pragma once

#include <optional>
#include <span>

#include "report/course_record.hpp"
#include "report/figure.hpp"
#include "report/tournament.hpp"

namespace regista::report {

// Nothing where no point of the curve can be drawn.

// Elo of the first team with its interval of 95 %.
std::optional<Figure> elo_over_pairs(const TournamentView& view, std::span<const PairPoint> curve);
// The log-likelihood ratio of a test of scores, and where it stops.
std::optional<Figure> ratio_over_pairs(const TournamentView& view, std::span<const PairPoint> curve);
// The difference of goals, or of the metric that is tested, with its interval.
std::optional<Figure> value_over_pairs(const TournamentView& view, std::span<const PairPoint> curve);

// Elo of several teams: now with intervals, and over pairs for the first eight of the ranking.
std::optional<Figure> ranking_figure(const TournamentView& view);
std::optional<Figure> ranking_over_pairs(const TournamentView& view, std::span<const RankingPoint> curve);

}  // namespace regista::report
