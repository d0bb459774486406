// SPDX-License-Identifier: MIT
// Simultaneous perturbation stochastic approximation: J. C. Spall, "Multivariate Stochastic Approximation Using a
// Simultaneous Perturbation Gradient Approximation", IEEE Transactions on Automatic Control 37(3), 1992; the gains as
// in "Implementation of the Simultaneous Perturbation Algorithm for Stochastic Optimization", IEEE Transactions on
// Aerospace and Electronic Systems 34(3), 1998, given by their last values, as testers of chess engines give them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "study/tuning/inquiry.hpp"

namespace regista::study {

// What a tester chooses, for the last iteration.
struct SpsaGains {
  double c_end;  // how far both points lie from the estimate, in each dimension, in sides of the cube
  double r_end;  // how far the estimate follows a result of 1, in c
};

// Measured on noisy spheres (benchmarks/tuning) with 50 to 10000 iterations: r_end falls with their number, so that
// results of 1 that all agree would carry the estimate some five times across the cube. Half of it is as good where
// noise is small, twice as much better where noise is as large as what there is to win in eight dimensions. c_end: a
// tenth of the range; more is better yet on a sphere, whose slopes are the same on both sides, and worse where they are
// not.
SpsaGains spsa_gains(std::uint64_t iterations);

// Gains of each iteration k = 0, 1, ... of `iterations`.
class SpsaSchedule {
 public:
  SpsaSchedule(const SpsaGains& gains, std::uint64_t iterations);

  double c(std::uint64_t k) const;  // c / (k + 1)^0.101
  double r(std::uint64_t k) const;  // a / (A + k + 1)^0.602 / c(k)^2, with A a tenth of the iterations

 private:
  double first_c_, a_, stability_;
};

// c / (k + 1)^gamma with gamma = 0.101: c is the perturbation of iteration 0, k counts from 0.
double spsa_perturbation(double c, std::uint64_t k);

// Where a coordinate goes after a result (what the point at theta + c flip gained over the one at theta - c flip; wins
// less losses for those who count them).
constexpr double spsa_step(double theta, double r, double c, double result, double flip) {
  return theta + r * c * result * flip;
}

// Makes differences of values, of any scale and with outliers, into results of a size about 1: divides by the root mean
// square of those so far without the largest twentieth, and lets none count for more than `most`.
class RunningScale {
 public:
  // The result; the difference itself is among those so far.
  double scaled(double difference);

  static constexpr double most = 3.0;

 private:
  std::vector<double> largest_;  // squares, a heap whose first is the least
  double squares_ = 0.0;         // sum of the others
  std::size_t others_ = 0;
};

// Both points of an iteration are one question with a set of pairs of its own. Where the perturbation would leave the
// cube, the place that is perturbed is moved inside by c. Two evaluations or more. Recommends the last estimate, then
// the mean of the estimates of the second half, then that of the last quarter, then the start.
SearchResult spsa(const SearchSettings& settings, Inquiry& inquiry, const SpsaGains& gains);

}  // namespace regista::study
