// SPDX-License-Identifier: MIT
// From what the command line says about a tournament to its plan: everything is read and checked before the first
// match.
#pragma once

#include <string>
#include <vector>

#include "campaign/worker.hpp"
#include "plugin/catalogue.hpp"
#include "study/tournament_plan.hpp"

namespace regista::cli {

struct TournamentOptions {
  std::vector<std::string> teams, plugins, overrides, openings;
  std::string rules, robot, disturbance, limit;
  std::string format = "round-robin", pairs, seed = "1";
  std::string sprt, metric, model, alpha, beta;        // empty: not given
  std::string failures_in_a_row = "10", record_every;  // empty: only matches that fail are recorded
  std::string workers, results = "tournament.db", processor_seconds = "10", memory = "2048";
  bool resume = false, json = false, quiet = false, no_page = false;
};

struct PlannedTournament {
  study::TournamentPlan plan;
  std::vector<std::string> documents;  // of the teams, resolved, as their hashes in the plan were made from them
};

// Throws BadInput and config::Error.
PlannedTournament planned_tournament(const TournamentOptions& options, const plugin::Catalogue& catalogue);

int number_of_workers(const TournamentOptions& options);
// 0: none but those that fail.
std::uint64_t record_every(const TournamentOptions& options);
campaign::Limits limits(const TournamentOptions& options);

}  // namespace regista::cli
