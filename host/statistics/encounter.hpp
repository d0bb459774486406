// SPDX-License-Identifier: MIT
// What two of several teams played against each other.
#pragma once

#include <cstddef>

#include "statistics/counts.hpp"

namespace regista::statistics {

struct Encounter {
  std::size_t first = 0, second = 0;  // teams, different
  PairCounts pairs;                   // from the first team's point of view, as are the games
  GameCounts games;                   // that belong to no pair

  Count games_played() const { return 2 * total(pairs) + total(games); }
  // Of the first team: 1 for a won game, 1/2 for a drawn one.
  double points() const {
    double out = 0.5 * static_cast<double>(games.seen[1]) + static_cast<double>(games.seen[2]);
    for (std::size_t i = 0; i < pairs.seen.size(); ++i)
      out += 0.5 * static_cast<double>(i) * static_cast<double>(pairs.seen[i]);
    return out;
  }
};

}  // namespace regista::statistics
