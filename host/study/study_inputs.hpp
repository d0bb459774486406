// SPDX-License-Identifier: MIT
// What studies of many matches read from files before the first one: scenes, and which numbers matches will have.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "config/bad_input.hpp"
#include "config/declaration.hpp"
#include "config/opening.hpp"
#include "match/match.hpp"
#include "mind/team_plan.hpp"
#include "plugin/catalogue.hpp"
#include "study/opening.hpp"

namespace regista::study {

// Files as they are; of a folder all that end in .yaml, by name. who: the beginning of what config::BadInput says.
std::vector<std::string> opening_files(const std::vector<std::string>& paths, const std::string& who);

// Throws config::BadInput, which begins with `who`, for a second scene of the same name.
void add_scene(std::vector<Opening>& scenes, Opening scene, const std::string& name, const std::string& who);

// The scenes that a document names, as the study plays them and as they were read. Throws config::Error for one that
// the rules and robots of a match do not go with.
struct DocumentScenes {
  std::vector<Opening> openings;
  std::vector<config::Opening> read;
};
DocumentScenes document_scenes(const std::vector<config::NamedPath>& paths, std::span<match::Setup> setups);

// A file as it is seen from the folder the study is begun in, where it is inside.
std::string from_here(const std::string& absolute);

// What both teams share whatever the scene is.
match::Setup without_opening(match::Setup setup);

// Every path of a team's metrics, from a match that was not played.
std::vector<std::string> metric_paths_of(const mind::TeamPlan& team);

}  // namespace regista::study
