// SPDX-License-Identifier: MIT
#include "report/what_was_played.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "config/node.hpp"
#include "config/parse.hpp"
#include "config/scalar.hpp"
#include "process/child.hpp"
#include "report/number.hpp"
#include "report/outline.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

Sentence in_words(const PlayedProfile& profile) {
  if (profile.name.empty() && profile.file.empty()) return "not known";
  return profile.file.empty() ? named(profile.name) << " (built in)"
                              : named(profile.name) << " (" << path(profile.file) << ")";
}

std::string games_of(const config::MatchSettings& settings, std::size_t scenes) {
  const std::string limit = settings.limit ? config::real_text(*settings.limit) : "";
  if (scenes > 0) {
    return fmt::format("from {}, {}", texts::plural(scenes, "scene", "scenes"),
                       limit.empty() ? std::string("each as long as it says") : limit + " s at most");
  }
  return limit.empty() ? "whole matches from kick-off" : fmt::format("matches from kick-off, {} s at most", limit);
}

std::string program_of(const WhatWasPlayed& played) {
  const auto found = std::ranges::find(played.inputs, campaign::program_input, &campaign::Input::name);
  std::string out = played.program.empty() ? std::string("Regista") : "Regista " + played.program;
  if (found != played.inputs.end()) out += fmt::format(", program {:.8}", found->hash);
  return out;
}

// Returns facts about all matches, one line each.
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

using config::Node;

constexpr std::size_t most_compared = 8;    // largest number of documents that the page compares
constexpr std::size_t most_documents = 40;  // largest number of documents that the page shows completely
constexpr std::size_t most_rows = 1000;
constexpr std::size_t most_open = 25;  // largest number of rows of a table that the page shows without a click

struct Value {
  std::string path, text;
};

// Returns a value in one line, without quotes.
std::string in_one_line(const Node& node) {
  if (node.kind() == Node::Kind::scalar) return node.text();
  std::vector<std::string> parts;
  for (const Node::Entry& each : node.entries()) parts.push_back(each.key + ": " + in_one_line(each.value));
  for (const Node& each : node.elements()) parts.push_back(in_one_line(each));
  if (node.kind() == Node::Kind::map) return fmt::format("{{{}}}", fmt::join(parts, ", "));
  return node.kind() == Node::Kind::sequence ? fmt::format("[{}]", fmt::join(parts, ", ")) : "null";
}

// Returns whether every element is a map with a unique name.
bool is_named(const Node& sequence) {
  std::set<std::string> names;
  return std::ranges::all_of(sequence.elements(), [&](const Node& element) {
    const Node name = element["name"];
    return name.kind() == Node::Kind::scalar && names.insert(name.text()).second;
  });
}

void collect(const Node& node, const std::string& path, std::vector<Value>& out) {
  if (node.kind() == Node::Kind::map && !node.entries().empty()) {
    for (const Node::Entry& entry : node.entries()) {
      collect(entry.value, path.empty() ? entry.key : path + '.' + entry.key, out);
    }
  } else if (node.kind() == Node::Kind::sequence && !node.elements().empty() && is_named(node)) {
    std::string order;
    for (const Node& element : node.elements()) {
      const std::string& name = element["name"].text();
      order += (order.empty() ? "" : ", ") + name;
      for (const Node::Entry& entry : element.entries()) {
        if (entry.key != "name") collect(entry.value, path + '[' + name + "]." + entry.key, out);
      }
    }
    out.push_back({path, order});
  } else {
    out.push_back({path, in_one_line(node)});
  }
}

// Adds inputs with equal names and different contents: disturbances, shared objects, and files of parameters.
void add_what_they_bring(std::span<const PlayedTeam> teams, std::vector<DifferingValue>& rows) {
  std::map<std::string, std::vector<std::optional<std::string>>> found;
  const auto value_of = [&](const std::string& what, std::size_t team) -> std::optional<std::string>& {
    return found.try_emplace(what, teams.size()).first->second[team];
  };
  for (std::size_t team = 0; team < teams.size(); ++team) {
    const PlayedProfile& disturbance = teams[team].disturbance;
    value_of("disturbance", team) =
        disturbance.name + (disturbance.file.empty() ? "" : fmt::format(" ({})", disturbance.file));
    for (const campaign::Input& each : teams[team].inputs) {
      // differing_values() compares the teams' own documents, so this loop skips them.
      if (!each.name.starts_with("team ")) value_of(each.name.substr(0, each.name.find(" (")), team) = each.hash;
    }
  }
  for (auto& [what, values] : found) {
    std::set<std::string> different;
    for (const auto& each : values) {
      if (each) different.insert(*each);
    }
    if (different.size() > 1) rows.push_back({what, std::move(values)});
  }
}

