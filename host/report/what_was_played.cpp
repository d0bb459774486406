// SPDX-License-Identifier: MIT
#include "report/what_was_played.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "campaign/inputs.hpp"
#include "config/parse.hpp"
#include "config/scalar.hpp"
#include "config/values.hpp"
#include "process/program.hpp"
#include "report/outline.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

using Json = nlohmann::ordered_json;

Sentence in_words(const PlayedProfile& profile) {
  if (profile.name.empty() && profile.file.empty()) return "not known";
  Sentence out = named(profile.name);
  return profile.file.empty() ? out << " (built in)" : out << " (" << path(profile.file) << ")";
}

std::string games_of(const config::MatchSettings& settings, std::size_t scenes) {
  const std::string limit = settings.limit ? config::real_text(*settings.limit) : std::string();
  if (scenes > 0) {
    return fmt::format("from {}, {}", texts::counted(scenes, "scene", "scenes"),
                       limit.empty() ? std::string("each as long as it says") : limit + " s at most");
  }
  return limit.empty() ? "whole matches from kick-off" : fmt::format("matches from kick-off, {} s at most", limit);
}

std::string limits_of(const config::MatchSettings& settings) {
  std::string out =
      fmt::format("{} s of processor time a call, {} MiB", settings.limits.processor_seconds, settings.limits.memory);
  if (settings.allow_shared_memory) out += ", robots of a team may share memory";
  return out;
}

std::string program_of(const WhatWasPlayed& played) {
  const auto found = std::ranges::find(played.inputs, campaign::program_input, &campaign::Input::name);
  std::string out = played.program.empty() ? std::string("Regista") : "Regista " + played.program;
  if (found != played.inputs.end()) out += fmt::format(", program {:.8}", found->hash);
  return out;
}

// What is said of all matches, a line each.
std::vector<Sentence> lines_of(const WhatWasPlayed& played) {
  std::vector<Sentence> out{Sentence("rules ") << in_words(played.rules) << ", robot " << in_words(played.robot)};
  if (!played.set.empty()) out.push_back(fmt::format("set {}", fmt::join(played.set, ", ")));
  out.push_back(fmt::format("{}; {}", played.games, played.amount));
  if (!played.plugins.empty()) out.push_back(fmt::format("plugins of {} first", fmt::join(played.plugins, ", ")));
  out.push_back(program_of(played) + (played.limits.empty() ? "" : "; " + played.limits));
  return out;
}

Sentence remarks_on(const PlayedTeam& team) {
  Sentence out = in_words(team.disturbance);
  return team.set.empty() ? out : out << ", set " << code(fmt::format("{}", fmt::join(team.set, ", ")));
}

Json json_of(const PlayedProfile& profile) {
  return {{"name", profile.name}, {"file", profile.file.empty() ? Json(nullptr) : Json(profile.file)}};
}

}  // namespace

PlayedProfile profile_of(std::span<const campaign::Input> inputs, std::string_view kind, const std::string& file) {
  const std::string begins = std::string(kind) + ' ';
  for (const campaign::Input& each : inputs) {
    if (each.name.starts_with(begins)) return {each.name.substr(begins.size()), file};
  }
  return {"", file};
}

WhatWasPlayed what_was_played(const config::MatchSettings& settings, std::span<const campaign::Input> common,
                              std::span<const campaign::Input> openings) {
  WhatWasPlayed out;
  out.rules = profile_of(common, "rules", settings.rules);
  out.robot = profile_of(common, "robot", settings.robot);
  out.games = games_of(settings, openings.size());
  out.limits = limits_of(settings);
  out.inputs.assign(common.begin(), common.end());
  out.inputs.insert(out.inputs.end(), openings.begin(), openings.end());
  return out;
}

PlayedTeam played_team(std::string name, std::string file, std::vector<campaign::Input> inputs,
                       PlayedProfile disturbance) {
  PlayedTeam out{std::move(name), std::move(file), {}, std::move(disturbance), {}, std::move(inputs)};
  out.version = campaign::fixture_key(out.inputs, {}, {}).substr(0, 8);
  return out;
}

std::vector<std::string> played_with(const WhatWasPlayed& played) {
  std::vector<std::string> out;
  const auto add = [&out](const campaign::Input& input) {
    // A team is its file, which comes along; where a shared object or a file was found says nothing of what it is.
    if (input.name.starts_with("team ")) return;
    std::string name = input.name.substr(0, input.name.find(" ("));
    if (name.starts_with("file ")) {
      const std::size_t of = name.find(" of plugin ");
      name = "file " + std::filesystem::path(name.substr(5, of - 5)).filename().string() +
             name.substr(std::min(of, name.size()));
    }
    const std::string line = fmt::format("{} {}", texts::visible(name), input.hash.substr(input.hash.rfind(' ') + 1));
    if (std::ranges::find(out, line) == out.end()) out.push_back(line);
  };
  std::ranges::for_each(played.inputs, add);
  for (const PlayedTeam& each : played.teams) std::ranges::for_each(each.inputs, add);
  return out;
}

