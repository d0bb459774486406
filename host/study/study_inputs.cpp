// SPDX-License-Identifier: MIT
#include "study/study_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "campaign/inputs.hpp"
#include "config/bad_input.hpp"
#include "config/documents.hpp"
#include "config/read.hpp"
#include "match/metric_table.hpp"
#include "match/names.hpp"
#include "match/teams.hpp"

namespace regista::study {

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
    if (error) throw config::BadInput(fmt::format("{} {}: {}", who, each, error.message()));
    if (found.empty()) throw config::BadInput(fmt::format("{} {}: there is no .yaml file in this folder", who, each));
    std::ranges::sort(found);
    out.insert(out.end(), found.begin(), found.end());
  }
  return out;
}

void add_scene(std::vector<Opening>& scenes, Opening scene, const std::string& name, const std::string& who) {
  const auto same = std::ranges::find(scenes, scene.input.name, [](const auto& each) { return each.input.name; });
  if (same != scenes.end()) {
    throw config::BadInput(same->file == scene.file ? fmt::format("{}: {} is given twice", who, scene.file)
                                                    : fmt::format("{}: {} and {} have the same name, {}", who,
                                                                  same->file, scene.file, name));
  }
  scenes.push_back(std::move(scene));
}

DocumentScenes document_scenes(const std::vector<config::NamedPath>& paths, std::span<match::Setup> setups) {
  DocumentScenes out;
  for (const config::NamedPath& path : paths) {
    const std::string who = config::to_string(path.where) + ": openings";
    for (const std::string& file : opening_files({path.path}, who)) {
      const config::Node document = config::load(file);
      const config::Opening opening = config::read_document<config::Opening>(document);
      for (const match::Setup& setup : setups) {
        if (const auto misfit = config::misfit(opening, setup.rules, setup.robots)) {
          config::refuse(document, {misfit->path}, misfit->reason);
        }
      }
      add_scene(out.openings, {from_here(file), campaign::opening_input(opening)}, opening.name, who);
      out.read.push_back(opening);
    }
  }
  return out;
}

std::string from_here(const std::string& absolute) {
  if (absolute.empty()) return absolute;
  const auto relative = std::filesystem::path(absolute).lexically_relative(std::filesystem::current_path());
  return relative.empty() || relative.native().starts_with("..") ? absolute : relative.string();
}

match::Setup without_opening(match::Setup setup) {
  setup.opening.reset();
  return setup;
}

std::vector<std::string> metric_paths_of(const mind::TeamPlan& team) {
  match::MemberNames names{match::role_names(match::roles(team)), team.reasons()};
  for (const mind::TeamMetric& each : team.metrics()) {
    (each.combine == REGISTA_METRIC_SUM ? names.plugin_totals : names.plugin_values).push_back(each.name);
  }
  return match::metric_paths(match::metric_table(), names);
}

}  // namespace regista::study
