// SPDX-License-Identifier: MIT
#include "match/game_state.hpp"

namespace regista::match {

const char* name(EventKind kind) {
  constexpr std::array names{"half begins",
                             "ready",
                             "set",
                             "kick-off",
                             "goal",
                             "goal not counted",
                             "kick-in",
                             "goal kick",
                             "corner kick",
                             "pushing free kick",
                             "penalty kick",
                             "whistle",
                             "ball free",
                             "game stuck",
                             "penalty",
                             "returned",
                             "put back",
                             "too many packets",
                             "packet too long",
                             "half ends",
                             "finished",
                             "opening"};
  static_assert(names.size() == static_cast<std::size_t>(EventKind::opening) + 1);
  return names[static_cast<std::size_t>(kind)];
}

const char* name(Offence offence) {
  constexpr std::array<const char*, offence_count> names{
      "none",    "illegal position", "illegal position in set", "motion in set",
      "fallen",  "inactive",         "local game stuck",        "ball holding",
      "pushing", "leaving the field"};
  return names[static_cast<std::size_t>(offence)];
}

}  // namespace regista::match
