// SPDX-License-Identifier: MIT
#include "statistics/rating.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "statistics/distributions.hpp"

namespace regista::statistics {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

double elo_of_score(double score) {
  if (score <= 0.0) return -infinite;
  if (score >= 1.0) return infinite;
  return 400.0 * std::log10(score / (1.0 - score));
}

double score_of_elo(double elo) { return 1.0 / (1.0 + std::pow(10.0, -elo / 400.0)); }

Estimate elo(const ScoreLaw& law, double confidence) {
  const double value = elo_of_score(law.mean);
  if (law.variation != Variation::some) return {value, {-infinite, infinite}};
  const double margin = central_normal(confidence) * std::sqrt(law.variance / law.units);
  return {value, {elo_of_score(law.mean - margin), elo_of_score(law.mean + margin)}};
}

Estimate normalized_elo(const ScoreLaw& law, double confidence) {
  const double games_per_unit = law.unit == Unit::pair ? 2.0 : 1.0;
  const double value = normalized_elo_scale * (law.mean - 0.5) / std::sqrt(games_per_unit * law.variance);
  if (law.variation != Variation::some) return {value, {-infinite, infinite}};
  const double margin = normalized_elo_scale * central_normal(confidence) / std::sqrt(games_per_unit * law.units);
  return {value, {value - margin, value + margin}};
}

double likelihood_of_superiority(const ScoreLaw& law) {
  switch (law.variation) {
    case Variation::none:
      return 0.5;
    case Variation::one_sided: {
      const double doubt = std::exp2(-(std::round(law.units) + 1.0));
      return law.mean > 0.5 ? 1.0 - doubt : doubt;
    }
    case Variation::some:
      break;
  }
  return normal_below((law.mean - 0.5) / std::sqrt(law.variance / law.units));
}

std::optional<double> pair_ratio(const PairCounts& counts) {
  const auto& seen = counts.seen;
  if (seen[0] + seen[1] == 0) return std::nullopt;
  return static_cast<double>(seen[3] + seen[4]) / static_cast<double>(seen[0] + seen[1]);
}

}  // namespace regista::statistics
