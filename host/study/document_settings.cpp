// SPDX-License-Identifier: MIT
#include "study/document_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "campaign/job_setup.hpp"
#include "config/flow.hpp"
#include "config/nearest.hpp"
#include "config/text.hpp"
#include "match/side.hpp"
#include "study/study_inputs.hpp"

namespace regista::study {
namespace {

// What stands before the first dot, where it says which document is meant.
constexpr std::array<std::string_view, 2> of_both{"rules", "robot"};

// Those that are not the arm's team.
constexpr std::array<std::string_view, 5> documents{"opponent", "rules", "robot", "disturbance",
                                                    "opponent_disturbance"};

std::string example(std::string_view document) {
  const std::string_view inside = document == "opponent" ? "sender.plugin"
                                  : document == "rules"  ? "messages.budget"
                                  : document == "robot"  ? "walk.forward"
                                                         : "radio.loss";
  return fmt::format("{}.{}", document, inside);
}

std::string_view first_part(std::string_view path) { return path.substr(0, path.find('.')); }

std::string side_name(std::size_t side) {
  return std::string(match::name(side == 0 ? match::Side::home : match::Side::away));
}

// sender.params.period is inside sender.
bool is_inside(std::string_view path, std::string_view whole) {
  return path.size() > whole.size() && path.starts_with(whole) && path[whole.size()] == '.';
}

// The nearest of the known paths, best first.
std::vector<std::string> nearest(const std::string& asked, std::vector<std::string> known) {
  constexpr std::size_t shown = 3;
  std::ranges::stable_sort(known, {}, [&](const std::string& each) { return config::edit_distance(asked, each); });
  known.erase(std::unique(known.begin(), known.end()), known.end());
  if (known.size() > shown) known.resize(shown);
  return known;
}

}  // namespace

void add_settings(const config::Node& map, const std::string& what, std::vector<Setting>& out) {
  for (const config::Node::Entry& entry : map.entries()) {
    const std::string_view document = first_part(entry.key);
    if (document == "home" || document == "away" || document == "home_disturbance" || document == "away_disturbance") {
      throw config::Error(entry.key_where,
                          fmt::format("{}: {}: each arm plays at home and away; a path without that is of its team, "
                                      "one that begins with opponent of the other",
                                      what, entry.key));
    }
    if (document == "opening") {
      throw config::Error(entry.key_where, fmt::format("{}: {}: scenes are the same for all arms", what, entry.key));
    }
    if (document == entry.key && std::ranges::find(documents, document) != documents.end()) {
      throw config::Error(entry.key_where,
                          fmt::format("{}: {}: expected a path inside it, as in `{}`; the whole of it is named by a "
                                      "file, `{}:` of the experiment",
                                      what, entry.key, example(document), entry.key));
    }
    out.push_back({entry.key, config::flow(entry.value), entry.key_where, entry.value.where()});
  }
}

std::vector<Setting> settings_of(const config::Experiment& experiment, const config::Node& document, std::size_t arm,
                                 std::size_t value) {
  std::vector<Setting> out;
  add_settings(experiment.set, "set", out);
  const std::size_t common = out.size();
  add_settings(experiment.arms[arm].set, fmt::format("arm {}", config::in_quotes(experiment.arms[arm].name)), out);
  if (!experiment.sweep) return out;
  const std::string& path = experiment.sweep->path;
  const config::Location where = document["sweep"]["path"].where();
  for (std::size_t i = common; i < out.size(); ++i) {
    if (out[i].path == path) {
      throw config::Error(out[i].path_where, fmt::format("{}: the sweep sets this path in every arm", path));
    }
    if (is_inside(out[i].path, path) || is_inside(path, out[i].path)) {
      throw config::Error(out[i].path_where,
                          fmt::format("{}: the sweep sets {} in every arm, and one of them is a part of the other; "
                                      "name the other parts one by one",
                                      out[i].path, path));
    }
  }
  const config::Node& node = experiment.sweep->values[value];
  add_settings(config::Node::map({{path, where, node}}, where), "sweep", out);
  return out;
}

std::string override_of(const Setting& setting, std::size_t side) {
  const std::string_view document = first_part(setting.path);
  const std::string own = side_name(side), other = side_name(1 - side);
  std::string path = setting.path, rest = path.substr(document.size());
  if (document == "opponent") {
    path = other + rest;
  } else if (document == "disturbance") {
    path = own + "_disturbance" + rest;
  } else if (document == "opponent_disturbance") {
    path = other + "_disturbance" + rest;
  } else if (std::ranges::find(of_both, document) == of_both.end()) {
    path = fmt::format("{}.{}", own, path);
  }
  return fmt::format("{}={}", path, setting.value);
}

config::Error told_at_its_place(const config::Error& error, const std::vector<Setting>& settings, std::size_t side,
                                const std::function<std::vector<std::string>()>& known) {
  const auto meant = std::ranges::find_if(settings.rbegin(), settings.rend(), [&](const Setting& each) {
    return error.where().file == "--set " + override_of(each, side);
  });
  if (meant == settings.rend()) return error;
  std::string message = std::string(error.what()).substr(config::to_string(error.where()).size() + 2);
  const std::vector<std::string> paths = known();
  if (paths.empty() || std::ranges::find(paths, meant->path) != paths.end()) {
    return {meant->value_where, fmt::format("{}: {}", meant->path, message)};
  }
  return {meant->path_where, fmt::format("{}: no such path: {}; nearest paths: {}", meant->path, message,
                                         config::join(nearest(meant->path, paths)))};
}

campaign::MatchSetup settled_match(const campaign::Job& job, std::size_t side, const std::vector<Setting>& settings,
                                   const campaign::Job& bare, const plugin::Catalogue& catalogue) {
  try {
    return campaign::match_setup(campaign::request_of(job), catalogue);
  } catch (const config::Error& error) {
    throw told_at_its_place(error, settings, side, [&] {
      try {
        return settable_paths(bare, catalogue);
      } catch (const config::Error&) {  // of documents that are sound only with what is set
        return std::vector<std::string>();
      }
    });
  }
}

}  // namespace regista::study
