// SPDX-License-Identifier: MIT
// Results of games between teams from elsewhere, as a table of comma-separated values (table.hpp). The first line names
// the columns, in any order: first and second, the two teams, and one of
//
//   LL, LD, DD, WD, WW    counts of pairs, DD for one win each, too
//   wins, draws, losses   counts of games that belong to no pair
//   score                 a game a line: 1, 0.5 or 0 points for the first team; with a column pair, two lines with the
//                         same text in it and the same teams are a pair, whichever of the teams stands first; a game
//                         whose field is empty belongs to none
//
// All counts are from the first team's point of view. The same teams may stand in several lines; they add up.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "statistics/encounter.hpp"

namespace regista::study {

struct ResultsOfTeams {
  std::vector<std::string> teams;                 // in the order of their first line
  std::vector<statistics::Encounter> encounters;  // a pairing each, in the order of its first line
};

inline constexpr std::size_t most_ranked_teams = 500;

// Throws config::Error at the place of whatever cannot be used: a column that is missing or unknown, a count that is no
// whole number from 0 on, a team against itself, a pair that is no two games, no game at all.
ResultsOfTeams read_results_of_teams(const std::filesystem::path& file);

}  // namespace regista::study
