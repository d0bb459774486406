// SPDX-License-Identifier: MIT
// How often each outcome was seen, always from the first team's point of view: of single games (three outcomes) or of
// pairs of games with the same seed and the sides swapped (five). The five are what a test of pairs needs: two games of
// a pair are not independent, two pairs are. Pentanomial counts: M. Van den Bergh, "The generalized sequential
// probability ratio test", notes on the test frame of Stockfish, 2019.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace regista::statistics {

using Count = std::int64_t;

// Up to this many of each outcome the functions of this room keep their accuracy.
inline constexpr Count most_counted = 1'000'000'000;

enum class GameOutcome : std::uint8_t { loss, draw, win };

// The sum of the two games' outcomes: LL, LD, WL or DD, WD, WW.
enum class PairOutcome : std::uint8_t { two_losses, loss_and_draw, even, win_and_draw, two_wins };

PairOutcome pair_outcome(GameOutcome first, GameOutcome second);

struct GameCounts {
  using Outcome = GameOutcome;
  std::array<Count, 3> seen{};  // losses, draws, wins

  void add(GameOutcome outcome) { ++seen[static_cast<std::size_t>(outcome)]; }
  friend bool operator==(const GameCounts&, const GameCounts&) = default;
};

struct PairCounts {
  using Outcome = PairOutcome;
  std::array<Count, 5> seen{};  // LL, LD, WL + DD, WD, WW

  void add(PairOutcome outcome) { ++seen[static_cast<std::size_t>(outcome)]; }
  friend bool operator==(const PairCounts&, const PairCounts&) = default;
};

Count total(const GameCounts& counts);  // games
Count total(const PairCounts& counts);  // pairs

// The same games seen by the other team.
GameCounts swapped(const GameCounts& counts);
PairCounts swapped(const PairCounts& counts);

}  // namespace regista::statistics
