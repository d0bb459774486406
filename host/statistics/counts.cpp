// SPDX-License-Identifier: MIT
#include "statistics/counts.hpp"

#include <cassert>
#include <span>

namespace regista::statistics {
namespace {

constexpr double never_seen = 1e-3;  // count of an outcome that was not observed: regularisation of M. Van den Bergh

ScoreLaw law_of(Unit unit, std::span<const Count> counts) {
  ScoreLaw law{};
  law.unit = unit;
  law.outcomes = counts.size();
  std::size_t different = 0, last = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    assert(counts[i] >= 0 && counts[i] <= most_counted);
    law.seen[i] = counts[i];
    law.scores[i] = static_cast<double>(i) / static_cast<double>(counts.size() - 1);
    law.probabilities[i] = counts[i] > 0 ? static_cast<double>(counts[i]) : never_seen;
    law.units += law.probabilities[i];
    if (counts[i] > 0) {
      ++different;
      last = i;
    }
  }
  assert(different > 0);
  law.variation = different > 1                     ? Variation::some
                  : last == (counts.size() - 1) / 2 ? Variation::none
                                                    : Variation::one_sided;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    law.probabilities[i] /= law.units;
    law.mean += law.probabilities[i] * law.scores[i];
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double deviation = law.scores[i] - law.mean;
    law.variance += law.probabilities[i] * deviation * deviation;
  }
  return law;
}

}  // namespace

PairOutcome pair_outcome(GameOutcome first, GameOutcome second) {
  return static_cast<PairOutcome>(static_cast<int>(first) + static_cast<int>(second));
}

Count ScoreLaw::uneven() const {
  return std::accumulate(seen.begin(), seen.end(), Count{0}) - seen[(outcomes - 1) / 2];
}

SeenScores seen_scores(const ScoreLaw& law) {
  SeenScores out;
  for (std::size_t i = 0; i < law.outcomes; ++i) {
    out.units += law.seen[i];
    out.mean += static_cast<double>(law.seen[i]) * law.scores[i];
  }
  out.mean /= static_cast<double>(out.units);
  for (std::size_t i = 0; i < law.outcomes; ++i) {
    const double deviation = law.scores[i] - out.mean;
    out.squares += static_cast<double>(law.seen[i]) * deviation * deviation;
  }
  return out;
}

ScoreLaw score_law(const GameCounts& counts) { return law_of(Unit::game, counts.seen); }
ScoreLaw score_law(const PairCounts& counts) { return law_of(Unit::pair, counts.seen); }

}  // namespace regista::statistics
