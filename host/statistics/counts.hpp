// SPDX-License-Identifier: MIT
// Counts of game outcomes, and the distribution of scores that the counts suggest. All counts are from the first team's
// point of view. They count single games (three outcomes) or pairs of games with the same seed and the sides swapped
// (five outcomes). A test must use pairs, because the two games of a pair depend on each other. M. Van den Bergh, "The
// generalized sequential probability ratio test", notes on the test frame of Stockfish, 2019.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace regista::statistics {

using Count = std::int64_t;

// Largest count of an outcome for which all functions of this folder keep their accuracy.
inline constexpr Count most_counted = 1'000'000'000;

enum class GameOutcome : std::uint8_t { loss, draw, win };

// The sum of the outcomes of two games: LL, LD, WL or DD, WD, WW.
enum class PairOutcome : std::uint8_t { two_losses, loss_and_draw, even, win_and_draw, two_wins };

PairOutcome pair_outcome(GameOutcome first, GameOutcome second);

template <class Outcome, std::size_t outcomes>
struct OutcomeCounts {
  std::array<Count, outcomes> seen{};  // in the order of Outcome

  void add(Outcome outcome) { ++seen[static_cast<std::size_t>(outcome)]; }
  friend bool operator==(const OutcomeCounts&, const OutcomeCounts&) = default;
};
using GameCounts = OutcomeCounts<GameOutcome, 3>;  // losses, draws, wins
using PairCounts = OutcomeCounts<PairOutcome, 5>;  // LL, LD, WL + DD, WD, WW

template <class Outcome, std::size_t outcomes>
Count total(const OutcomeCounts<Outcome, outcomes>& counts) {
  return std::accumulate(counts.seen.begin(), counts.seen.end(), Count{0});
}

// Returns the same games from the other team's point of view.
template <class Outcome, std::size_t outcomes>
OutcomeCounts<Outcome, outcomes> swapped(OutcomeCounts<Outcome, outcomes> counts) {
  std::ranges::reverse(counts.seen);
  return counts;
}

// All games between two teams. All counts are from the first team's point of view.
struct Encounter {
  std::size_t first = 0, second = 0;  // indices of two different teams
  PairCounts pairs;                   // pairs of games
  GameCounts games;                   // games that belong to no pair

  Count games_played() const { return 2 * total(pairs) + total(games); }
  // Returns the points of the first team: 1 for each win, 1/2 for each draw.
  double points() const {
    double out = 0.5 * static_cast<double>(games.seen[1]) + static_cast<double>(games.seen[2]);
    for (std::size_t i = 0; i < pairs.seen.size(); ++i)
      out += 0.5 * static_cast<double>(i) * static_cast<double>(pairs.seen[i]);
    return out;
  }
};

// --- The distribution of scores that the counts suggest: the possible scores, their probabilities, mean and variance.
// All ratings and likelihood ratios use this distribution. The score of a unit (a game or a pair) is its share of
// points: games 0, 1/2, 1; pairs 0, 1/4, 1/2, 3/4, 1.
//
// An outcome with count 0 is counted as 0.001, as in the test frameworks of chess engines. So no probability is zero,
// and the likelihood ratios stay finite.

enum class Unit { game, pair };

// How much the observed scores differ from 1/2 and from each other.
enum class Variation {
  none,       // every unit scored exactly 1/2
  one_sided,  // every unit has the same score, which is not 1/2
  some,       // at least two units have different scores
};

struct ScoreLaw {
  Unit unit;
  Variation variation;
  std::size_t outcomes;                 // 3 or 5: the number of array elements in use
  std::array<Count, 5> seen;            // observed count of each outcome
  std::array<double, 5> scores;         // ascending, in [0, 1]
  std::array<double, 5> probabilities;  // each above 0; the sum is 1
  double units;                         // number of games or pairs, plus 0.001 for each outcome with count 0
  double mean;                          // in [0, 1]
  double variance;                      // of the score of one unit; above 0

  // Returns the number of units with a score other than 1/2.
  Count uneven() const;
};

// Precondition: every count is between 0 and most_counted, and at least one count is above 0.
ScoreLaw score_law(const GameCounts& counts);
ScoreLaw score_law(const PairCounts& counts);

// The observed scores, without the 0.001 that a ScoreLaw adds for outcomes with count 0.
struct SeenScores {
  Count units = 0;
  double mean = 0.0;
  double squares = 0.0;  // sum of squared deviations from the mean
};
SeenScores seen_scores(const ScoreLaw& law);

}  // namespace regista::statistics
