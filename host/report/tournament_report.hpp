// SPDX-License-Identifier: MIT
// The report of a tournament.
#pragma once

#include <memory>

#include "report/study_report.hpp"
#include "study/tournament_plan.hpp"

namespace regista::report {

// again: as it is shown to the reader.
std::unique_ptr<StudyReport> tournament_report(study::TournamentPlan plan, CommandOf again);

}  // namespace regista::report
