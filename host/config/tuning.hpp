// SPDX-License-Identifier: MIT
// A tuning as its YAML page says it: a team, opponents, which of its numbers may change, what counts as better, how
// much may be played. Values only; nothing is opened or played here.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "config/declaration.hpp"
#include "config/match_settings.hpp"

namespace regista::config {

// `utility.terms.*.weight`, or `{path: sender.params.period, range: [5, 20]}`
struct TunedPath {
  std::string pattern;  // '*' and '?' stand for any letters
  std::optional<std::array<double, 2>> range;
  Location where, range_where;
};

// `{maximise: goal_difference}`, `{minimise: {overlap_seconds: 1, packets: 0.01}}`
struct TuningObjective {
  struct Term {
    std::string measure;
    double weight = 1.0;
    Location where;
  };
  std::vector<Term> maximise, minimise;  // one of the two
  Location where;
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
    std::optional<double> minutes;  // of wall time
    std::optional<int> pairs;       // of matches against each opponent, for each evaluation
    std::optional<int> population;
    Location where;
  };
  struct Selection {
    int finalists = 4, matches = 80;  // of all finalists together
    Location where;
  };
  enum class Against { opponents, base };
  enum class Test { betting, symmetric };
  struct Verification {
    int candidates = 1, matches = 400;  // at most, of all candidates and the base team together
    Against against = Against::opponents;
    Test test = Test::betting;
    double confidence = 0.95;
    Location where;
  };
  struct Slices {
    int points = 5, pairs = 4;  // of matches with each opponent, for each point
    Location where;
  };

  std::string name, question;
  std::string team;  // file
  std::vector<Opponent> opponents;
  std::vector<TunedPath> parameters;
  TuningObjective objective;
  std::string disturbance, opponent_disturbance;  // files; of the tuned team, of its opponents; empty: none
  int seed = 1;                                   // with every other number of a stage below 2^40
  Search search;
  Selection selection;
  Verification verification;
  Slices slices;
  MatchSettings settings;
};

Map declare(Tuning& tuning);

// Throws Error at values of the document that are sound one by one, but not together.
void check(const Tuning& tuning, const Node& document, Mistakes& mistakes);

}  // namespace regista::config
