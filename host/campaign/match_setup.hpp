// SPDX-License-Identifier: MIT
// From what the command line says about a match to all that the match is a function of.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/load.hpp"
#include "config/node.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"
#include "config/team_warnings.hpp"
#include "match/match.hpp"
#include "mind/team_plan.hpp"
#include "plugin/catalogue.hpp"

namespace regista::campaign {

struct MatchRequest {
  std::vector<std::string> teams;         // files: home, away
  std::string rules, robot, disturbance;  // files; empty: the built-in values
  // Files, home and away: what disturbs one of them, in the place of `disturbance`; empty: that one.
  std::string home_disturbance, away_disturbance;
  std::string opening;            // file; empty: the match starts from kick-off
  config::Overrides overrides;    // of --set
  std::string seed = "1", limit;  // as typed; no limit: empty
};

// A team as a match has it.
struct TeamSetup {
  std::shared_ptr<const config::Node> document;  // with --set laid over
  std::shared_ptr<const mind::TeamPlan> plan;    // needs the catalogue
  std::vector<config::Warning> warnings;
};

struct MatchSetup {
  match::Setup setup;                                            // its roles are left to match::play
  std::array<std::shared_ptr<const mind::TeamPlan>, 2> plans;    // by side; they need the catalogue
  std::array<std::shared_ptr<const config::Node>, 2> documents;  // of the teams, by side, with --set laid over
  std::vector<config::Warning> warnings;                         // of the teams, each once
};

// Reads a team's page. Throws config::Error.
TeamSetup team_setup(const std::string& file, const config::Overrides& overrides, const config::Rules& rules,
                     const config::Robot& robot, const plugin::Catalogue& catalogue);

// Who reads the team of a side: as team_setup() does, or who has read it before.
using ReadTeam = std::function<TeamSetup(const std::string& file, const config::Overrides& overrides,
                                         const config::Rules& rules, const config::Robot& robot)>;

// Throws config::BadInput and config::Error.
MatchSetup match_setup(const MatchRequest& request, const ReadTeam& read_team);
MatchSetup match_setup(const MatchRequest& request, const plugin::Catalogue& catalogue);

// A whole number from 0 to 2^64 - 1 in decimal digits. `option`: who asks, for the message. Throws config::BadInput.
std::uint64_t parse_seed(const std::string& text, const std::string& option);

}  // namespace regista::campaign
