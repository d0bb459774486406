// SPDX-License-Identifier: MIT
#include "study/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include "config/documents.hpp"
#include "config/read.hpp"
#include "config/scalar.hpp"
#include "match/chance.hpp"
#include "match/game_state.hpp"
#include "match/metric_table.hpp"
#include "match/teams.hpp"
#include "plugin/shared_object.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

// A document of a match that is not the own team's document. name: first key of its paths. key: the key of the study's
// document that names its file; version 0.2 used it as the first key of paths, too. inside: example of a path inside
// it. on_side: first key of its paths in a match with the own team at home, away.
struct OtherDocument {
  std::string_view name, key, inside;
  std::array<std::string_view, 2> on_side;
};
constexpr std::array<OtherDocument, 5> documents{
    {{"b", "opponent", "sender.plugin", {"away", "home"}},
     {"rules", "rules", "messages.budget", {"rules", "rules"}},
     {"robot", "robot", "walk.forward", {"robot", "robot"}},
     {"a_disturbance", "disturbance", "radio.loss", {"home_disturbance", "away_disturbance"}},
     {"b_disturbance", "opponent_disturbance", "radio.loss", {"away_disturbance", "home_disturbance"}}}};

auto document_of(std::string_view path) { return std::ranges::find(documents, first_part(path), &OtherDocument::name); }

// Returns whether `path` lies inside `whole`. Example: sender.params.period lies inside sender.
bool is_inside(std::string_view path, std::string_view whole) {
  return path.size() > whole.size() && path.starts_with(whole) && path[whole.size()] == '.';
}

// Returns the path without `a.`, as the study's own team needs no letter, and with the present names of documents.
std::string present_path(const std::string& path) {
  const std::string_view first = first_part(path);
  if (first == "a" && first.size() < path.size()) return path.substr(2);
  const auto former = std::ranges::find(documents, first, &OtherDocument::key);
  return former == documents.end() ? path : std::string(former->name) + path.substr(first.size());
}

void require_settable(const config::Node::Entry& entry, const std::string& what) {
  const auto refuse = [&](const std::string& why) {
    throw config::Error(entry.key_where, fmt::format("{}: {}: {}", what, entry.key, why));
  };
  const std::string_view first = first_part(entry.key);
  if (first == "home" || first == "away" || first == "home_disturbance" || first == "away_disturbance")
    refuse("each arm plays at home and away; a path without that is of its team, one that begins with b of the other");
  if (first == "opening") refuse("scenes are the same for all arms");
  const std::string path = present_path(entry.key);
  const auto document = document_of(path);
  if (document != documents.end() && document->name == path)
    refuse(
        fmt::format("expected a path inside it, as in `{}.{}`; the whole of it is named by a file, `{}:` of the "
                    "experiment",
                    document->name, document->inside, document->key));
}

}  // namespace

std::vector<campaign::Input> inputs_of(std::span<const Opening> openings) {
  std::vector<campaign::Input> out;
  for (const Opening& each : openings) out.push_back(each.input);
  return out;
}

const char* games_in_words(std::span<const Opening> openings) {
  return openings.empty() ? "matches" : "games from scenes";
}

std::string_view first_part(std::string_view path) { return path.substr(0, path.find('.')); }

std::string scenes_in_words(std::span<const Opening> openings, std::optional<double> limit) {
  std::string out = texts::plural(openings.size(), "scene", "scenes");
  double sum = 0.0;
  for (const Opening& each : openings) {
    if (each.length <= 0.0) return out;
    sum += std::min(each.length, limit.value_or(each.length));
  }
  return openings.empty() ? out : fmt::format("{} of about {:.0f} s", out, sum / static_cast<double>(openings.size()));
}

std::size_t drawn_opening(std::uint64_t seed, std::size_t openings) {
  constexpr std::uint32_t purpose = 0x6f70656e;  // "open" in ASCII; other uses of the seed have other numbers
  match::RandomWords words(purpose, {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), 0, 0});
  const std::uint64_t high = words.next();
  return static_cast<std::size_t>((high << 32 | words.next()) % openings);
}

void require_present_names(const config::Node& set, const std::string& what) {
  for (const config::Node::Entry& entry : set.entries()) {
    const std::string now = present_path(entry.key);
    const bool whole_document = first_part(entry.key) == entry.key;  // settings_of() refuses it
    if (first_part(entry.key) == "a" || whole_document || now == entry.key) continue;
    throw config::Error(entry.key_where,
                        fmt::format("{}: {}: the study's own team is called a and the other b, as in all commands: {}",
                                    what, entry.key, now));
  }
}

config::Overrides settings_of(const config::Node& set, const std::string& what) {
  config::Overrides out;
  for (const config::Node::Entry& entry : set.entries()) {
    require_settable(entry, what);
    out.emplace_back(present_path(entry.key), entry.value, entry.key_where);
  }
  return out;
}

