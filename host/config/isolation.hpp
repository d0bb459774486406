// SPDX-License-Identifier: MIT
// When the teams of a study think in a process each, as its document and the command line say it.
#pragma once

#include <string>
#include <vector>

namespace regista::config {

enum class Isolation {
  after_death,  // a match that died is played again so
  always,       // every match is
};

// In their order.
inline const std::vector<std::string>& isolation_names() {
  static const std::vector<std::string> names{"after-death", "always"};
  return names;
}

inline constexpr const char* isolation_doc =
    "after-death: a match that died is played again with each team in a process of its own; always: every match is "
    "played so";
inline constexpr const char* play_twice_doc =
    "the first match of each pairing, again with each robot in a process of its own: whether it is reproducible, and "
    "whether robots decide alone";
inline constexpr const char* allow_shared_memory_doc =
    "plugins may keep what all robots of a team know: a team thinks in one process, and the report says so";

}  // namespace regista::config
