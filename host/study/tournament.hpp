// SPDX-License-Identifier: MIT
// A against B in pairs: what is played, and what came of it. A pair is two matches with the same seed and the sides
// swapped; its score is what is counted, because its two matches are not independent. A forfeit counts 0:10.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job.hpp"

namespace regista::study {

// Match `index` of a schedule: pair k holds the matches 2k (A at home) and 2k + 1 (B at home), seed base + k.
struct Fixture {
  std::uint64_t pair;
  bool swapped;  // B is at home
  std::uint64_t seed;
};
constexpr Fixture fixture(std::uint64_t index, std::uint64_t base_seed) {
  return {index / 2, index % 2 == 1, base_seed + index / 2};
}

// Forfeits for the same reason: the first match, and how many.
struct Forfeits {
  int team = 0;  // 0 A, 1 B
  campaign::Failure failure;
  std::uint64_t first_match = 0, count = 0;
};

// Everything from A's point of view.
struct Standing {
  std::uint64_t wins = 0, draws = 0, losses = 0;
  std::array<std::uint64_t, 5> pairs{};  // [LL, LD, WL+DD, WD, WW]
  std::array<std::uint64_t, 2> goals{};  // of A, of B; those of forfeits too
  std::vector<Forfeits> forfeits;        // in the order of their first match; team, plugin, call and reason differ
  std::uint64_t unlisted_forfeits = 0;   // of kinds beyond the first most_listed
  std::uint64_t games() const { return wins + draws + losses; }
  std::uint64_t complete_pairs() const { return games() / 2; }
};

inline constexpr std::size_t most_listed = 100;

// Takes matches in the order of the schedule.
class Tally {
 public:
  // Precondition: match 0, then 1, ...
  void add(const campaign::Decided& decided);
  const Standing& standing() const { return standing_; }

 private:
  void list(const campaign::Failure& failure, int team);
  Standing standing_;
  int first_of_pair_ = 0;  // points of A in it, twice: 0, 1, 2
};

}  // namespace regista::study
