// SPDX-License-Identifier: MIT
#include "statistics/sequential_test.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "statistics/rating.hpp"

namespace regista::statistics {
namespace {

constexpr int most_steps_of_law = 10;
constexpr double settled_law = 1e-9;  // a smaller change of all probabilities ends the rounds

using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

// Finds the root theta of sum p phi / (1 + theta phi). This sum falls with theta between its poles. At the root all q
// sum to 1, so each q is at most 1 and each 1 + theta phi >= p. This bounds the root and keeps it away from the poles.
std::optional<double> multiplier(const ScoreLaw& law, const Probabilities& phi) {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < law.outcomes; ++i) {
    const double bound = (law.probabilities[i] - 1.0) / phi[i];
    if (phi[i] > 0.0) low = std::max(low, bound);
    if (phi[i] < 0.0) high = std::min(high, bound);
  }
  if (!std::isfinite(low) || !std::isfinite(high)) return std::nullopt;  // phi has only one sign, or is NaN
  const auto slope = [&](double theta) {
    double sum = 0.0;
    for (std::size_t i = 0; i < law.outcomes; ++i) sum += law.probabilities[i] * phi[i] / (1.0 + theta * phi[i]);
    return sum;
  };
  const double at_low = slope(low), at_high = slope(high);
  // If rounding hides the change of sign of the slope, an end of the interval is the root.
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

std::optional<Probabilities> most_likely(const ScoreLaw& law, Model model, double elo) {
  if (model == Model::logistic) return most_likely_with_mean(law, score_of_elo(elo));
  const double games_per_unit = law.unit == Unit::pair ? 2.0 : 1.0;
  return most_likely_with_effect(law, std::sqrt(games_per_unit) * elo / normalized_elo_scale);
}

// Approximates the ratio in the logistic model by the classic formula, if a most likely distribution was not found.
double logistic_closed_form(const ScoreLaw& law, Hypotheses hypotheses) {
  const double mean0 = score_of_elo(hypotheses.elo0), mean1 = score_of_elo(hypotheses.elo1);
  return law.units * (mean1 - mean0) * (2.0 * law.mean - mean0 - mean1) / (2.0 * law.variance);
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

double normalized_closed_form(const ScoreLaw& law, Hypotheses hypotheses) {
  const double n = normalized_elo(law).value / normalized_elo_scale;
  const double from0 = n - hypotheses.elo0 / normalized_elo_scale, from1 = n - hypotheses.elo1 / normalized_elo_scale;
  const double per_game = 0.5 * std::log((1.0 + from0 * from0) / (1.0 + from1 * from1));
  return law.units * (law.unit == Unit::pair ? 2.0 : 1.0) * per_game;
}

LogLikelihoodRatio log_likelihood_ratio(const ScoreLaw& law, Model model, Hypotheses hypotheses) {
  assert(std::isfinite(hypotheses.elo0) && std::isfinite(hypotheses.elo1) && hypotheses.elo0 < hypotheses.elo1);
  const std::optional<Probabilities> under0 = most_likely(law, model, hypotheses.elo0);
  const std::optional<Probabilities> under1 = most_likely(law, model, hypotheses.elo1);
  if (under0 && under1) {
    double sum = 0.0;
    for (std::size_t i = 0; i < law.outcomes; ++i) {
      sum += law.probabilities[i] * std::log((*under1)[i] / (*under0)[i]);
    }
    if (std::isfinite(sum)) return {law.units * sum, Method::exact};
  }
  return {model == Model::logistic ? logistic_closed_form(law, hypotheses) : normalized_closed_form(law, hypotheses),
          Method::closed_form};
}

Verdict verdict_on(LogLikelihoodRatio ratio, SequentialBounds bounds) {
  if (ratio.value >= bounds.upper) return Verdict::accept_h1;
  if (ratio.value <= bounds.lower) return Verdict::accept_h0;
  return Verdict::inconclusive;
}

Verdict SequentialTest::add(PairOutcome outcome) {
  if (verdict_ != Verdict::inconclusive) return verdict_;
  counts_.add(outcome);
  ratio_ = log_likelihood_ratio(score_law(counts_), design_.model, design_.hypotheses);
  overshoot_.update(ratio_.value);
  if (design_.overshoot_correction) {
    stopping_ = {wald_.lower + overshoot_.below(), wald_.upper - overshoot_.above()};
  }
  verdict_ = verdict_on(ratio_, stopping_);
  return verdict_;
}

}  // namespace regista::statistics