config::Overrides settings_of(const config::Experiment& experiment, const config::Node& document, std::size_t arm,
                              std::size_t value) {
  config::Overrides out = settings_of(experiment.settings.set, "set");
  const config::Overrides own =
      settings_of(experiment.arms[arm].set, fmt::format("arm {}", texts::in_quotes(experiment.arms[arm].name)));
  out.insert(out.end(), own.begin(), own.end());
  if (!experiment.sweep) return out;
  const std::string path = present_path(experiment.sweep->path);
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
  std::ranges::copy(
      settings_of(config::Node::map({{experiment.sweep->path, where, experiment.sweep->values[value]}}, where),
                  "sweep"),
      std::back_inserter(out));
  return out;
}

bool is_of_own_team(std::string_view path) { return document_of(path) == documents.end(); }

config::Overrides on_side(const config::Overrides& settings, std::size_t side) {
  config::Overrides out = settings;
  for (config::Override& each : out) {
    const auto document = document_of(each.path);
    if (document == documents.end()) {
      each.path.insert(0, side == 0 ? "home." : "away.");
    } else {
      each.path.replace(0, document->name.size(), document->on_side[side]);
    }
  }
  return out;
}

std::vector<std::string> as_typed(const config::Overrides& settings) {
  return texts::names_of(settings, [](const config::Override& each) { return to_string(each); });
}

std::uint64_t first_seed(std::int64_t seed, config::Seeds seeds) {
  if (seeds == config::Seeds::consecutive) return static_cast<std::uint64_t>(seed);
  return plugin::content_hash_32(std::to_string(seed));
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
  config::Overrides laid = settings;
  for (config::Override& each : laid) {
    each.value = each.value.laid();
    each.where.laid = true;
  }
  try {
    return campaign::match_setup(job, laid, campaign::team_reader(catalogue));
  } catch (const config::Error& error) {
    // Finds the setting at the error's place, because the place in a document does not show which path was set.
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

void ask_for(OwnJobs& jobs, const OwnMatches& asked, const config::MatchSettings& under,
             const std::vector<std::string>& plugins) {
  for (const std::size_t side : {0u, 1u}) {
    campaign::Job made = job_under(under, plugins);
    made.teams[side] = asked.team;
    made.teams[1 - side] = asked.opponent;
    made.home_disturbance = side == 0 ? asked.disturbance : asked.opponent_disturbance;
    made.away_disturbance = side == 0 ? asked.opponent_disturbance : asked.disturbance;
    made.overrides = as_typed(on_side(asked.settings, side));
    campaign::Job& job = jobs[side];
    made.home_inputs = std::move(job.home_inputs);
    made.away_inputs = std::move(job.away_inputs);
    made.common_inputs = std::move(job.common_inputs);
    job = std::move(made);
  }
}

campaign::MatchSetup find_inputs(OwnJobs& jobs, const config::Overrides& settings, const plugin::Catalogue& catalogue,
                                 const std::string& program, const std::string& mathematics) {
  const auto prepare = [&](std::size_t side) {
    campaign::Job& job = jobs[side];
    campaign::MatchSetup prepared = match_of(job, on_side(settings, side), settings, catalogue);
    campaign::FoundInputs found = campaign::inputs_of(prepared, catalogue, program, mathematics);
    job.home_inputs = std::move(found.home);
    job.away_inputs = std::move(found.away);
    job.common_inputs = std::move(found.common);
    return prepared;
  };
  campaign::MatchSetup first = prepare(0);
  prepare(1);
  return first;
}

campaign::Store::Fixture fixture_of(campaign::Job job) {
  return {campaign::fixture_key(job.home_inputs, job.away_inputs, job.common_inputs), std::move(job)};
}

std::vector<std::string> opening_files(const std::string& path, const std::string& who) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) return {path};
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(path, error)) {
    if (entry.path().extension() == ".yaml") out.push_back(entry.path().string());
  }
  if (error) throw config::BadInput(fmt::format("{} {}: {}", who, path, error.message()));
  if (out.empty()) throw config::BadInput(fmt::format("{} {}: there is no .yaml file in this folder", who, path));
  std::ranges::sort(out);
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
    for (const std::string& file : opening_files(path.path, who)) {
      const config::Node document = config::load(file);
      const config::Opening opening = config::read_document<config::Opening>(document);
      for (const match::Setup& setup : setups) {
        if (const auto misfit = config::misfit(opening, setup.rules, setup.robots)) {
          config::refuse(document, {misfit->path}, misfit->reason);
        }
      }
      add_scene(out.openings, {from_here(file), campaign::opening_input(opening), opening.length}, opening.name, who);
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

std::vector<std::string> metric_paths_of(const mind::TeamPlan& team) {
  match::MemberNames names{match::role_names(match::roles(team)), team.reasons()};
  for (const mind::TeamMetric& each : team.metrics()) {
    (each.combine == REGISTA_METRIC_SUM ? names.plugin_totals : names.plugin_values).push_back(each.name);
  }
  return match::metric_paths(match::metric_table(), names);
}

}  // namespace regista::study
