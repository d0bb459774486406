// SPDX-License-Identifier: MIT
// The values of a tuning document: team, opponents, tuned numbers, objective, and number of matches.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "config/declaration.hpp"
#include "config/match_settings.hpp"

namespace regista::config {

// A parameter path to tune: `utility.terms.*.weight`, or `{path: sender.params.period, range: [5, 20]}`
struct TunedPath {
  std::string pattern;  // a path, or an fnmatch(3) pattern: '*' stands for any text, '?' for one character
  std::optional<std::array<double, 2>> range;
  Location where, range_where;
};

// An objective: `{maximise: goal_difference}` or `{minimise: {overlap_seconds: 1, packets: 0.01}}`
struct TuningObjective {
  struct Term {
    std::string measure;
    double weight = 1.0;
    Location where;
  };
  std::vector<Term> maximise, minimise;  // one list is empty; if both are empty, goal_difference is maximised
};

struct Tuning {
  struct Opponent {
    std::string team;  // file
    double weight = 1.0;
    Location where;
  };
  struct Search {
    std::string algorithm = "sbplx";
    int matches = 1000;
    std::optional<double> minutes;  // limit of wall time for the search, min
    std::optional<int> pairs;       // pairs of matches against each opponent for each evaluation
    std::optional<int> population;
    std::vector<Node> start_from;  // points to evaluate first: each a map from paths of parameters to numbers
  };
  struct Selection {
    // Number of finalists, and largest number of matches of all finalists together.
    int finalists = 4, matches = 80;
  };
  enum class Against { opponents, base };
  enum class Test { betting, symmetric };
  struct Verification {
    // Largest numbers of verified candidates, and of matches of all candidates and the base team together.
    int candidates = 1, matches = 400;
    Against against = Against::opponents;
    Test test = Test::betting;
    double confidence = 0.95;
  };
  struct Slices {
    // A slice varies one parameter of the tuned team. Numbers of points for each parameter, and of pairs of matches
    // against each opponent for each point.
    int points = 5, pairs = 4;
  };

  std::string name, question;
  std::string team;  // file
  std::vector<Opponent> opponents;
  std::vector<TunedPath> parameters;
  TuningObjective objective;
  std::string disturbance, opponent_disturbance;  // files for the tuned team and its opponents; empty: none
  int seed = 1;                                   // seed of the search and of the first matches, below 2^31
  Search search;
  Selection selection;
  Verification verification;
  Slices slices;
  MatchSettings settings;
};

Map declare(Tuning& tuning);
void check(const Tuning& tuning, const Node& document, Mistakes& mistakes);

}  // namespace regista::config
