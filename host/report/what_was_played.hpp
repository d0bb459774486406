// SPDX-License-Identifier: MIT
// What was played: with it the report of every study begins, whether as text, as JSON or as a page. Who played, under
// which rules, with which robots and disturbances, what from and how long, how often, and by which program; and the
// study's whole document, from which it can be played again.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/input.hpp"
#include "config/match_settings.hpp"
#include "config/values.hpp"

namespace regista::report {

struct Section;

// A document that was played by. file: empty where it is built in.
struct PlayedProfile {
  std::string name, file;
};

struct PlayedTeam {
  std::string name, file;
  std::string version;  // of everything that it brings along: eight digits
  PlayedProfile disturbance;
  std::vector<std::string> set;         // "path=value", for it alone
  std::vector<campaign::Input> inputs;  // campaign::team_inputs
};

struct WhatWasPlayed {
  std::vector<PlayedTeam> teams;  // in the order of the study
  PlayedProfile rules, robot;
  std::vector<std::string> set;         // "path=value", of all matches
  std::string games;                    // "whole matches from kick-off"
  std::string amount;                   // "100 pairs of each pairing, seeds from 1"
  std::string limits;                   // of processes
  std::string program;                  // version that began it; empty: not known
  std::string folder;                   // in which it was begun
  std::vector<std::string> plugins;     // folders of --plugins
  std::vector<campaign::Input> inputs;  // everything, each once
  std::string document;                 // of the study, every value that is in force; of a match none
  std::vector<std::string> changed;     // what is another than its document says it was played with before, a line each
  bool may_end_by_the_clock = false;    // so another machine may play other matches
};

// All that does not depend on which study it is. common: inputs that all matches have; openings: of each scene.
WhatWasPlayed what_was_played(const config::MatchSettings& settings, std::span<const campaign::Input> common,
                              std::span<const campaign::Input> openings);

// The profile of these inputs whose name begins so, "home disturbance": its own name, and its file.
PlayedProfile profile_of(std::span<const campaign::Input> inputs, std::string_view kind, const std::string& file);

// A team with its inputs, and the eight digits that they make.
PlayedTeam played_team(std::string name, std::string file, std::vector<campaign::Input> inputs,
                       PlayedProfile disturbance);

// What a study that is played again has to have as well: "plugin greedy 9f2c...", a line each.
std::vector<std::string> played_with(const WhatWasPlayed& played);
// What is another than a study's document says it was played with, lines without their ends.
std::vector<std::string> not_as_before(const config::MatchSettings& settings, const WhatWasPlayed& played);

// All that a plan says of how the study was begun, once what was played with is known.
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
// How it is played once more. results: file, as seen from the page; fingerprint: of all matches.
Section again_section(const WhatWasPlayed& played, const std::string& results, const std::string& fingerprint);

}  // namespace regista::report