void add_differences(std::span<const PlayedTeam> teams, const std::vector<DifferingValue>& rows, Section& out) {
  if (rows.empty())
    return out.line("The resolved documents are the same, and so are disturbances, plugins and files.", Readers::page);
  Table table{{{"Value", Column::words}}};
  for (std::size_t i = 0; i < rows.front().values.size(); ++i)
    table.headings.push_back({named(teams[i].name), Column::words});
  for (std::size_t i = 0; i < std::min(rows.size(), most_rows); ++i) {
    std::vector<Cell> cells{path(rows[i].path)};
    for (const auto& value : rows[i].values) cells.push_back(value ? code(*value) : Sentence("–"));
    table.row(std::move(cells));
  }
  table.style = Table::Style::values;
  table.summary = texts::plural(rows.size(), "value differs", "values differ");
  table.open = rows.size() <= most_open;
  out.table(std::move(table), Readers::page);
  if (rows.size() > most_rows)
    out.line(fmt::format("{} more values are not listed.", rows.size() - most_rows), Readers::page);
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
  out.limits =
      fmt::format("{} s of processor time a call, {} MiB{}", settings.limits.processor_seconds, settings.limits.memory,
                  settings.allow_shared_memory ? ", robots of a team may share memory" : "");
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
    // Leaves out the team's document, which is a part of the study. The lines name other files without their folders.
    if (input.name.starts_with("team ")) return;
    std::string name = input.name.substr(0, input.name.find(" ("));
    if (name.starts_with("file ")) {
      const std::size_t of = name.find(" of plugin ");
      name = "file " + std::filesystem::path(name.substr(5, of - 5)).filename().string() +
             name.substr(std::min(of, name.size()));
    }
    texts::add_once(out, fmt::format("{} {}", texts::visible(name), input.hash.substr(input.hash.rfind(' ') + 1)));
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
  constexpr std::size_t most = 20;  // largest number of teams that a terminal lists
  Section out("played", "What was played");
  Table teams{{{"Team", Column::words},
               {"File", Column::words},
               {"Version", Column::words},
               {"Disturbance, and what is set for it alone", Column::words}}};
  teams.style = Table::Style::values;
  for (std::size_t i = 0; i < played.teams.size(); ++i) {
    const PlayedTeam& each = played.teams[i];
    teams.row({named(each.name), path(each.file), code(each.version), remarks_on(each)},
              i < most ? Readers::all : Readers::page);
  }
  out.table(std::move(teams));
  if (played.teams.size() > most)
    out.line(
        fmt::format("and {} more: --json, or the page", texts::plural(played.teams.size() - most, "team", "teams")),
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
  out.items.push_back({Listing{
      {},
      process::command_line({"report", results, "--study", "again"}) + "\ncd again\n" + process::command_line(run),
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

std::vector<DifferingValue> differing_values(std::span<const std::string> documents) {
  std::vector<DifferingValue> rows;
  std::map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    std::vector<Value> values;
    collect(config::parse_text(documents[i], "resolved document"), "", values);
    for (Value& each : values) {
      const auto [at, fresh] = known.try_emplace(each.path, rows.size());
      if (fresh) rows.push_back({each.path, std::vector<std::optional<std::string>>(documents.size())});
      rows[at->second].values[i] = std::move(each.text);
    }
  }
  std::erase_if(rows, [](const DifferingValue& row) {
    return std::ranges::all_of(row.values, [&](const auto& value) { return value == row.values.front(); });
  });
  return rows;
}

Section configuration_section(std::span<const std::string> documents, std::span<const PlayedTeam> teams) {
  Section out("configuration", "Where the teams differ");
  if (documents.empty()) {
    out.line("These results do not hold the teams' documents: they were begun by an older Regista.", Readers::page);
    return out;
  }
  const std::size_t compared = std::min(documents.size(), most_compared);
  try {
    std::vector<DifferingValue> rows = differing_values(documents.first(compared));
    add_what_they_bring(teams.first(std::min(compared, teams.size())), rows);
    add_differences(teams, rows, out);
  } catch (const config::Error& error) {
    out.line(fmt::format("The documents cannot be compared: {}", error.what()), Readers::page);
  }
  if (compared < documents.size()) out.note(fmt::format("Of the first {} teams.", compared), Readers::page);
  for (std::size_t i = 0; i < std::min(documents.size(), most_documents); ++i)
    out.listing(Sentence("All of ") << named(teams[i].name), documents[i]);
  return out;
}

}  // namespace regista::report
