// SPDX-License-Identifier: MIT
#include "report/what_was_played.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "campaign/inputs.hpp"
#include "config/json.hpp"
#include "config/parse.hpp"
#include "config/scalar.hpp"
#include "config/text.hpp"
#include "config/values.hpp"
#include "process/program.hpp"
#include "report/html_table.hpp"
#include "report/page_parts.hpp"
#include "report/text_table.hpp"
#include "report/visible_text.hpp"

namespace regista::report {
namespace {

using Json = nlohmann::ordered_json;

std::string in_words(const PlayedProfile& profile) {
  return visible(profile.name) + (profile.file.empty() ? " (built in)" : fmt::format(" ({})", visible(profile.file)));
}

std::string games_of(const config::MatchSettings& settings, std::size_t scenes) {
  const std::string limit = settings.limit ? config::real_text(*settings.limit) : std::string();
  if (scenes > 0) {
    return fmt::format("from {}, {}", config::counted(scenes, "scene", "scenes"),
                       limit.empty() ? std::string("each as long as it says") : limit + " s at most");
  }
  return limit.empty() ? "whole matches from kick-off" : fmt::format("matches from kick-off, {} s at most", limit);
}

std::string limits_of(const config::MatchSettings& settings) {
  std::string out =
      fmt::format("{} s of processor time a call, {} MiB", settings.limits.processor_seconds, settings.limits.memory);
  if (settings.isolation == config::Isolation::always) out += ", each team in a process of its own";
  if (!settings.play_twice) out += ", no match played twice";
  if (settings.allow_shared_memory) out += ", robots of a team may share memory";
  return out;
}

std::string program_of(const WhatWasPlayed& played) {
  const auto found = std::ranges::find(played.inputs, campaign::program_input, &campaign::Input::name);
  std::string out = played.program.empty() ? std::string("Regista") : "Regista " + played.program;
  if (found != played.inputs.end()) out += fmt::format(", program {:.8}", found->hash);
  return out;
}

// What is said in a line each, with what it is.
std::vector<std::pair<std::string, std::string>> lines_of(const WhatWasPlayed& played) {
  std::vector<std::pair<std::string, std::string>> out{{"rules", in_words(played.rules)},
                                                       {"robot", in_words(played.robot)}};
  if (!played.set.empty()) out.emplace_back("set", visible(fmt::format("{}", fmt::join(played.set, ", "))));
  out.emplace_back("games", played.games);
  out.emplace_back("number", played.amount);
  out.emplace_back("limits", played.limits);
  out.emplace_back("program", program_of(played));
  return out;
}

std::string remarks_on(const PlayedTeam& team) {
  std::string out = "disturbance " + in_words(team.disturbance);
  if (!team.set.empty()) out += ", set " + visible(fmt::format("{}", fmt::join(team.set, ", ")));
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

std::string played_text(const WhatWasPlayed& played) {
  std::string out = "Played:\n";
  for (const PlayedTeam& each : played.teams) {
    out += fmt::format("  team {} ({}, version {}), {}\n", visible(each.name), visible(each.file), each.version,
                       remarks_on(each));
  }
  for (const auto& [what, value] : lines_of(played)) out += fmt::format("  {} {}\n", what, value);
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
          {"document", config::to_json(config::parse_text(played.document, "its document"))}};
}

Html played_section(const WhatWasPlayed& played) {
  HtmlTable teams({{"Team"_html, Column::words},
                   {"File"_html, Column::words},
                   {"Version"_html, Column::words},
                   {"Disturbance, and what is set for it alone"_html, Column::words}});
  for (const PlayedTeam& each : played.teams)
    teams.row({name(each.name), path_code(each.file), code(each.version), text(remarks_on(each))});
  HtmlTable all({{"All matches"_html, Column::words}, {""_html, Column::words}});
  for (const auto& [what, value] : lines_of(played)) all.row({text(what), text(value)});
  Html out = "<div class=\"values\">"_html;
  out << teams.html() << "</div>\n<div class=\"values\">"_html << all.html()
      << "</div>\n<details><summary>The study's document, with every value that is in force</summary>\n"_html
      << block(played.document) << "</details>\n"_html;
  return section("played", "What was played"_html, out);
}

Html again_section(const WhatWasPlayed& played, const PlayedResults& results) {
  std::vector<std::string> run{"run", "study.yaml"};
  for (const std::string& each : played.plugins) run.insert(run.end(), {"--plugins", each});
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
