// SPDX-License-Identifier: MIT
// An experiment as its YAML page says it: teams ("arms") that differ in what is asked about, one common opponent, how
// much is played, what is measured, and which test decides. Values only; nothing is opened or played here. The form is
// that of section 4 of Affinita et al., "Multi-Agent Coordination for a Partially Observable and Dynamic Robot Soccer
// Environment with Limited Communication", 2023: arms x 60 minutes of play.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/declaration.hpp"
#include "config/match_settings.hpp"

namespace regista::config {

enum class PairedTest {
  paired_t,   // Student's t on the differences of pairs
  sign_flip,  // all signs that the differences of pairs could as well have had
};

// What the experiment decides on; all else is described, not tested.
struct ExperimentPrimary {
  std::string measure;
  std::vector<Node> compare;  // each a list of two names of arms; empty: every two arms
  PairedTest test = PairedTest::paired_t;
  Location where;
};

struct Experiment {
  struct Arm {
    std::string name;
    std::string team;  // file; empty: that of the experiment
    Node set;          // map from paths to values, or absent
    Location where;
  };

  // Every arm is played at every value.
  struct Sweep {
    std::string path;
    std::vector<Node> values;
    Location where;
  };

  using Primary = ExperimentPrimary;

  std::string name, question;
  std::vector<Arm> arms;
  std::string team, opponent;     // files; team: of arms that name none
  std::optional<double> minutes;  // of the game's clock for each arm and value
  std::optional<int> matches;     // for each arm and value, even
  std::int64_t seed = 1;
  std::string disturbance, opponent_disturbance;  // files; of the arm's team, of its opponent; empty: none
  std::optional<Sweep> sweep;
  std::vector<Node> measures;  // paths of numbers of a match; empty: the usual ones
  std::optional<Primary> primary;
  double confidence = 0.95;
  MatchSettings settings;
};

Map declare(Experiment& experiment);

// Tells of values of the document that are sound one by one, but not together.
void check(const Experiment& experiment, const Node& document, Mistakes& mistakes);

}  // namespace regista::config
