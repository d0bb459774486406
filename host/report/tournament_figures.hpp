// SPDX-License-Identifier: MIT
// The figures of a tournament: tables and how they are drawn, a pure function of what was played.
#pragma once

#include <vector>

#include "report/course_record.hpp"
#include "report/figure.hpp"
#include "report/tournament.hpp"

namespace regista::report {

// Of two teams: "elo", "llr" (a test of scores) or "value" (goals, or the metric that is tested) over pairs;
// "goal_differences"; "roles"; "packets". Of more: "ranking", "elo". A figure that has nothing to show is left out.
std::vector<Figure> tournament_figures(const TournamentView& view, const CourseRecord& record);

}  // namespace regista::report
