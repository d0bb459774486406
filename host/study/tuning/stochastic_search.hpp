// SPDX-License-Identifier: MIT
// Our own two search algorithms for noisy values: SPSA and a separable CMA-ES.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "study/tuning/evaluator.hpp"

namespace regista::study {

// --- Simultaneous perturbation stochastic approximation: J. C. Spall, "Multivariate Stochastic Approximation Using a
// Simultaneous Perturbation Gradient Approximation", IEEE Transactions on Automatic Control 37(3), 1992. Gains: J. C.
// Spall, "Implementation of the Simultaneous Perturbation Algorithm for Stochastic Optimization", IEEE Transactions on
// Aerospace and Electronic Systems 34(3), 1998. The gains of the last iteration define all gains.

// The gains of the last iteration, in the form that testers of chess engines use.
struct SpsaGains {
  double c_end;  // distance of each of the two points from the estimate, per dimension; side of the cube: 1
  double r_end;  // step of the estimate for a result of 1, in units of c
};

// Good gains, measured on noisy spheres (benchmarks/tuning) with 50 to 10000 iterations. r_end is such that results of
// 1 in all iterations would move the estimate by about five sides of the cube. Half this r_end is as good if noise is
// small. Twice this r_end is better in eight dimensions if noise is as large as the largest possible gain. c_end is a
// tenth of the side. A larger c_end is better on spheres (equal slopes on both sides), but worse on other objectives.
SpsaGains spsa_gains(std::uint64_t iterations);

// The gains of iteration k, from 0 to `iterations` - 1.
class SpsaSchedule {
 public:
  SpsaSchedule(const SpsaGains& gains, std::uint64_t iterations);

  double c(std::uint64_t k) const;  // c / (k + 1)^0.101
  double r(std::uint64_t k) const;  // a / (A + k + 1)^0.602 / c(k)^2, with A a tenth of the iterations

 private:
  double first_c_, a_, stability_;
};

// The perturbation of iteration k, from 0: c / (k + 1)^0.101. c: the perturbation of iteration 0.
double spsa_perturbation(double c, std::uint64_t k);

// The new coordinate of the estimate. flip: 1 or -1. result: scaled f(theta + c flip) - f(theta - c flip).
constexpr double spsa_step(double theta, double r, double c, double result, double flip) {
  return theta + r * c * result * flip;
}

// Scales differences of values, of any size and with outliers, to a size of about 1. Divides each difference by the
// root mean square of all differences so far except the largest twentieth, and limits the quotient to +-`most`.
class RunningScale {
 public:
  static constexpr double most = 3.0;
  double scaled(double difference);  // counts `difference` as one of the differences so far

 private:
  std::vector<double> largest_;  // largest squares, as a heap with the least of them first
  double squares_ = 0.0;         // sum of the other squares
  std::size_t others_ = 0;
};

// Runs SPSA. The two points of an iteration are one question, with its own set of pairs. If a point would leave the
// cube, the middle of the points moves to the distance c from the surface. Precondition: two evaluations or more.
// Recommends, in this order: last estimate, mean of the second half of the estimates, mean of the last quarter, start.
SearchResult spsa(const SearchSettings& settings, Evaluator& inquiry, const SpsaGains& gains);

// --- Evolution strategy with a diagonal covariance matrix: R. Ros and N. Hansen, "A Simple Modification in CMA-ES
// Achieving Linear Time and Space Complexity", PPSN 2008; constants of N. Hansen, "The CMA Evolution Strategy: A
// Tutorial", 2016. Against noise, the strategy uses a large population instead of repeated evaluations.

// The population that the publications use without noise, for n dimensions: 4 + 3 ln n, rounded down.
std::uint64_t least_sep_cma_es_population(std::size_t dimensions);

// The population for noisy values. Population and number of generations grow with the square root of the budget.
std::uint64_t sep_cma_es_population(std::size_t dimensions, std::uint64_t evaluations);

// Runs the strategy. The points of a generation form one Question and play the same new set of pairs. A point outside
// the cube moves to the cube's surface, and counts as if it had been drawn there. Recommends, in this order: the last
// mean, the mean over the last quarter of the generations, the mean over the last half, and the start.
SearchResult sep_cma_es(const SearchSettings& settings, Evaluator& inquiry);

}  // namespace regista::study
