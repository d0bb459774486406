// SPDX-License-Identifier: MIT
// The document of a study that the program does not have.
#pragma once

#include <string>

#include "config/documents.hpp"

namespace regista::config {

struct GoalCount {
  std::string name;
  std::string home, away;  // teams: files
  int pairs = 1;           // of matches, the sides swapped
  MatchSettings settings;
};

inline Map declare(GoalCount& count) {
  return {joined({without_effect(required(name("goal_count", count.name, "name of this count"))),
                  required(file("home", count.home, "a team")), required(file("away", count.away, "the other one")),
                  integer("pairs", count.pairs, {1, 1000}, "1", "of matches with the sides swapped")},
                 fields_of(count.settings, "values laid over documents, by path"))};
}

inline void check(const GoalCount& count, const Node& document, Mistakes& mistakes) {
  if (count.home == count.away) {
    Refusals(document, mistakes)({"away", "home"}, "away: the same team as home; a count is of two");
  }
}

const DocumentKind& declared_kind(const GoalCount*);
inline constexpr DocumentKind goal_count_kind = document_kind<GoalCount>("goal_count", "Goals of matches, counted.");
inline const DocumentKind& declared_kind(const GoalCount*) { return goal_count_kind; }

}  // namespace regista::config
