// SPDX-License-Identifier: MIT
#include "match/metrics_world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "match/metrics.hpp"

namespace regista::match {

Ospa::Ospa(double cutoff, std::size_t most) : cutoff_(cutoff) {
  cost_.reserve(most * most);
  assignment_.reserve(most, most);
}

OspaParts Ospa::operator()(std::span<const Vector> a, std::span<const Vector> b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.empty()) return {};
  cost_.clear();
  for (const Vector& one : a) {
    for (const Vector& other : b) cost_.push_back(std::min(cutoff_, length(one - other)));
  }
  const auto count = static_cast<double>(b.size());
  return {assignment_.solve(cost_, a.size(), b.size()) / count,
          cutoff_ * static_cast<double>(b.size() - a.size()) / count};
}

// Quantile 0.95 of the chi-square law with two degrees of freedom: -2 ln 0.05.
constexpr double chi_square_95 = 5.991464547107981;

WorldMeasures::WorldMeasures(int team_size) : ospa_(ospa_cutoff, at(team_size)) {}

void WorldMeasures::looked(int number, bool sees_ball) {
  const std::uint32_t robot = 1u << (number - 1);
  sees_ball_ = sees_ball ? sees_ball_ | robot : sees_ball_ & ~robot;
}

void WorldMeasures::Errors::add(const Estimate& estimate, Vector truth) {
  ++asked;
  if (!estimate.known) return;
  ++known;
  const Vector error = estimate.at - truth;
  squared += squared_length(error);
  const double determinant = estimate.xx * estimate.yy - estimate.xy * estimate.xy;
  if (!(estimate.xx > 0.0 && determinant > 0.0)) return;
  const double normal =
      (estimate.yy * error.x * error.x - 2.0 * estimate.xy * error.x * error.y + estimate.xx * error.y * error.y) /
      determinant;
  ++with_covariance;
  normalised += normal;
  if (normal <= chi_square_95) ++covered;
}

EstimateMetrics WorldMeasures::Errors::result() const {
  EstimateMetrics out{mean(known, asked), mean(squared, known), mean(normalised, with_covariance),
                      mean(covered, with_covariance)};
  if (out.rmse_metres) out.rmse_metres = std::sqrt(*out.rmse_metres);
  return out;
}

void WorldMeasures::sample(std::uint32_t active) {
  ++samples_;
  if ((sees_ball_ & active) != 0) ++seen_;
}

void WorldMeasures::compare(int number, const Belief& belief, const Truth& truth) {
  ball_.add(belief.ball, truth.ball);
  for (const int i : Members(truth.active)) {
    if (i == number - 1) {
      self_.add(belief.self, truth.own[at(i)]);
    } else {
      teammates_.add(belief.teammates[at(i)], truth.own[at(i)]);
    }
  }
  const OspaParts parts = ospa_(belief.opponents, truth.opponents);
  ++compared_;
  listed_ += static_cast<int>(belief.opponents.size());
  location_ += parts.location;
  cardinality_ += parts.cardinality;
}

WorldModelMetrics WorldMeasures::result() const {
  return {.ball = ball_.result(),
          .self = self_.result(),
          .teammates = teammates_.result(),
          .ospa_metres = mean(location_ + cardinality_, compared_),
          .ospa_location_metres = mean(location_, compared_),
          .ospa_cardinality_metres = mean(cardinality_, compared_),
          .opponents_listed = mean(listed_, compared_),
          .ball_seen_share = mean(seen_, samples_)};
}

}  // namespace regista::match
