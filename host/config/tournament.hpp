// SPDX-License-Identifier: MIT
// A tournament as its YAML page says it: who plays, all against all or the first against each of the others, how often,
// from which scenes, and which test decides. Values only; nothing is opened or played here.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "config/declaration.hpp"
#include "config/isolation.hpp"
#include "config/path_list.hpp"

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
  int seed = 1;
  std::vector<NamedPath> openings;
  std::optional<double> limit;            // s of a match
  std::string rules, robot, disturbance;  // files; empty: the built-in values
  Node set;                               // map or absent
  int failures_in_a_row = 10;
  Isolation isolation = Isolation::after_death;
  bool play_twice = true;
  bool allow_shared_memory = false;
};

Map declare(Tournament& tournament);

// Tells of values of the document that are sound one by one, but not together.
void check(const Tournament& tournament, const Node& document, Mistakes& mistakes);

}  // namespace regista::config
