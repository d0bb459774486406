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
#include "report/html_table.hpp"
#include "report/page_parts.hpp"
#include "report/text_table.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

using Json = nlohmann::ordered_json;

std::string in_words(const PlayedProfile& profile) {
  if (profile.name.empty() && profile.file.empty()) return "not known";
  return texts::visible(profile.name) +
         (profile.file.empty() ? " (built in)" : fmt::format(" ({})", texts::visible(profile.file)));
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
std::vector<std::string> lines_of(const WhatWasPlayed& played) {
  std::vector<std::string> out{fmt::format("rules {}, robot {}", in_words(played.rules), in_words(played.robot))};
  if (!played.set.empty()) out.push_back("set " + texts::visible(fmt::format("{}", fmt::join(played.set, ", "))));
  out.push_back(fmt::format("{}; {}", played.games, played.amount));
  if (!played.plugins.empty())
    out.push_back(texts::visible(fmt::format("plugins of {} first", fmt::join(played.plugins, ", "))));
  out.push_back(program_of(played) + (played.limits.empty() ? "" : "; " + played.limits));
  return out;
}

std::string remarks_on(const PlayedTeam& team) {
  std::string out = "disturbance " + in_words(team.disturbance);
  if (!team.set.empty()) out += ", set " + texts::visible(fmt::format("{}", fmt::join(team.set, ", ")));
  return out;
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

std::string played_text(const WhatWasPlayed& played) {
  constexpr std::size_t most = 20;  // teams, in a terminal
  std::string out = "Played:\n";
  for (std::size_t i = 0; i < std::min(played.teams.size(), most); ++i) {
    const PlayedTeam& each = played.teams[i];
    out += fmt::format("  {} ({}, version {}), {}\n", texts::visible(each.name), texts::visible(each.file),
                       each.version, remarks_on(each));
  }
  if (played.teams.size() > most)
    out += fmt::format("  and {} more: --json, or the page\n",
                       texts::counted(played.teams.size() - most, "team", "teams"));
  for (const std::string& each : lines_of(played)) out += fmt::format("  {}\n", each);
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

Html played_section(const WhatWasPlayed& played) {
  HtmlTable teams({{"Team"_html, Column::words},
                   {"File"_html, Column::words},
                   {"Version"_html, Column::words},
                   {"Disturbance, and what is set for it alone"_html, Column::words}});
  for (const PlayedTeam& each : played.teams)
    teams.row({name(each.name), path_code(each.file), code(each.version), text(remarks_on(each))});
  Html out = "<div class=\"values\">"_html;
  out << teams.html() << "</div>\n<ul>\n"_html;
  for (const std::string& each : lines_of(played)) out << "<li>"_html << text(each) << "</li>\n"_html;
  out << "</ul>\n<details><summary>The study's document, with every value that is in force</summary>\n"_html
      << block(played.document) << "</details>\n"_html;
  return section("played", "What was played"_html, out);
}

Html again_section(const WhatWasPlayed& played, const PlayedResults& results) {
  std::vector<std::string> run{"run", "study.yaml"};
  for (const std::string& each : played.plugins)
    run.insert(run.end(), {"--plugins", (std::filesystem::path(played.folder) / each).lexically_normal().string()});
  const std::string commands =
      process::command_line(std::vector<std::string>{"report", results.file, "--study", "again"}) + "\ncd again\n" +
      process::command_line(run);
  Html out = "<p>In the folder of the results:</p>\n"_html;
  out << block(commands)
      << "<p class=\"note\">The first command writes the study with its teams, profiles and scenes; the last one says before the first match what is not as it was. It was begun in the folder "_html
      << code(played.folder) << " with Regista "_html << text(results.program)
      << ". Fingerprint of all matches (the same matches have the same one): "_html
      << code(results.fingerprint.empty() ? "–" : results.fingerprint) << "</p>\n"_html;
  if (!results.note.empty()) out << "<p class=\"note\">"_html << text(results.note) << "</p>\n"_html;
  std::vector<campaign::Input> inputs = played.inputs;
  for (const PlayedTeam& each : played.teams) inputs.insert(inputs.end(), each.inputs.begin(), each.inputs.end());
  out << "<details><summary>Hashes of all inputs</summary>\n"_html << hashes_table(inputs) << "</details>\n"_html;
  return section("reproduction", "Playing it again"_html, out);
}

}  // namespace regista::report
