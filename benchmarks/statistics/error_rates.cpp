// SPDX-License-Identifier: MIT
// How often the sequential test of pairs errs, and how long it takes, by simulation: hypotheses of 0 and 20 normalised
// Elo, alpha = beta = 0.05, true strengths of 0, 10 and 20, with and without the overshoot correction, and with Wald's
// bounds looked at only after every tenth and every twenty-fifth pair.
//
//   error_rates [TESTS [SEED]]     default: 10000 tests of each kind, seed 1
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "statistics/rating.hpp"
#include "statistics/sequential_test.hpp"

namespace {

using namespace regista::statistics;
using Law = std::array<double, 5>;

double normalized_elo_of(const Law& law) {
  double mean = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < law.size(); ++i) {
    mean += law[i] * 0.25 * static_cast<double>(i);
    squares += law[i] * 0.0625 * static_cast<double>(i * i);
  }
  return normalized_elo_scale * (mean - 0.5) / std::sqrt(2.0 * (squares - mean * mean));
}

// 1 : 2 : 4 : 2 : 1, tilted until the first team is this much stronger.
Law law_of(double normalized) {
  double low = -2.0, high = 2.0;
  Law law{};
  for (int step = 0; step < 60; ++step) {
    const double tilt = (low + high) / 2.0;
    law = {1.0, 2.0, 4.0, 2.0, 1.0};
    double sum = 0.0;
    for (std::size_t i = 0; i < law.size(); ++i) sum += law[i] *= std::exp(tilt * static_cast<double>(i));
    for (double& each : law) each /= sum;
    (normalized_elo_of(law) < normalized ? low : high) = tilt;
  }
  return law;
}

PairOutcome drawn(const Law& law, std::mt19937_64& random) {
  double left = static_cast<double>(random() >> 11) * 0x1p-53;
  std::size_t outcome = 0;
  while (outcome < 4 && left >= law[outcome]) left -= law[outcome++];
  return static_cast<PairOutcome>(outcome);
}

constexpr SequentialDesign design{Model::normalized, {0.0, 20.0}, {0.05, 0.05}, true};

struct Ended {
  bool passed;
  std::int64_t pairs;
};

Ended after_every_pair(const Law& law, bool corrected, std::mt19937_64& random) {
  SequentialDesign chosen = design;
  chosen.overshoot_correction = corrected;
  SequentialTest test(chosen);
  while (test.verdict() == Verdict::inconclusive) test.add(drawn(law, random));
  return {test.verdict() == Verdict::accept_h1, total(test.counts())};
}

Ended after_every(int batch, const Law& law, std::mt19937_64& random) {
  const SequentialBounds bounds = sequential_bounds(design.rates);
  PairCounts counts;
  for (;;) {
    for (int i = 0; i < batch; ++i) counts.add(drawn(law, random));
    const Verdict verdict =
        verdict_on(log_likelihood_ratio(score_law(counts), design.model, design.hypotheses), bounds);
    if (verdict != Verdict::inconclusive) return {verdict == Verdict::accept_h1, total(counts)};
  }
}

void simulate(double truth, bool corrected, int batch, int tests, std::uint64_t seed) {
  const Law law = law_of(truth);
  std::mt19937_64 random(seed);
  int passed = 0;
  std::int64_t pairs = 0;
  for (int each = 0; each < tests; ++each) {
    const Ended test = batch == 1 ? after_every_pair(law, corrected, random) : after_every(batch, law, random);
    passed += test.passed ? 1 : 0;
    pairs += test.pairs;
  }
  const double rate = static_cast<double>(passed) / tests;
  std::printf("%4.0f  %-10s  %5d  %.4f +- %.4f  %7.1f\n", truth, corrected ? "corrected" : "Wald", batch, rate,
              1.96 * std::sqrt(rate * (1.0 - rate) / tests), static_cast<double>(pairs) / tests);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int tests = argc > 1 ? std::atoi(argv[1]) : 10000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  if (tests < 1) {
    std::fprintf(stderr, "error_rates [TESTS [SEED]]: a number of tests above 0 is wanted\n");
    return 2;
  }
  std::printf("true  bounds      every  passed             pairs\n");
  constexpr std::array truths{0.0, 10.0, 20.0};
  for (const double truth : truths) simulate(truth, true, 1, tests, seed);
  for (const int batch : {1, 10, 25}) {
    for (const double truth : truths) simulate(truth, false, batch, tests, seed);
  }
}
