// SPDX-License-Identifier: MIT
#include "statistics/variance_ratio.hpp"

#include <cstddef>

namespace regista::statistics {
namespace {

// Of the counts as they are: an outcome never seen adds nothing.
double variance_of_score(std::span<const Count> counts) {
  double total = 0.0, mean = 0.0, squares = 0.0;
  const double best = static_cast<double>(counts.size() - 1);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    total += static_cast<double>(counts[i]);
    mean += static_cast<double>(counts[i]) * static_cast<double>(i) / best;
  }
  mean /= total;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double deviation = static_cast<double>(i) / best - mean;
    squares += static_cast<double>(counts[i]) * deviation * deviation;
  }
  return squares / total;
}

bool varied(std::span<const Count> counts) {
  int seen = 0;
  for (const Count count : counts) seen += count > 0 ? 1 : 0;
  return seen > 1;
}

}  // namespace

std::optional<double> variance_ratio(const PairCounts& pairs, const GameCounts& games) {
  if (total(pairs) == 0 || !varied(games.seen)) return std::nullopt;
  return 2.0 * variance_of_score(pairs.seen) / variance_of_score(games.seen);
}

std::optional<double> variance_ratio(std::span<const ValuePair> pairs) {
  if (pairs.size() < 2) return std::nullopt;
  Moments means, all;
  bool differ = false;
  for (const ValuePair& pair : pairs) {
    means.add((pair.first + pair.second) / 2.0);
    all.add(pair.first);
    all.add(pair.second);
    differ = differ || pair.first != pairs.front().first || pair.second != pairs.front().first;
  }
  return differ ? variance_ratio(means, all) : std::nullopt;
}

std::optional<double> variance_ratio(const Moments& means, const Moments& all) {
  if (means.count() < 2 || !(all.variance() > 0.0)) return std::nullopt;
  return 2.0 * means.variance() / all.variance();
}

}  // namespace regista::statistics
