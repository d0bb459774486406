// SPDX-License-Identifier: MIT
// Where a sequential probability ratio test stops: A. Wald, "Sequential Tests of Statistical Hypotheses", Annals of
// Mathematical Statistics 16, 1945: ln(beta / (1 - alpha)) and ln((1 - beta) / alpha), +-2.944439 at 0.05 each.
#pragma once

#include <cassert>
#include <cmath>

namespace regista::statistics {

// Precondition: each in (0, 1), their sum below 1 (else the bounds change places).
struct ErrorRates {
  double alpha = 0.05;  // of accepting H1 though H0 holds
  double beta = 0.05;   // of accepting H0 though H1 holds
};

struct SequentialBounds {
  double lower, upper;  // of the log-likelihood ratio, nats: H0 at or below lower, H1 at or above upper
};

inline SequentialBounds sequential_bounds(ErrorRates rates) {
  assert(rates.alpha > 0.0 && rates.beta > 0.0 && rates.alpha + rates.beta < 1.0);
  return {std::log(rates.beta / (1.0 - rates.alpha)), std::log((1.0 - rates.beta) / rates.alpha)};
}

enum class Verdict { inconclusive, accept_h0, accept_h1 };

}  // namespace regista::statistics
