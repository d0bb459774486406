// SPDX-License-Identifier: MIT
// What studies of many matches read from files before the first one: scenes, and which numbers matches will have.
#pragma once

#include <string>
#include <vector>

#include "match/match.hpp"
#include "mind/team_plan.hpp"
#include "study/opening.hpp"

namespace regista::cli {

// Files as they are; of a folder all that end in .yaml, by name. who: the beginning of what BadInput says.
std::vector<std::string> opening_files(const std::vector<std::string>& paths, const std::string& who);

// Throws BadInput, which begins with `who`, for a second scene of the same name.
void add_scene(std::vector<study::Opening>& scenes, study::Opening scene, const std::string& name,
               const std::string& who);

// What both teams share whatever the scene is.
match::Setup without_opening(match::Setup setup);

// Every path of a team's metrics, from a match that was not played.
std::vector<std::string> metric_paths_of(const mind::TeamPlan& team);

}  // namespace regista::cli
