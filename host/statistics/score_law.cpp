// SPDX-License-Identifier: MIT
#include "statistics/score_law.hpp"

#include <cassert>
#include <numeric>

namespace regista::statistics {
namespace {

constexpr double never_seen = 1e-3;  // M. Van den Bergh's regularisation

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

Count ScoreLaw::uneven() const {
  return std::accumulate(seen.begin(), seen.end(), Count{0}) - seen[(outcomes - 1) / 2];
}

ScoreLaw score_law(const GameCounts& counts) { return law_of(Unit::game, counts.seen); }
ScoreLaw score_law(const PairCounts& counts) { return law_of(Unit::pair, counts.seen); }

}  // namespace regista::statistics
