// SPDX-License-Identifier: MIT
// The ranking of teams by results from elsewhere: Bradley-Terry Elo with intervals by pairs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "statistics/interval.hpp"
#include "study/results_table.hpp"

namespace regista::report {

struct RankedResults {
  struct Team {
    std::string name;
    std::optional<statistics::Estimate> elo;  // nothing where the results do not tell the strengths
    double points = 0.0;
    statistics::Count games = 0;
  };
  std::vector<Team> teams;  // the best first: by Elo, else by share of points, then in the order of the file
  statistics::Count games = 0, pairs = 0;
  bool determined = false;  // there is an Elo of every team
};

RankedResults ranked(const study::ResultsOfTeams& results);

// Lines, each ended; one JSON object with a newline.
std::string ranking_text(const RankedResults& ranking);
std::string ranking_json(const RankedResults& ranking);

}  // namespace regista::report
