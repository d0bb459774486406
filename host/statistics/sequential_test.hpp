// SPDX-License-Identifier: MIT
// The generalised sequential probability ratio test. Callers add outcomes one by one. M. Van den Bergh, "The
// generalized sequential probability ratio test", 2019, and "Normalized Elo", 2021.
#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "statistics/counts.hpp"

namespace regista::statistics {

// --- The most likely distribution of scores q under a hypothesis. The hypothesis fixes the mean score or the effect
// size (mean - 1/2) / sd. Of all distributions on the same scores that agree with the hypothesis, q makes the counts
// most probable: q = p / (1 + theta phi), where theta satisfies the constraint (Van den Bergh 2019, section 3). For the
// mean, q is the empirical likelihood of A. Owen, "Empirical Likelihood", 2001, chapter 2.

using Probabilities = std::array<double, 5>;  // only the first law.outcomes elements are used

// Returns the most likely distribution q (see above) with the mean score `mean`, in (0, 1): phi = score - mean. Returns
// nothing only if rounding leaves no room between `mean` and 0 or 1.
std::optional<Probabilities> most_likely_with_mean(const ScoreLaw& law, double mean);

// Returns the most likely distribution q (see above) with (mean - 1/2) / sd = `effect`, any finite number. This
// constraint is not linear. Up to ten rounds linearise the constraint around the q of the previous round, the first
// round around the uniform distribution: phi = score - 1/2 - effect sd (1 + ((score - mean) / sd)^2) / 2. Returns
// nothing if a round has no solution, for example for effects far larger than these scores allow.
std::optional<Probabilities> most_likely_with_effect(const ScoreLaw& law, double effect);

// --- The log-likelihood ratio in nats: how much more probable the counts are under the most likely distribution of H1
// (the first team is elo1 stronger) than under the most likely distribution of H0 (elo0 stronger).

enum class Model {
  logistic,    // elo0, elo1 are Elo: hypotheses about the mean score
  normalized,  // elo0, elo1 are normalised Elo: hypotheses about the mean in standard deviations of one game
};

inline const char* name(Model model) { return model == Model::logistic ? "logistic" : "normalized"; }

// Precondition: elo0 and elo1 are finite, and elo0 < elo1. The ratio is accurate for Elo within +-4000.
struct Hypotheses {
  double elo0, elo1;
};

enum class Method {
  exact,        // the most likely distributions of H0 and H1 were found
  closed_form,  // a most likely distribution was not found; the value is an approximation
};

struct LogLikelihoodRatio {
  double value;  // nats, finite; a positive value supports H1
  Method method;
};

LogLikelihoodRatio log_likelihood_ratio(const ScoreLaw& law, Model model, Hypotheses hypotheses);

// Returns the limit of the normalised ratio for many units and small effects: N ln[(1 + (n-n0)^2) / (1 + (n-n1)^2)] for
// N pairs, half of this for N games, with n = normalised Elo / 347.44. log_likelihood_ratio() uses this limit if it
// does not find a most likely distribution.
double normalized_closed_form(const ScoreLaw& law, Hypotheses hypotheses);

// --- The bounds at which the test stops: ln(beta / (1 - alpha)) and ln((1 - beta) / alpha), +-2.944439 at 0.05 each.
// A. Wald, "Sequential Tests of Statistical Hypotheses", Annals of Mathematical Statistics 16, 1945.

// Precondition: each rate is in (0, 1), their sum is below 1. Otherwise the lower bound would exceed the upper bound.
struct ErrorRates {
  double alpha = 0.05;  // probability of accepting H1 if H0 is true
  double beta = 0.05;   // probability of accepting H0 if H1 is true
};

struct SequentialBounds {
  double lower, upper;  // for the log-likelihood ratio, nats: accept H0 at or below lower, H1 at or above upper
};

inline SequentialBounds sequential_bounds(ErrorRates rates) {
  assert(rates.alpha > 0.0 && rates.beta > 0.0 && rates.alpha + rates.beta < 1.0);
  return {std::log(rates.beta / (1.0 - rates.alpha)), std::log((1.0 - rates.beta) / rates.alpha)};
}

enum class Verdict { inconclusive, accept_h0, accept_h1 };

// Estimates by how much a log-likelihood ratio on average exceeds a bound when it passes the bound. Wald's bounds
// assume that the ratio stops exactly on a bound. A test that stops earlier by this mean excess keeps its error rates
// with fewer games. The estimate uses the new extremes of the ratio: D. Siegmund, "Sequential Analysis", 1985,
// corollary 8.33: sum d^2 / (2 sum d), where d is the step from one extreme to the next.
class Overshoot {
 public:
  // The caller must pass every value of the ratio in order. The ratio starts at 0.
  void update(double ratio) {
    if (ratio < lowest_) {
      below_.add(lowest_ - ratio);
      lowest_ = ratio;
    }
    if (ratio > highest_) {
      above_.add(ratio - highest_);
      highest_ = ratio;
    }
  }

  double below() const { return below_.mean_excess(); }  // excess at the lower bound; 0 before the first extreme
  double above() const { return above_.mean_excess(); }  // excess at the upper bound

 private:
  struct Steps {
    double sum = 0.0, of_squares = 0.0;

    void add(double step) {
      sum += step;
      of_squares += step * step;
    }
    double mean_excess() const { return sum > 0.0 ? of_squares / (2.0 * sum) : 0.0; }
  };
  double lowest_ = 0.0, highest_ = 0.0;
  Steps below_, above_;
};

struct SequentialDesign {
  Model model = Model::normalized;
  Hypotheses hypotheses;
  ErrorRates rates;
  bool overshoot_correction = true;  // the test stops at lower + below() and upper - above()
};

// The caller must add outcomes in the order of the schedule and not in the order in which matches end. Otherwise slow
// matches bias the test. With this order the test stops at the same outcome for any number of workers.
class SequentialTest {
 public:
  explicit SequentialTest(const SequentialDesign& design)
      : design_(design), wald_(sequential_bounds(design.rates)), stopping_(wald_) {}

  // Adds the next outcome. After a verdict the test ignores all outcomes, and its values stay unchanged.
  Verdict add(PairOutcome outcome);

  Verdict verdict() const { return verdict_; }
  const PairCounts& counts() const { return counts_; }
  LogLikelihoodRatio ratio() const { return ratio_; }      // 0 before the first outcome
  SequentialBounds bounds() const { return wald_; }        // Wald's bounds, which reports show
  SequentialBounds stopping() const { return stopping_; }  // corrected bounds after the last outcome
  const SequentialDesign& design() const { return design_; }

 private:
  SequentialDesign design_;
  SequentialBounds wald_, stopping_;
  PairCounts counts_;
  LogLikelihoodRatio ratio_{0.0, Method::exact};
  Overshoot overshoot_;
  Verdict verdict_ = Verdict::inconclusive;
};

Verdict verdict_on(LogLikelihoodRatio ratio, SequentialBounds bounds);

}  // namespace regista::statistics
