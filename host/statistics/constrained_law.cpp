// SPDX-License-Identifier: MIT
#include "statistics/constrained_law.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace regista::statistics {
namespace {

constexpr int most_steps_of_law = 10;
constexpr double settled_law = 1e-9;  // largest change of a probability in the last round

using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

// The root of sum p phi / (1 + theta phi), which falls with theta between its poles. At the root the q sum to 1, hence
// none is above 1 and 1 + theta phi >= p for each: that keeps the root away from the poles, and bounds it.
std::optional<double> multiplier(const ScoreLaw& law, const Probabilities& phi) {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < law.outcomes; ++i) {
    const double bound = (law.probabilities[i] - 1.0) / phi[i];
    if (phi[i] > 0.0) low = std::max(low, bound);
    if (phi[i] < 0.0) high = std::min(high, bound);
  }
  if (!std::isfinite(low) || !std::isfinite(high)) return std::nullopt;  // phi has one sign only, or is no number
  const auto slope = [&](double theta) {
    double sum = 0.0;
    for (std::size_t i = 0; i < law.outcomes; ++i) sum += law.probabilities[i] * phi[i] / (1.0 + theta * phi[i]);
    return sum;
  };
  const double at_low = slope(low), at_high = slope(high);
  // Where rounding hides the change of sign, the root is the end itself.
  if (!(at_low > 0.0)) return low;
  if (!(at_high < 0.0)) return high;
  std::uintmax_t steps = 200;
  const auto [below, above] = boost::math::tools::toms748_solve(
      slope, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(), steps, Policy());
  return below + (above - below) / 2.0;
}

std::optional<Probabilities> tilted(const ScoreLaw& law, const Probabilities& phi) {
  const std::optional<double> theta = multiplier(law, phi);
  if (!theta) return std::nullopt;
  Probabilities out{};
  for (std::size_t i = 0; i < law.outcomes; ++i) {
    out[i] = law.probabilities[i] / (1.0 + *theta * phi[i]);
    if (!(out[i] > 0.0) || !std::isfinite(out[i])) return std::nullopt;
  }
  return out;
}

}  // namespace

std::optional<Probabilities> most_likely_with_mean(const ScoreLaw& law, double mean) {
  Probabilities phi{};
  for (std::size_t i = 0; i < law.outcomes; ++i) phi[i] = law.scores[i] - mean;
  return tilted(law, phi);
}

std::optional<Probabilities> most_likely_with_effect(const ScoreLaw& law, double effect) {
  Probabilities last{};
  std::fill_n(last.begin(), law.outcomes, 1.0 / static_cast<double>(law.outcomes));
  for (int round = 0; round < most_steps_of_law; ++round) {
    double mean = 0.0, variance = 0.0;
    for (std::size_t i = 0; i < law.outcomes; ++i) mean += last[i] * law.scores[i];
    for (std::size_t i = 0; i < law.outcomes; ++i) {
      const double deviation = law.scores[i] - mean;
      variance += last[i] * deviation * deviation;
    }
    if (!(variance > 0.0)) return std::nullopt;
    const double sd = std::sqrt(variance);
    Probabilities phi{};
    for (std::size_t i = 0; i < law.outcomes; ++i) {
      const double deviations = (law.scores[i] - mean) / sd;
      phi[i] = law.scores[i] - 0.5 - effect * sd * (1.0 + deviations * deviations) / 2.0;
    }
    const std::optional<Probabilities> next = tilted(law, phi);
    if (!next) return std::nullopt;
    double change = 0.0;
    for (std::size_t i = 0; i < law.outcomes; ++i) change = std::max(change, std::abs((*next)[i] - last[i]));
    last = *next;
    if (change < settled_law) break;
  }
  return last;
}

}  // namespace regista::statistics
