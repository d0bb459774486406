// SPDX-License-Identifier: MIT
// The part "What was played" of every report: teams, rules, robots, disturbances, scenes, number of matches, program,
// and the complete document with which a user can repeat the study. This header also declares functions that compare
// the documents of teams.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/job.hpp"
#include "config/match_settings.hpp"
#include "config/values.hpp"

namespace regista::report {

struct Section;

// The name and file of rules, of a robot or of a disturbance. file: empty for built-in values.
struct PlayedProfile {
  std::string name, file;
};

struct PlayedTeam {
  std::string name, file;
  std::string version;  // first eight digits of a hash of the team's inputs
  PlayedProfile disturbance;
  std::vector<std::string> set;         // "path=value", only for this team
  std::vector<campaign::Input> inputs;  // from campaign::team_inputs()
};

struct WhatWasPlayed {
  std::vector<PlayedTeam> teams;  // same order as in the study
  PlayedProfile rules, robot;
  std::vector<std::string> set;         // "path=value", for all matches
  std::string games;                    // for example "whole matches from kick-off"
  std::string amount;                   // for example "100 pairs of each pairing, seeds from 1"
  std::string limits;                   // resource limits of processes
  std::string program;                  // version of the program that began the study; empty: unknown
  std::string folder;                   // folder in which the study was begun
  std::vector<std::string> plugins;     // folders of --plugins
  std::vector<campaign::Input> inputs;  // all inputs, each once
  std::string document;                 // document of the study with all values, including defaults; empty for a match
  std::vector<std::string> changed;     // result of not_as_before()
  bool may_end_by_the_clock = false;    // true: a time limit may end it, so another machine may play other matches
};

// Returns the part that all studies have in common. common: inputs of all matches. openings: one input for each scene.
WhatWasPlayed what_was_played(const config::MatchSettings& settings, std::span<const campaign::Input> common,
                              std::span<const campaign::Input> openings);

// Returns a profile with `file` and the name of the first input of this kind, such as "home disturbance".
PlayedProfile profile_of(std::span<const campaign::Input> inputs, std::string_view kind, const std::string& file);

PlayedTeam played_team(std::string name, std::string file, std::vector<campaign::Input> inputs,
                       PlayedProfile disturbance);

// Returns one line for each input ("plugin greedy 9f2c..."), without the teams' documents, which the study contains.
std::vector<std::string> played_with(const WhatWasPlayed& played);
// Returns one sentence for each input in MatchSettings::played_with that has another hash now.
std::vector<std::string> not_as_before(const config::MatchSettings& settings, const WhatWasPlayed& played);

// Copies the facts about the study's beginning from the plan. Precondition: teams and inputs are set.
template <class Plan>
void complete(WhatWasPlayed& played, const Plan& plan) {
  played.program = plan.program;
  played.folder = plan.folder;
  played.plugins = plan.plugins;
  played.document = config::document_text(plan.asked);
  played.changed = not_as_before(plan.asked.settings, played);
}

nlohmann::ordered_json played_json(const WhatWasPlayed& played);
Section played_section(const WhatWasPlayed& played);
// Explains how to repeat the study. results: path relative to the page. fingerprint: hash of all matches.
Section again_section(const WhatWasPlayed& played, const std::string& results, const std::string& fingerprint);

// --- The differences of the resolved documents of teams

// A value that differs between documents. Elements of lists with names are compared with the elements of the same name.
// So another order of a list is one difference, at the path of the list, and an additional element does not make the
// elements after it different.
struct DifferingValue {
  std::string path;                                // "sender.params.reserve", "roles.playing[striker].target.at"
  std::vector<std::optional<std::string>> values;  // one value per document; missing if the document lacks this value
};

// Compares documents in the form of config::show() without remarks. Returns the values in the order of the first
// document, then the values that only later documents have. Throws config::Error for a text that is not YAML.
std::vector<DifferingValue> differing_values(std::span<const std::string> documents);

// Returns the section of the page that shows where the teams differ: in their documents, disturbances, plugins and
// files. The documents follow. documents[i]: the resolved document of teams[i]. There may be fewer documents than
// teams; then only the first teams are compared, and never more than 8. An empty list: an older program, which did not
// store documents, made the results.
Section configuration_section(std::span<const std::string> documents, std::span<const PlayedTeam> teams);

}  // namespace regista::report
