// SPDX-License-Identifier: MIT
#include "study/tuning/stochastic_search.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <numeric>

namespace regista::study {
namespace {

constexpr double alpha = 0.602, gamma = 0.101;  // exponents of the gains of SPSA

constexpr double first_deviation = 0.25;  // standard deviation of first coordinates, in sides of the cube

// Constants of the strategy: weights of the better half of a generation, best first, and rates that follow from them.
struct Constants {
  Constants(std::size_t dimensions, std::uint64_t population) {
    const auto n = static_cast<double>(dimensions);
    const auto parents = static_cast<Eigen::Index>(std::max<std::uint64_t>(population / 2, 1));
    weights.resize(parents);
    for (Eigen::Index i = 0; i < parents; ++i) {
      weights[i] = std::log(static_cast<double>(population + 1) / 2.0) - std::log(static_cast<double>(i + 1));
    }
    weights = (weights.array() > 0.0).select(weights, 1e-12).eval();
    weights /= weights.sum();
    effective = 1.0 / weights.squaredNorm();
    path_rate = (effective + 2.0) / (n + effective + 5.0);
    damping = 1.0 + 2.0 * std::max(0.0, std::sqrt((effective - 1.0) / (n + 1.0)) - 1.0) + path_rate;
    rank_one_path_rate = (4.0 + effective / n) / (n + 4.0 + 2.0 * effective / n);
    // A diagonal matrix has n numbers to learn instead of n^2. So the rates are larger by the factor (n + 2) / 3.
    const double faster = (n + 2.0) / 3.0;
    rank_one_rate = std::min(1.0, faster * 2.0 / ((n + 1.3) * (n + 1.3) + effective));
    rank_mu_rate = std::min(1.0 - rank_one_rate,
                            faster * 2.0 * (effective - 2.0 + 1.0 / effective) / ((n + 2.0) * (n + 2.0) + effective));
    rank_mu_rate = std::max(rank_mu_rate, 0.0);
    normal_length = std::sqrt(n) * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n));
  }

  Eigen::VectorXd weights;
  double effective;  // effective number of parents
  double path_rate, damping, rank_one_path_rate, rank_one_rate, rank_mu_rate;
  double normal_length;  // expected length of a standard normal vector
};

}  // namespace

SpsaGains spsa_gains(std::uint64_t iterations) {
  constexpr double c_end = 0.1, travel = 3.0, most = 0.5;  // `most` limits r_end if there are few iterations
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
  // The new square joins largest_. If largest_ is too long, its least square moves to squares_. Nothing is subtracted
  // from squares_, because subtracting an outlier would destroy the sum's precision.
  largest_.push_back(difference * difference);
  std::push_heap(largest_.begin(), largest_.end(), std::greater<>());
  if (largest_.size() > 1 + (largest_.size() + others_) / 20) {
    std::pop_heap(largest_.begin(), largest_.end(), std::greater<>());
    squares_ += largest_.back();
    largest_.pop_back();
    ++others_;
  }
  double scale = std::sqrt(squares_ / static_cast<double>(std::max<std::size_t>(others_, 1)));
  // The scale is 0 after the first difference, and while all differences except the largest twentieth are 0. The
  // largest difference then is the scale.
  if (scale == 0.0) scale = std::sqrt(*std::max_element(largest_.begin(), largest_.end()));
  return scale == 0.0 ? 0.0 : std::clamp(difference / scale, -most, most);
}

