// SPDX-License-Identifier: MIT
#include "statistics/likelihood_ratio.hpp"

#include <cassert>
#include <cmath>
#include <optional>

#include "statistics/constrained_law.hpp"
#include "statistics/rating.hpp"

namespace regista::statistics {
namespace {

std::optional<Probabilities> most_likely(const ScoreLaw& law, Model model, double elo) {
  if (model == Model::logistic) return most_likely_with_mean(law, score_of_elo(elo));
  const double games_per_unit = law.unit == Unit::pair ? 2.0 : 1.0;
  return most_likely_with_effect(law, std::sqrt(games_per_unit) * elo / normalized_elo_scale);
}

// The classic approximation of the ratio for hypotheses about a mean; the fallback of the logistic model.
double logistic_closed_form(const ScoreLaw& law, Hypotheses hypotheses) {
  const double mean0 = score_of_elo(hypotheses.elo0), mean1 = score_of_elo(hypotheses.elo1);
  return law.units * (mean1 - mean0) * (2.0 * law.mean - mean0 - mean1) / (2.0 * law.variance);
}

}  // namespace

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

}  // namespace regista::statistics
