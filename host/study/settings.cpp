// SPDX-License-Identifier: MIT
#include "study/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "campaign/job_setup.hpp"
#include "config/scalar.hpp"
#include "match/side.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

// What stands before the first dot, where it says which document is meant.
constexpr std::array<std::string_view, 2> of_both{"rules", "robot"};

// Those that are not the own team's.
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

void require_settable(const config::Node::Entry& entry, const std::string& what) {
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
}

void append(config::Overrides& to, const config::Overrides& more) { to.insert(to.end(), more.begin(), more.end()); }

}  // namespace

config::Overrides settings_of(const config::Node& set, const std::string& what) {
  config::Overrides out;
  for (const config::Node::Entry& entry : set.entries()) {
    require_settable(entry, what);
    out.emplace_back(entry.key, entry.value, entry.key_where);
  }
  return out;
}

config::Overrides settings_of(const config::Experiment& experiment, const config::Node& document, std::size_t arm,
                              std::size_t value) {
  config::Overrides out = settings_of(experiment.settings.set, "set");
  const config::Overrides own =
      settings_of(experiment.arms[arm].set, fmt::format("arm {}", texts::in_quotes(experiment.arms[arm].name)));
  append(out, own);
  if (!experiment.sweep) return out;
  const std::string& path = experiment.sweep->path;
  for (const config::Override& each : own) {
    if (each.path == path) throw config::Error(each.where, path + ": the sweep sets this path in every arm");
    if (is_inside(each.path, path) || is_inside(path, each.path)) {
      throw config::Error(each.where,
                          fmt::format("{}: the sweep sets {} in every arm, and one of them is a part of the other; "
                                      "name the other parts one by one",
                                      each.path, path));
    }
  }
  const config::Location where = document["sweep"]["path"].where();
  append(out, settings_of(config::Node::map({{path, where, experiment.sweep->values[value]}}, where), "sweep"));
  return out;
}

config::Overrides on_side(const config::Overrides& settings, std::size_t side) {
  const std::string own = side_name(side), other = side_name(1 - side);
  config::Overrides out = settings;
  for (config::Override& each : out) {
    const std::string_view document = first_part(each.path);
    const std::string rest = each.path.substr(document.size());
    if (document == "opponent") {
      each.path = other + rest;
    } else if (document == "disturbance") {
      each.path = own + "_disturbance" + rest;
    } else if (document == "opponent_disturbance") {
      each.path = other + "_disturbance" + rest;
    } else if (std::ranges::find(of_both, document) == of_both.end()) {
      each.path = fmt::format("{}.{}", own, each.path);
    }
  }
  return out;
}

std::vector<std::string> as_typed(const config::Overrides& settings) {
  std::vector<std::string> out;
  for (const config::Override& each : settings) out.push_back(to_string(each));
  return out;
}

campaign::Job job_under(const config::MatchSettings& settings, const std::vector<std::string>& plugins) {
  campaign::Job out;
  out.rules = settings.rules;
  out.robot = settings.robot;
  out.plugins = plugins;
  if (settings.limit) out.limit = config::real_text(*settings.limit);
  return out;
}

campaign::MatchSetup match_of(const campaign::Job& job, const config::Overrides& settings,
                              const config::Overrides& said, const plugin::Catalogue& catalogue) {
  campaign::MatchRequest request = campaign::request_of(job);
  request.overrides = settings;
  for (config::Override& each : request.overrides) {
    each.value = each.value.laid();
    each.where.laid = true;
  }
  try {
    return campaign::match_setup(request, catalogue);
  } catch (const config::Error& error) {
    // In a document its place does not say which path it was laid over.
    const auto is_of = [&error](const config::Location& where) {
      return where.line > 0 && where.line == error.where().line && where.column == error.where().column &&
             where.file == error.where().file;
    };
    const auto blamed = std::ranges::find_if(
        said, [&](const config::Override& each) { return is_of(each.where) || is_of(each.value.where()); });
    if (blamed == said.end()) throw;
    throw config::Error(error.where(), fmt::format("{}: {}", blamed->path, error.message()));
  }
}

}  // namespace regista::study
