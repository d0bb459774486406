// SPDX-License-Identifier: MIT
#include "study/either_way.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "statistics/sign_flip.hpp"

namespace regista::study {
namespace {

// What the conditions have shown.
struct Extremes {
  double least = HUGE_VAL, most = -HUGE_VAL;
};

Extremes extremes(const PartlyPlayed& first, const PartlyPlayed& second) {
  Extremes out;
  for (const PartlyPlayed* const side : {&first, &second}) {
    for (const double each : side->values) {
      if (std::isnan(each)) continue;
      out.least = std::min(out.least, each);
      out.most = std::max(out.most, each);
    }
  }
  return out;
}

std::vector<double> filled(const PartlyPlayed& side, double value) {
  std::vector<double> out(side.values.begin(), side.values.end());
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (side.unplayed[i]) out[i] = value;
  }
  return out;
}

int sign(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

struct Answer {
  double p = 1.0;
  int side = 0;  // 1: the first has more
};

Answer by_size(const std::vector<double>& first, const std::vector<double>& second, PairTest test) {
  const std::optional<PairP> p = p_of_difference(first, second, test);
  double sum = 0.0;
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
    if (!std::isnan(first[i] - second[i])) sum += first[i] - second[i];
  }
  return p ? Answer{p->p, sign(sum)} : Answer{};
}

// All missing ones have this sign.
Answer by_signs(const PartlyPlayed& first, const PartlyPlayed& second, int missing) {
  std::vector<double> signs;
  int sum = 0;
  for (std::size_t i = 0; i < std::min(first.values.size(), second.values.size()); ++i) {
    const double difference = first.values[i] - second.values[i];
    const bool unplayed = first.unplayed[i] || second.unplayed[i];
    if (!unplayed && std::isnan(difference)) continue;
    signs.push_back(unplayed ? missing : sign(difference));
    sum += unplayed ? missing : sign(difference);
  }
  return {statistics::sign_flip_p_of_values(signs), sign(sum)};
}

}  // namespace

std::uint64_t unplayed_pairs(const PartlyPlayed& first, const PartlyPlayed& second) {
  std::uint64_t out = 0;
  for (std::size_t i = 0; i < std::min(first.unplayed.size(), second.unplayed.size()); ++i) {
    if (first.unplayed[i] || second.unplayed[i]) ++out;
  }
  return out;
}

double p_either_way(const PartlyPlayed& first, const PartlyPlayed& second, PairTest test) {
  const Answer without =
      by_size({first.values.begin(), first.values.end()}, {second.values.begin(), second.values.end()}, test);
  if (unplayed_pairs(first, second) == 0) return without.p;
  const auto [least, most] = extremes(first, second);
  double p = without.p;
  for (const Answer& each : {by_size(filled(first, least), filled(second, most), test),
                             by_size(filled(first, most), filled(second, least), test), by_signs(first, second, -1),
                             by_signs(first, second, 1)}) {
    if (each.side != without.side) return 1.0;
    p = std::max(p, each.p);
  }
  return p;
}

}  // namespace regista::study
