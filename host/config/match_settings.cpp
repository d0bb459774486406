// SPDX-License-Identifier: MIT
#include "config/match_settings.hpp"

#include <utility>

namespace regista::config {

static Map declare(MatchLimits& limits) {
  return {{
      integer("processor_seconds", limits.processor_seconds, {1, 1000000}, "s",
              "of processor time, of one call of a plugin"),
      integer("memory", limits.memory, {64, 16777216}, "MiB", "address space of a match"),
      without_effect(with_default_from(
          integer("wall_seconds", limits.wall_seconds, {1, 1000000}, "s", "of wall time, of one call of a plugin"),
          "`processor_seconds`: ten times it and 100 s")),
      without_effect(
          integer("match_seconds", limits.match_seconds, {1, 1000000}, "s", "of wall time, of a whole match")),
  }};
}

std::vector<Field> fields_of(MatchSettings& settings, std::string set) {
  return {
      file("rules", settings.rules, "rules profile; `spl2023` is built in", "spl2023"),
      file("robot", settings.robot, "robot profile of all; `nao` is built in", "nao"),
      paths("openings", settings.openings, "scenes that matches start from: files, or folders of them"),
      real("limit", settings.limit, {0.1, 1e6}, "s", "after which each match ends"),
      free("set", settings.set, "settings", std::move(set)),
      choice("seeds", settings.seeds, {"hashed", "consecutive"},
             "of pairs of matches: hashed: from a hash of `seed` on, so that studies with other seeds share no match; "
             "consecutive: from `seed` itself on, as older studies had them"),
      section("limits", settings.limits, "what a match may use up; a plugin that takes more forfeits it"),
      without_effect(choice("isolation", settings.isolation, {"after-death", "always"},
                            "after-death: a match that died is played again with each team in a process of its own; "
                            "always: every match is played so")),
      without_effect(boolean("play_twice", settings.play_twice,
                             "the first match of each pairing, again with each robot in a process of its own: whether "
                             "it is reproducible, and whether robots decide alone")),
      boolean("allow_shared_memory", settings.allow_shared_memory,
              "plugins may keep what all robots of a team know: a team thinks in one process, and the report says so"),
      without_effect(lines("played_with", settings.played_with,
                           "of a study that was played before: its program, plugins and profiles with their hashes; "
                           "what is another now is reported before the first match")),
  };
}

}  // namespace regista::config
