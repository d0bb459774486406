// SPDX-License-Identifier: MIT
// The law of scores that counts suggest: which scores there are, how probable each is, and its first two moments. All
// ratings and likelihood ratios start here. A score is the share of points of one unit (a game or a pair): games 0,
// 1/2, 1; pairs 0, 1/4, 1/2, 3/4, 1.
//
// An outcome that was never seen counts as seen 0.001 times, as in the test frames of chess engines: no probability is
// then zero, and the likelihood ratios stay finite.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "statistics/counts.hpp"

namespace regista::statistics {

enum class Unit { game, pair };

// Which scores were seen.
enum class Variation {
  none,       // every unit scored exactly 1/2: neither a direction nor a spread
  one_sided,  // every unit scored the same, not 1/2: a direction, but no spread
  some,       // at least two different scores
};

struct ScoreLaw {
  Unit unit;
  Variation variation;
  std::size_t outcomes;                 // 3 or 5; that many elements of the arrays are used
  std::array<Count, 5> seen;            // the counts
  std::array<double, 5> scores;         // ascending, of [0, 1]
  std::array<double, 5> probabilities;  // each above 0, their sum is 1
  double units;                         // games or pairs, with the 0.001 for each outcome never seen
  double mean;                          // of [0, 1]
  double variance;                      // of one unit's score, above 0

  // Units that did not score exactly 1/2.
  Count uneven() const;

  std::span<const double> score() const { return {scores.data(), outcomes}; }
  std::span<const double> probability() const { return {probabilities.data(), outcomes}; }
};

// Precondition: no count is negative or above most_counted, and at least one is above zero.
ScoreLaw score_law(const GameCounts& counts);
ScoreLaw score_law(const PairCounts& counts);

}  // namespace regista::statistics
