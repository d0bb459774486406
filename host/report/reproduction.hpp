// SPDX-License-Identifier: MIT
// The command that plays a tournament again, from its plan.
#pragma once

#include <string>
#include <vector>

#include "study/tournament_plan.hpp"

namespace regista::report {

// The words of `regista tournament` after the name of the program. Paths are relative to plan.folder.
std::vector<std::string> tournament_arguments(const study::TournamentPlan& plan);

}  // namespace regista::report
