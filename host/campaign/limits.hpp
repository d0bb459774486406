// SPDX-License-Identifier: MIT
// What a match may use up before it is ended, and how far its minds are kept apart.
#pragma once

#include <cstdint>

namespace regista::campaign {

enum class Isolation {
  after_a_death,  // minds share a process; a match that died is played again with each team's in one of its own
  always,         // each team's minds have one of their own
};

struct Limits {
  int processor_seconds = 10;                     // of one call of a plugin
  std::uint64_t memory = std::uint64_t{2} << 30;  // bytes of address space of a process, RLIMIT_AS; 0 = no limit
  double wall_seconds = 200.0;                    // of one call: a far back-stop, for a plugin that sleeps
  double match_wall_seconds = 1800.0;             // of a whole match
  Isolation isolation = Isolation::after_a_death;
  // The first match of a pairing is played again with each mind in a process of its own, to find out what is not
  // reproducible and which robots do not decide alone.
  bool play_twice = true;
  // Robots of a team may share memory: each team's minds have one process, also in that second play.
  bool allow_shared_memory = false;

  // Processor time of the whole match, RLIMIT_CPU.
  int match_seconds() const { return 100 * processor_seconds; }
  friend bool operator==(const Limits&, const Limits&) = default;
};

}  // namespace regista::campaign
