// SPDX-License-Identifier: MIT
#include "study/tuning/spsa.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>

#include "study/tuning/draws.hpp"

namespace regista::study {
namespace {

constexpr double alpha = 0.602, gamma = 0.101;

}  // namespace

SpsaGains spsa_gains(std::uint64_t iterations) {
  constexpr double c_end = 0.1, travel = 3.0, most = 0.5;  // `most`: for a handful of iterations
  return {c_end, std::min(most, travel / (c_end * static_cast<double>(iterations)))};
}

double spsa_perturbation(double c, std::uint64_t k) { return c / std::pow(static_cast<double>(k) + 1.0, gamma); }

SpsaSchedule::SpsaSchedule(const SpsaGains& gains, std::uint64_t iterations) {
  const auto number = static_cast<double>(iterations);
  stability_ = 0.1 * number;
  first_c_ = gains.c_end * std::pow(number, gamma);
  a_ = gains.r_end * gains.c_end * gains.c_end * std::pow(stability_ + number, alpha);
}

double SpsaSchedule::c(std::uint64_t k) const { return spsa_perturbation(first_c_, k); }

double SpsaSchedule::r(std::uint64_t k) const {
  const double perturbation = c(k);
  return a_ / std::pow(stability_ + static_cast<double>(k) + 1.0, alpha) / (perturbation * perturbation);
}

double RunningScale::scaled(double difference) {
  // A square joins the largest and pushes the least of them out to the others: nothing is ever taken from the sum,
  // which an outlier would have emptied of all digits.
  largest_.push_back(difference * difference);
  std::push_heap(largest_.begin(), largest_.end(), std::greater<>());
  if (largest_.size() > 1 + (largest_.size() + others_) / 20) {
    std::pop_heap(largest_.begin(), largest_.end(), std::greater<>());
    squares_ += largest_.back();
    largest_.pop_back();
    ++others_;
  }
  double scale = std::sqrt(squares_ / static_cast<double>(std::max<std::size_t>(others_, 1)));
  // Few differences so far, or hardly any that is not zero.
  if (scale == 0.0) scale = std::sqrt(*std::max_element(largest_.begin(), largest_.end()));
  return scale == 0.0 ? 0.0 : std::clamp(difference / scale, -most, most);
}

SearchResult spsa(const SearchSettings& settings, Inquiry& inquiry, const SpsaGains& gains) {
  const std::uint64_t iterations = inquiry.left() / 2;
  assert(iterations > 0);
  const SpsaSchedule schedule(gains, iterations);
  Draws draws(settings.seed, Draws::Use::spsa);
  RunningScale scale;
  Point theta = settings.start, flip(theta.size());
  std::vector<Point> estimates;
  std::array<Point, 2> points;
  for (std::uint64_t k = 0; k < iterations; ++k) {
    const double c = std::min(schedule.c(k), 0.5), r = schedule.r(k);
    for (double& each : flip) each = draws.sign();
    // Both points stay in the cube and c apart from their middle, so that the difference stays one of slopes.
    const Point middle = theta.cwiseMax(c).cwiseMin(1.0 - c);
    points[0] = (middle + c * flip).cwiseMax(0.0).cwiseMin(1.0);
    points[1] = (middle - c * flip).cwiseMax(0.0).cwiseMin(1.0);
    const std::span<const double> values = inquiry.ask(points, k);
    if (values.empty()) break;
    const double result = scale.scaled(values[0] - values[1]);
    for (Eigen::Index i = 0; i < theta.size(); ++i) {
      theta[i] = std::clamp(spsa_step(theta[i], r, c, result, flip[i]), 0.0, 1.0);
    }
    estimates.push_back(theta);
  }
  if (estimates.empty()) return {{settings.start}, inquiry.ended()};
  const std::array<Point, 4> best{theta, mean_of_last(estimates, 2), mean_of_last(estimates, 4), settings.start};
  return {distinct(best, most_recommended), inquiry.ended()};
}

}  // namespace regista::study
