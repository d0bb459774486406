// SPDX-License-Identifier: MIT
// The values of an experiment document: teams to compare ("arms"), one opponent for all arms, the amount of play, the
// measures, and the statistical test. The study follows section 4 of Affinita et al., "Multi-Agent Coordination for a
// Partially Observable and Dynamic Robot Soccer Environment with Limited Communication", 2023: 60 minutes per arm.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/declaration.hpp"
#include "config/match_settings.hpp"

namespace regista::config {

enum class PairedTest {
  paired_t,   // Student's t test on the differences of pairs of matches
  sign_flip,  // permutation test that changes the signs of the differences
};

// The measure that the statistical test uses, and the arms that it compares. Reports only describe other measures.
struct ExperimentPrimary {
  std::string measure;
  std::vector<Node> compare;  // each element is a list of two arm names; empty: every pair of arms
  PairedTest test = PairedTest::sign_flip;
};

struct Experiment {
  struct Arm {
    std::string name;
    std::string team;  // file; empty: the team of the experiment
    Node set;          // values that this arm changes, as a map from paths to values, or absent
    Location where;
  };

  // A value that is varied. Every arm plays with each of `values` at `path`.
  struct Sweep {
    std::string path;
    std::vector<Node> values;
  };

  std::string name, question;
  std::vector<Arm> arms;
  std::string team, opponent;     // files; `team` is the team of all arms that name no team
  std::optional<double> minutes;  // minutes of game clock for each arm and each value of the sweep
  std::optional<int> matches;     // even number of matches for each arm and each value of the sweep
  std::int64_t seed = 1;
  std::string disturbance, opponent_disturbance;  // files for the arm's team and for the opponent; empty: none
  std::optional<Sweep> sweep;
  std::vector<Node> measures;  // paths of numbers in the result of a match; empty: the default measures
  std::optional<ExperimentPrimary> primary;
  double confidence = 0.95;
  MatchSettings settings;
};

Map declare(Experiment& experiment);
void check(const Experiment& experiment, const Node& document, Mistakes& mistakes);

}  // namespace regista::config
