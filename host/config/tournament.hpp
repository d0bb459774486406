// SPDX-License-Identifier: MIT
// A tournament as its YAML page says it: who plays, all against all or the first against each of the others, how often,
// from which scenes, and which test decides. Values only; nothing is opened or played here.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/declaration.hpp"
#include "config/match_settings.hpp"

namespace regista::config {

// A sequential test between two teams. One of: on the scores of pairs, on a number of a match.
struct TournamentTest {
  enum class Model { normalized, logistic };
  std::optional<std::array<double, 2>> elo;  // what the scores are to tell apart, the smaller one first
  Model model = Model::normalized;           // what `elo` is in; says nothing of a metric
  std::string metric;                        // "goals", or the path of a number of a match; empty: none
  static constexpr double usual_rate = 0.05;
  double alpha = usual_rate;
  std::optional<double> beta;  // with `elo`; without it the usual rate
  Location where;
};

struct Tournament {
  struct Team {
    std::string team;           // file
    std::string disturbance{};  // file, of this team alone; empty: that of all
    Location where;
  };
  enum class Format { round_robin, gauntlet };
  using Test = TournamentTest;

  std::string name, question;
  std::vector<Team> teams;
  Format format = Format::round_robin;
  std::optional<int> pairs;  // of matches, of each pairing; with a test: at most
  std::optional<Test> test;
  std::int64_t seed = 1;       // of the first pair; the next one has the next
  std::string disturbance;     // file, of all teams; empty: none
  int failures_in_a_row = 10;  // after so many forfeits by the same plugin a team is set aside; 0: never
  MatchSettings settings;
};

Map declare(Tournament& tournament);

// Tells of values of the document that are sound one by one, but not together.
void check(const Tournament& tournament, const Node& document, Mistakes& mistakes);

}  // namespace regista::config
