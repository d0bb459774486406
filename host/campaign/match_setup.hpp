// SPDX-License-Identifier: MIT
// Reads all inputs of a match from the files that a command line or a job names. Checks whether these files still hold
// the inputs of a job.
#pragma once

#include <array>
#include <functional>
#include <memory>
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

// Throws config::Error for a path of `--set` that begins with home or away, as in version 0.2. Stored matches may have
// such paths.
void refuse_former_sides(const config::Overrides& typed);

struct MatchRequest {
  std::vector<std::string> teams;         // files: home, away
  std::string rules, robot, disturbance;  // files; empty: the built-in values
  // Files: the disturbance of one side, used instead of `disturbance`; empty: the side has `disturbance`.
  std::string home_disturbance, away_disturbance;
  std::string opening;            // file; empty: the match starts from kick-off
  config::Overrides overrides;    // values of --set
  std::string seed = "1", limit;  // as typed; `limit` empty: no limit
};

// A team that has been read for a match.
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

// The keys that a team's document may have. present: only keys of this version. former_too: also former keys, which
// stored matches may use (config/renamed_keys.hpp).
enum class KeyNames { present, former_too };

// Reads a team's document. Throws config::Error.
TeamSetup team_setup(const std::string& file, const config::Overrides& overrides, const config::Rules& rules,
                     const config::Robot& robot, const plugin::Catalogue& catalogue,
                     KeyNames names = KeyNames::present);

// A function that reads the team of one side as team_setup() does, or returns a team that was read before.
using ReadTeam = std::function<TeamSetup(const std::string& file, const config::Overrides& overrides,
                                         const config::Rules& rules, const config::Robot& robot)>;

// Reads all files of a match. Both functions throw config::BadInput and config::Error.
MatchSetup match_setup(const MatchRequest& request, const ReadTeam& read_team);
MatchSetup match_setup(const MatchRequest& request, const plugin::Catalogue& catalogue,
                       KeyNames names = KeyNames::present);

// Returns the description of a match before its play: all members except `result` and `wall_seconds`.
PlayedMatch match_to_play(const MatchSetup& prepared);

MatchRequest request_of(const Job& job);
// Returns the job of a request. The caller must still set the inputs and the plugin files of the job.
Job job_of(const MatchRequest& request, const std::vector<std::string>& plugins);

// Returns the hash of the job's common input with this name; empty if the job has no such input.
std::string input_of(const Job& job, const std::string& name);

// All inputs of a match, from the current content of the files.
struct FoundInputs {
  std::vector<Input> home, away, common;
};

// Reads the current inputs of a match. program, mathematics: hashes; root: see team_inputs().
FoundInputs inputs_of(const MatchSetup& prepared, const plugin::Catalogue& catalogue, const std::string& program,
                      const std::string& mathematics, const std::string& root = {});

// Lists in words how the current inputs differ from the inputs of the job; empty if all inputs are equal.
std::string what_changed(const Job& job, const FoundInputs& now);
std::string what_changed(const Job& job, const MatchSetup& prepared, const plugin::Catalogue& catalogue,
                         const std::string& program, const std::string& mathematics, const std::string& root = {});

// Returns the shell command that plays exactly this match alone. program: the name of the program in the command.
std::string match_command(const Job& job, const std::string& program = "regista");

}  // namespace regista::campaign
