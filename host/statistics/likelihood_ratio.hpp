// SPDX-License-Identifier: MIT
// The log-likelihood ratio of the generalised sequential probability ratio test: how much more probable the counts are
// under the most likely law of H1 (the first team is elo1 stronger) than under that of H0 (elo0), in nats.
// M. Van den Bergh, "The generalized sequential probability ratio test", 2019, and "Normalized Elo", 2021.
#pragma once

#include "statistics/score_law.hpp"

namespace regista::statistics {

enum class Model {
  logistic,    // elo0, elo1 are Elo: hypotheses about the mean score
  normalized,  // elo0, elo1 are normalised Elo: hypotheses about the mean in standard deviations of one game
};

inline const char* name(Model model) { return model == Model::logistic ? "logistic" : "normalized"; }

// Precondition wherever it is taken: both finite, elo0 < elo1. Elo within +-4000 keeps the accuracy.
struct Hypotheses {
  double elo0, elo1;
};

enum class Method {
  exact,        // both constrained laws were found
  closed_form,  // they were not; see normalized_closed_form
};

struct LogLikelihoodRatio {
  double value;  // nats, finite; positive speaks for H1
  Method method;
};

LogLikelihoodRatio log_likelihood_ratio(const ScoreLaw& law, Model model, Hypotheses hypotheses);

// What the normalised ratio comes to for many units and small effects: N ln[(1 + (n-n0)^2) / (1 + (n-n1)^2)] for N
// pairs, half of it for N games, n = normalised Elo / 347.44. The fallback where the most likely law cannot be found.
double normalized_closed_form(const ScoreLaw& law, Hypotheses hypotheses);

}  // namespace regista::statistics
