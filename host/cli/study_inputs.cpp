// SPDX-License-Identifier: MIT
#include "cli/study_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "cli/end_of_program.hpp"
#include "cli/match_report.hpp"
#include "match/names.hpp"
#include "match/teams.hpp"
#include "study/metric.hpp"

namespace regista::cli {

std::vector<std::string> opening_files(const std::vector<std::string>& paths, const std::string& who) {
  std::vector<std::string> out;
  for (const std::string& each : paths) {
    std::error_code error;
    if (!std::filesystem::is_directory(each, error)) {
      out.push_back(each);
      continue;
    }
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(each, error)) {
      if (entry.path().extension() == ".yaml") found.push_back(entry.path().string());
    }
    if (error) throw BadInput(fmt::format("{} {}: {}", who, each, error.message()));
    if (found.empty()) throw BadInput(fmt::format("{} {}: there is no .yaml file in this folder", who, each));
    std::ranges::sort(found);
    out.insert(out.end(), found.begin(), found.end());
  }
  return out;
}

void add_scene(std::vector<study::Opening>& scenes, study::Opening scene, const std::string& name,
               const std::string& who) {
  const auto same = std::ranges::find(scenes, scene.input.name, [](const auto& each) { return each.input.name; });
  if (same != scenes.end()) {
    throw BadInput(same->file == scene.file
                       ? fmt::format("{}: {} is given twice", who, scene.file)
                       : fmt::format("{}: {} and {} have the same name, {}", who, same->file, scene.file, name));
  }
  scenes.push_back(std::move(scene));
}

match::Setup without_opening(match::Setup setup) {
  setup.opening.reset();
  return setup;
}

std::vector<std::string> metric_paths_of(const mind::TeamPlan& team) {
  PlayedMatch played;
  played.role_names[0] = played.role_names[1] = match::role_names(match::roles(team));
  for (match::TeamMetrics& metrics : played.result.metrics.teams) {
    metrics.coordination.roles.resize(played.role_names[0].size());
  }
  return study::metric_paths(summary_json(played), 0);
}

}  // namespace regista::cli
