// SPDX-License-Identifier: MIT
#include "statistics/counts.hpp"

#include <numeric>

namespace regista::statistics {

PairOutcome pair_outcome(GameOutcome first, GameOutcome second) {
  return static_cast<PairOutcome>(static_cast<int>(first) + static_cast<int>(second));
}

Count total(const GameCounts& counts) { return std::accumulate(counts.seen.begin(), counts.seen.end(), Count{0}); }
Count total(const PairCounts& counts) { return std::accumulate(counts.seen.begin(), counts.seen.end(), Count{0}); }

GameCounts swapped(const GameCounts& counts) { return {{counts.seen[2], counts.seen[1], counts.seen[0]}}; }

PairCounts swapped(const PairCounts& counts) {
  return {{counts.seen[4], counts.seen[3], counts.seen[2], counts.seen[1], counts.seen[0]}};
}

}  // namespace regista::statistics
