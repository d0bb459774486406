// SPDX-License-Identifier: MIT
// The values of a tournament document: teams, pairings, number of matches, openings, and a sequential test.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/declaration.hpp"
#include "config/match_settings.hpp"

namespace regista::config {

// A sequential test between two teams. It tests the scores of pairs of matches, or a number in the result of a match.
struct TournamentTest {
  enum class Model { normalized, logistic };
  std::optional<std::array<double, 2>> elo;  // the two Elo hypotheses that the test separates, the smaller one first
  Model model = Model::normalized;           // kind of Elo scale of `elo`; not used for a metric
  std::string metric;  // "goals", or the path of a number in the result of a match; empty: the test uses scores
  static constexpr double usual_rate = 0.05;
  double alpha = usual_rate;
  std::optional<double> beta;  // only with `elo`; missing: usual_rate
};

struct Tournament {
  struct Team {
    std::string team;           // file
    std::string disturbance{};  // file of a disturbance for this team alone; empty: the disturbance of all teams
  };
  // round_robin: all teams meet. gauntlet: each team meets the first team. swiss: in each round, each team meets a team
  // with about as many points. knock_out: the loser of a meeting leaves.
  enum class Format { round_robin, gauntlet, swiss, knock_out };

  std::string name, question;
  std::vector<Team> teams;
  Format format = Format::round_robin;
  std::optional<int> rounds;  // of a Swiss tournament; missing: as many as a knock-out of these teams has
  std::optional<int> pairs;   // pairs of matches for each pairing; with a test: the largest number of pairs
  std::optional<TournamentTest> test;
  std::int64_t seed = 1;       // seed of the pairs; see MatchSettings::seeds
  std::string disturbance;     // file for all teams; empty: no disturbance
  int failures_in_a_row = 10;  // this many forfeits in a row by the same plugin exclude a team; 0: no exclusion
  MatchSettings settings;
};

Map declare(Tournament& tournament);
void check(const Tournament& tournament, const Node& document, Mistakes& mistakes);

}  // namespace regista::config
