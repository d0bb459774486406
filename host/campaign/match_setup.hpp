// SPDX-License-Identifier: MIT
// Reads all inputs of a match from the files that a job names, and lists these inputs except the seed as names and
// hashes of contents. The key of a fixture is made of the hashes; names are for people. Two matches with the same key
// and seed are the same match, so only one of them is played.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/match_encoding.hpp"
#include "config/node.hpp"
#include "config/overlay.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"
#include "config/team_check.hpp"
#include "match/match.hpp"
#include "mind/team_plan.hpp"
#include "plugin/catalogue.hpp"

namespace regista::campaign {

// Returns the values of `--set` for one document ("home", "rules", "home_disturbance", ...) of a command that reads
// several documents. The first part of a path names the document: home, away, rules, robot, disturbance (of both
// sides), home_disturbance, away_disturbance or opening. A path without such a part goes to both teams.
config::Overrides overrides_for(std::string_view document, const config::Overrides& all);

// Throws config::Error for a path of `--set` that begins with home or away, which only old stored matches may have, or
// with the letter of a third team.
void refuse_unknown_sides(const config::Overrides& typed);

struct TeamSetup {
  std::shared_ptr<const config::Node> document;  // the team's document, changed by the values of --set
  std::shared_ptr<const mind::TeamPlan> plan;    // must not outlive the catalogue
  std::vector<config::Warning> warnings;
};

struct MatchSetup {
  match::Setup setup;                                            // without roles: match::play sets them
  std::array<std::shared_ptr<const mind::TeamPlan>, 2> plans;    // by side; must not outlive the catalogue
  std::array<std::shared_ptr<const config::Node>, 2> documents;  // by side: TeamSetup::document
  std::vector<config::Warning> warnings;                         // about both teams, each warning once
};

// The keys of a team's document. former_too: also former keys, which stored matches have (config/renamed_keys.hpp).
enum class KeyNames { present, former_too };

// Reads a team's document. Throws config::Error.
TeamSetup team_setup(const std::string& file, const config::Overrides& overrides, const config::Rules& rules,
                     const config::Robot& robot, const plugin::Catalogue& catalogue,
                     KeyNames names = KeyNames::present);

// A function that reads the team of one side as team_setup() does, or returns a team that was read before.
using ReadTeam = std::function<TeamSetup(const std::string& file, const config::Overrides& overrides,
                                         const config::Rules& rules, const config::Robot& robot)>;
ReadTeam team_reader(const plugin::Catalogue& catalogue, KeyNames names = KeyNames::present);  // calls team_setup()

// Read all files of a match. overrides: instead of those of the job. Both throw config::BadInput and config::Error.
MatchSetup match_setup(const Job& job, const config::Overrides& overrides, const ReadTeam& read_team);
MatchSetup match_setup(const Job& job, const plugin::Catalogue& catalogue, KeyNames names = KeyNames::present);

// Returns the description of a match before its play: all members except `result` and `wall_seconds`.
PlayedMatch match_to_play(const MatchSetup& prepared);

// Returns the inputs of one team: its resolved document, its plugins, and the files that its parameters name. The order
// of the inputs depends only on contents and ids. root: the folder of copies of the files (stored_setup.hpp). All names
// and contents leave `root` out, so that copies give the same inputs as the files.
std::vector<Input> team_inputs(const mind::TeamPlan& plan, const config::Node& document,
                               const plugin::Catalogue& catalogue, const std::string& root = {});

inline constexpr const char* program_input = "program";
inline constexpr const char* mathematics_input = "mathematics library";

// Returns the inputs for both teams: rules, robot, disturbances, limit, program, mathematics library, opening.
std::vector<Input> common_inputs(const match::Setup& setup, const std::string& program, const std::string& mathematics);

Input opening_input(config::Opening opening);

// Returns the key of a fixture, 32 hexadecimal digits. home, away: team_inputs(); exchanged sides give another key.
std::string fixture_key(std::span<const Input> home, std::span<const Input> away, std::span<const Input> common);

// Returns the hash of the running program, even if its file has been replaced since. Throws std::runtime_error.
std::string program_hash();

// Returns the version of the C library and a hash of the results of its functions at a few hundred points. The last
// digits of these results depend on the version and on the processor family, for which the library chooses its code.
std::string mathematics_fingerprint();

// Returns the hash of the job's common input with this name; empty if the job has no such input.
std::string input_of(const Job& job, const std::string& name);

struct FoundInputs {
  std::vector<Input> home, away, common;
};

// Reads the current inputs of a match. program, mathematics: hashes; root: see team_inputs().
FoundInputs inputs_of(const MatchSetup& prepared, const plugin::Catalogue& catalogue, const std::string& program,
                      const std::string& mathematics, const std::string& root = {});

// Lists in words the inputs that have changed, are gone or are new: "plugin greedy (lib/greedy.so) has changed". Each
// name appears once. Inputs whose names differ only in the path in brackets are the same input.
std::vector<std::string> differences(std::span<const Input> before, std::span<const Input> now);
// Both functions return the differences between the inputs of the job and the current inputs; empty if all are equal.
std::string what_changed(const Job& job, const FoundInputs& now);
std::string what_changed(const Job& job, const MatchSetup& prepared, const plugin::Catalogue& catalogue,
                         const std::string& program, const std::string& mathematics, const std::string& root = {});

// Returns the shell command that plays exactly this match alone. program: the name of the program in the command.
std::string match_command(const Job& job, const std::string& program = "regista");

}  // namespace regista::campaign
