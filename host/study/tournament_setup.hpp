// SPDX-License-Identifier: MIT
// From what the command line says about a tournament to its plan: everything is read and checked before the first
// match.
#pragma once

#include <string>
#include <vector>

#include "campaign/options.hpp"
#include "plugin/catalogue.hpp"
#include "study/tournament_plan.hpp"

namespace regista::study {

struct TournamentRequest : campaign::Options {
  TournamentRequest() { results = "tournament.db"; }
  std::vector<std::string> teams, overrides, openings;
  std::string rules, robot, disturbance, limit;
  std::string format = "round-robin", pairs, seed = "1";
  std::string sprt, metric, model, alpha, beta;  // empty: not given
  std::string failures_in_a_row = "10";
};

struct PlannedTournament {
  TournamentPlan plan;
  std::vector<std::string> documents;  // of the teams, resolved, as their hashes in the plan were made from them
};

// Throws config::BadInput and config::Error.
PlannedTournament planned_tournament(const TournamentRequest& options, const plugin::Catalogue& catalogue);

}  // namespace regista::study
