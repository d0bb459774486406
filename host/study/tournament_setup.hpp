// SPDX-License-Identifier: MIT
// From what the command line or a document says about a tournament to its plan: everything is read and checked before
// the first match.
#pragma once

#include <string>
#include <vector>

#include "campaign/options.hpp"
#include "config/mistakes.hpp"
#include "plugin/catalogue.hpp"
#include "study/tournament_plan.hpp"

namespace regista::study {

struct TournamentRequest : campaign::Options {
  std::string file;                    // the tournament's document; empty: the options below say all
  std::vector<std::string> overrides;  // of the document; without one, of the documents of matches
  std::vector<std::string> teams, openings;
  std::vector<std::string> disturbances;  // not typed: of each team alone; empty, or a text: that of all
  std::string rules, robot, disturbance, limit;
  // Empty: not given.
  std::string format, pairs, seed, sprt, metric, model, alpha, beta, failures_in_a_row;
};

struct PlannedTournament {
  TournamentPlan plan;
  std::vector<std::string> documents;  // of the teams, resolved, as their hashes in the plan were made from them
};

// Throws config::BadInput and config::Error, of a document at the place that asks for what is not there.
PlannedTournament planned_tournament(const TournamentRequest& options, const plugin::Catalogue& catalogue);

// Whether it can be planned: lists every mistake in teams and scenes.
void check_tournament(const TournamentRequest& options, const plugin::Catalogue& catalogue, config::Mistakes& mistakes);

}  // namespace regista::study
