// SPDX-License-Identifier: MIT
// The mixture sequential probability ratio test on the mean of values, against a mean of 0: valid however often one
// looks. H. Robbins, "Statistical Methods Related to the Law of the Iterated Logarithm", Annals of Mathematical
// Statistics 41, 1970; R. Johari et al., "Always Valid Inference", Operations Research 70, 2022.
//
// It supposes normal values of known variance. With a variance estimated from the same values it holds for many of them
// only; for bounded values, such as goal differences under a mercy rule, betting.hpp holds for any number.
#pragma once

#include <cstdint>

namespace regista::statistics {

// n values with this mean; variance of one value; mixing variance tau^2 > 0: the size, squared, of the means that the
// test is to find soonest. Units: that of the values, and its square.
struct MixtureSample {
  std::int64_t values;
  double mean, variance, mixing_variance;
};

// ln Lambda = ln sqrt(s2 / (s2 + n tau2)) + n^2 tau2 mean^2 / (2 s2 (s2 + n tau2)); reject a mean of 0 at level alpha
// as soon as it is ln(1/alpha) or more. 0, no information, without values or variance.
double mixture_log_ratio(const MixtureSample& sample);

// min(1, 1/Lambda), valid at this moment; the smallest so far is valid at all times.
double mixture_p(const MixtureSample& sample);

// The true mean is within mean +- this at all times together with probability 1 - alpha, in (0, 1). Infinite without
// values or variance.
double mixture_half_width(const MixtureSample& sample, double alpha);

}  // namespace regista::statistics