std::vector<std::string> not_as_before(const config::MatchSettings& settings, const WhatWasPlayed& played) {
  std::vector<std::string> out;
  const std::vector<std::string> now = played_with(played);
  for (const config::Node& each : settings.played_with) {
    const std::string& line = each.text();
    if (std::ranges::find(now, line) != now.end()) continue;
    out.push_back(fmt::format("{} is not what this study was played with before",
                              texts::visible(line.substr(0, line.rfind(' ')))));
  }
  return out;
}

Section played_section(const WhatWasPlayed& played) {
  constexpr std::size_t most = 20;  // teams, in a terminal
  Section out("played", "What was played");
  Table teams{{{"Team", Column::words},
               {"File", Column::words},
               {"Version", Column::words},
               {"Disturbance, and what is set for it alone", Column::words}}};
  teams.look = Table::Look::values;
  for (std::size_t i = 0; i < played.teams.size(); ++i) {
    const PlayedTeam& each = played.teams[i];
    teams.row({named(each.name), path(each.file), code(each.version), remarks_on(each)},
              i < most ? Readers::all : Readers::page);
  }
  out.table(std::move(teams));
  if (played.teams.size() > most)
    out.line(
        fmt::format("and {} more: --json, or the page", texts::counted(played.teams.size() - most, "team", "teams")),
        Readers::terminal);
  out.list(lines_of(played));
  out.listing("The study's document, with every value that is in force", played.document);
  return out;
}

Json played_json(const WhatWasPlayed& played) {
  Json teams = Json::array(), inputs = Json::array();
  for (const PlayedTeam& each : played.teams) {
    teams.push_back({{"name", each.name},
                     {"file", each.file},
                     {"version", each.version},
                     {"disturbance", json_of(each.disturbance)},
                     {"set", each.set}});
  }
  for (const campaign::Input& each : played.inputs) inputs.push_back({{"name", each.name}, {"hash", each.hash}});
  return {{"teams", teams},
          {"rules", json_of(played.rules)},
          {"robot", json_of(played.robot)},
          {"set", played.set},
          {"games", played.games},
          {"amount", played.amount},
          {"limits", played.limits},
          {"program", played.program},
          {"folder", played.folder},
          {"plugins", played.plugins},
          {"inputs", inputs},
          {"changed", played.changed},
          {"document", played.document.empty() ? Json(nullptr)
                                               : config::to_json(config::parse_text(played.document, "its document"))}};
}

Section again_section(const WhatWasPlayed& played, const std::string& results, const std::string& fingerprint) {
  std::vector<std::string> run{"run", "study.yaml"};
  for (const std::string& each : played.plugins)
    run.insert(run.end(), {"--plugins", (std::filesystem::path(played.folder) / each).lexically_normal().string()});
  Section out("reproduction", "Playing it again");
  out.line("In the folder of the results:");
  out.items.push_back({Listing{{},
                               process::command_line(std::vector<std::string>{"report", results, "--study", "again"}) +
                                   "\ncd again\n" + process::command_line(run),
                               true}});
  out.note(
      Sentence("The first command writes the study with its teams, profiles and scenes; the last one says before the "
               "first match what is not as it was. It was begun in the folder ")
      << code(played.folder) << (played.program.empty() ? "" : " with Regista " + played.program)
      << ". Fingerprint of all matches (the same matches have the same one): "
      << code(fingerprint.empty() ? "–" : fingerprint));
  if (played.may_end_by_the_clock)
    out.note(
        "The search had a limit of wall time. If that limit ended it, another machine may end it at another "
        "evaluation.");
  std::vector<campaign::Input> inputs = played.inputs;
  for (const PlayedTeam& each : played.teams) inputs.insert(inputs.end(), each.inputs.begin(), each.inputs.end());
  Table hashes{{{"Input", Column::words}, {"Hash of its content", Column::words}}};
  for (auto input = inputs.begin(); input != inputs.end(); ++input) {
    if (std::find(inputs.begin(), input, *input) == input) hashes.row({input->name, code(input->hash)});
  }
  hashes.summary = "Hashes of all inputs";
  out.table(std::move(hashes));
  return out;
}

}  // namespace regista::report
