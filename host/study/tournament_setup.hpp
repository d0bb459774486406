// SPDX-License-Identifier: MIT
// From a tournament's document to its plan: everything is read and checked before the first match.
#pragma once

#include <string>
#include <vector>

#include "config/mistakes.hpp"
#include "config/node.hpp"
#include "plugin/catalogue.hpp"
#include "study/tournament_plan.hpp"

namespace regista::study {

struct PlannedTournament {
  TournamentPlan plan;
  std::vector<std::string> documents;  // of the teams, resolved, as their hashes in the plan were made from them
};

// plugins: folders of the catalogue. Throws config::BadInput and config::Error, at the place that asks for what cannot
// be.
PlannedTournament planned_tournament(const config::Node& document, const std::vector<std::string>& plugins,
                                     const plugin::Catalogue& catalogue);

// Whether it can be planned: lists every mistake in teams and scenes.
void check_tournament(const config::Node& document, const std::vector<std::string>& plugins,
                      const plugin::Catalogue& catalogue, config::Mistakes& mistakes);

}  // namespace regista::study
