// SPDX-License-Identifier: MIT
// The settings of all matches of a study: rules, robots, openings, length, changed values, limits, and way of playing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/declaration.hpp"

namespace regista::config {

// Largest seed, 2^53. A double holds every whole number up to this limit exactly.
inline constexpr double largest_seed = 9007199254740992.0;

// The limits of a match. A team forfeits the match if its plugin exceeds a limit.
struct MatchLimits {
  int processor_seconds = 10;       // processor time of one call of a plugin, s
  int memory = 2048;                // address space of a match, MiB
  std::optional<int> wall_seconds;  // wall time of one call of a plugin, s; missing: 10 * processor_seconds + 100
  int match_seconds = 1800;         // wall time of a whole match, s
};

enum class Isolation {
  after_death,  // a match is played again with one process for each team if the process of the match died
  always,       // every match is played with one process for each team
};

// How a study chooses the seeds of its pairs of matches. All pairings and arms of the study use the same seeds.
enum class Seeds {
  hashed,       // seeds count up from a hash of the study's seed: studies with other seeds have other matches
  consecutive,  // seeds count up from the study's seed: equally long studies with seeds 1 and 2 share all but one pair
};

struct MatchSettings {
  std::string rules, robot;         // files; empty: the built-in values
  std::vector<NamedPath> openings;  // files or folders of openings
  std::optional<double> limit;      // largest length of a match, s
  Node set;  // values that the study changes in its documents, as a map from paths to values, or absent
  MatchLimits limits;
  Isolation isolation = Isolation::after_death;
  Seeds seeds = Seeds::hashed;
  bool play_twice = true;            // true: the first match of each pairing is repeated with a process for each robot
  bool allow_shared_memory = false;  // true: plugins may keep data that all robots of a team use
  std::vector<Node> played_with;     // names and hashes of the program, plugins and profiles of an earlier run
};

// Declares the top-level keys of the settings in a study's document. The text `set` describes the key `set`.
std::vector<Field> fields_of(MatchSettings& settings, std::string set);

}  // namespace regista::config