SearchResult spsa(const SearchSettings& settings, Evaluator& inquiry, const SpsaGains& gains) {
  const std::uint64_t iterations = inquiry.left() / 2;
  assert(iterations > 0);
  const SpsaSchedule schedule(gains, iterations);
  Rng draws(settings.seed, Rng::Use::spsa);
  RunningScale scale;
  Point theta = settings.start, flip(theta.size());
  std::vector<Point> estimates;
  std::array<Point, 2> points;
  for (std::uint64_t k = 0; k < iterations; ++k) {
    const double c = std::min(schedule.c(k), 0.5), r = schedule.r(k);
    for (double& each : flip) each = draws.sign();
    // Both points stay in the cube, c apart from their middle, so that the difference still measures a slope.
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

std::uint64_t least_sep_cma_es_population(std::size_t dimensions) {
  return 4 + static_cast<std::uint64_t>(3.0 * std::log(static_cast<double>(dimensions)));
}

std::uint64_t sep_cma_es_population(std::size_t dimensions, std::uint64_t evaluations) {
  const auto root = static_cast<std::uint64_t>(2.0 * std::sqrt(static_cast<double>(evaluations)));
  const std::uint64_t wanted = std::max(root, least_sep_cma_es_population(dimensions));
  const std::uint64_t generations = std::max<std::uint64_t>(evaluations / wanted, 1);
  return std::max<std::uint64_t>(evaluations / generations, 2);  // uses nearly the whole budget
}

SearchResult sep_cma_es(const SearchSettings& settings, Evaluator& inquiry) {
  const auto dimensions = static_cast<std::size_t>(settings.start.size());
  const std::uint64_t population = settings.population != 0 ? std::max<std::uint64_t>(settings.population, 2)
                                                            : sep_cma_es_population(dimensions, inquiry.left());
  const std::uint64_t generations = inquiry.left() / population;
  assert(generations > 0);
  const Constants rates(dimensions, population);
  Rng draws(settings.seed, Rng::Use::sep_cma_es);

  Point mean = settings.start;
  double sigma = first_deviation;
  Eigen::ArrayXd variance = Eigen::ArrayXd::Ones(mean.size());
  Eigen::ArrayXd path = Eigen::ArrayXd::Zero(mean.size()), rank_one_path = path;
  std::vector<Point> points(population, mean), means;
  std::vector<std::size_t> order(population);
  for (std::uint64_t generation = 0; generation < generations; ++generation) {
    const Eigen::ArrayXd deviation = sigma * variance.sqrt();
    for (Point& point : points) {
      for (Eigen::Index i = 0; i < mean.size(); ++i) {
        point[i] = std::clamp(mean[i] + deviation[i] * draws.normal(), 0.0, 1.0);
      }
    }
    const std::span<const double> values = inquiry.ask(points, generation);
    if (values.empty()) break;
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });

    Eigen::ArrayXd step = Eigen::ArrayXd::Zero(mean.size()), spread = step;  // in units of sigma
    for (Eigen::Index i = 0; i < rates.weights.size(); ++i) {
      const Eigen::ArrayXd each = (points[order[static_cast<std::size_t>(i)]] - mean).array() / sigma;
      step += rates.weights[i] * each;
      spread += rates.weights[i] * each.square();
    }
    mean = (mean + sigma * step.matrix()).cwiseMax(0.0).cwiseMin(1.0);
    path = (1.0 - rates.path_rate) * path +
           std::sqrt(rates.path_rate * (2.0 - rates.path_rate) * rates.effective) * step / variance.sqrt();
    const double length = path.matrix().norm() / rates.normal_length;
    const double settled = 1.0 - std::pow(1.0 - rates.path_rate, 2.0 * static_cast<double>(generation + 1));
    const auto n = static_cast<double>(dimensions);
    const bool steady = length / std::sqrt(settled) < 1.4 + 2.0 / (n + 1.0);
    rank_one_path *= 1.0 - rates.rank_one_path_rate;
    if (steady) {
      rank_one_path += std::sqrt(rates.rank_one_path_rate * (2.0 - rates.rank_one_path_rate) * rates.effective) * step;
    }
    const double kept =
        1.0 - rates.rank_one_rate - rates.rank_mu_rate +
        (steady ? 0.0 : rates.rank_one_rate * rates.rank_one_path_rate * (2.0 - rates.rank_one_path_rate));
    variance = kept * variance + rates.rank_one_rate * rank_one_path.square() + rates.rank_mu_rate * spread;
    sigma *= std::exp(std::min(1.0, rates.path_rate / rates.damping * (length - 1.0)));
    // Steps must neither vanish in rounding nor exceed the cube.
    variance = variance.max(1e-12).min(1e12);
    sigma = std::clamp(sigma, 1e-9, 0.5);
    means.push_back(mean);
  }
  if (means.empty()) return {{settings.start}, inquiry.ended()};
  const std::array<Point, 4> estimates{mean, mean_of_last(means, 4), mean_of_last(means, 2), settings.start};
  return {distinct(estimates, most_recommended), inquiry.ended()};
}

}  // namespace regista::study
