// SPDX-License-Identifier: MIT
// What every study says of its matches, whoever plays them and whatever they are for: under which rules, with which
// robots, from which scenes, how long, with which values set, and how they are played.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/declaration.hpp"

namespace regista::config {

// Whole numbers up to here are numbers of a document, too.
inline constexpr double largest_seed = 9007199254740992.0;

// What a match may use up; a plugin that takes more forfeits it.
struct MatchLimits {
  int processor_seconds = 10;       // of one call of a plugin
  int memory = 2048;                // MiB of address space of a match
  std::optional<int> wall_seconds;  // of one call; without it ten times its processor time and 100
  int match_seconds = 1800;         // of wall time, of a whole match
};

enum class Isolation {
  after_death,  // a match that died is played again with each team in a process of its own
  always,       // every match is
};

struct MatchSettings {
  std::string rules, robot;         // files; empty: the built-in values
  std::vector<NamedPath> openings;  // files, or folders of them
  std::optional<double> limit;      // s of a match
  Node set;                         // map from paths to values, or absent
  MatchLimits limits;
  Isolation isolation = Isolation::after_death;
  bool play_twice = true;
  bool allow_shared_memory = false;
  std::vector<Node> played_with;  // lines of hashes: what it was played with when it was written down
};

// Keys at the top of a study's document. set: the meaning of that key.
std::vector<Field> fields_of(MatchSettings& settings, std::string set);

// The first fields, then the others.
std::vector<Field> joined(std::vector<Field> first, std::vector<Field> others);

}  // namespace regista::config
