// SPDX-License-Identifier: MIT
#include "mind/world/fusion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

namespace regista::mind {
namespace {

using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
using Vector4 = Eigen::Vector4d;

// A covariance of exact knowledge would weigh infinitely; no estimate of a ball is better than a millimetre.
constexpr double least_variance = 1e-6;

// A ball that nobody watches may be kicked: the deviation of its place grows so fast on top of its model's. Half of a
// robot's walking speed pushes it about; a kick is ten times that, but rare. Assumption. m/s
constexpr double unwatched_speed = 0.3;

double position_trace(const regista_track& track) {
  return std::max(track.covariance[0] + track.covariance[5], 2.0 * least_variance);
}

Vector4 state(const regista_track& track) { return {track.x, track.y, track.vx, track.vy}; }

double unwatched_variance(const regista_track& ball) {
  const double deviation = unwatched_speed * ball.age;
  return deviation * deviation + least_variance;
}

double ball_trace(const regista_track& ball) {
  return ball.covariance[0] + ball.covariance[5] + 2.0 * unwatched_variance(ball);
}

Matrix4 ball_covariance(const regista_track& ball) {
  Matrix4 out = Eigen::Map<const Matrix4>(ball.covariance);
  out.diagonal() +=
      Vector4(1.0, 1.0, 0.0, 0.0) * unwatched_variance(ball) + Vector4(0.0, 0.0, 1.0, 1.0) * least_variance;
  return out;
}

// Squared Mahalanobis distance of the positions, under the sum of both covariances.
double distance2(const regista_track& a, const regista_track& b) {
  const double unwatched = unwatched_variance(a) + unwatched_variance(b);
  const double xx = a.covariance[0] + b.covariance[0] + unwatched;
  const double xy = a.covariance[1] + b.covariance[1];
  const double yy = a.covariance[5] + b.covariance[5] + unwatched;
  const double dx = a.x - b.x, dy = a.y - b.y;
  return (yy * dx * dx - 2.0 * xy * dx * dy + xx * dy * dy) / (xx * yy - xy * xy);
}

// Unique over all sources (at most 32) for labels below 2^27.
std::int32_t label_of(const Estimate& estimate) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(estimate.track.label) << 5 |
                                   static_cast<std::uint32_t>(estimate.source));
}

constexpr double gate = 9.21;  // chi-square, two degrees of freedom, 99 %

}  // namespace

regista_ball fuse_ball(std::span<const Estimate> estimates) {
  regista_ball ball{};
  const regista_track* best = nullptr;
  double best_cost = std::numeric_limits<double>::infinity();
  for (const Estimate& estimate : estimates) {
    if (estimate.track.weight <= 0.0) continue;
    const double cost = ball_trace(estimate.track) / estimate.track.weight;
    if (cost < best_cost) {
      best_cost = cost;
      best = &estimate.track;
    }
  }
  if (best == nullptr) return ball;

  Vector4 mean = state(*best);
  Matrix4 fused = ball_covariance(*best);
  double age = best->age;
  double information = 0.0;
  int count = 0;
  for (const Estimate& estimate : estimates) {
    if (estimate.track.weight <= 0.0 || distance2(*best, estimate.track) > gate) continue;
    information += estimate.track.weight / ball_trace(estimate.track);
    age = std::min(age, estimate.track.age);
    ++count;
  }
  if (count > 1) {
    Matrix4 inverse = Matrix4::Zero();
    Vector4 weighted = Vector4::Zero();
    for (const Estimate& estimate : estimates) {
      if (estimate.track.weight <= 0.0 || distance2(*best, estimate.track) > gate) continue;
      const double share = estimate.track.weight / ball_trace(estimate.track) / information;
      // What weighs next to nothing changes nothing, but costs an inversion.
      if (share < 1e-3) continue;
      const Matrix4 information_matrix = ball_covariance(estimate.track).inverse() * share;
      inverse += information_matrix;
      weighted += information_matrix * state(estimate.track);
    }
    fused = inverse.inverse();
    mean = fused * weighted;
    fused = 0.5 * (fused + fused.transpose().eval());
  }
  ball.flags = REGISTA_BALL_KNOWN;
  ball.position[0] = mean[0];
  ball.position[1] = mean[1];
  ball.velocity[0] = mean[2];
  ball.velocity[1] = mean[3];
  Eigen::Map<Matrix4>(ball.covariance) = fused;
  ball.age = age;
  return ball;
}

void OpponentFusion::fuse(std::span<const Estimate> estimates, std::vector<regista_opponent>& out, int without) {
  clusters_.clear();
  clusters_.reserve(estimates.size());
  out.reserve(most_);
  for (const Estimate& estimate : estimates) {
    if (estimate.source == without) continue;
    const regista_track& track = estimate.track;
    const Vector2d position(track.x, track.y);
    const std::uint32_t source = 1u << estimate.source;
    Cluster* nearest = nullptr;
    double nearest2 = merge_distance_ * merge_distance_;
    for (Cluster& cluster : clusters_) {
      // One source tells two tracks apart for a reason.
      if ((cluster.sources & source) != 0) continue;
      const double d2 = (cluster.position - position).squaredNorm();
      if (d2 < nearest2) {
        nearest2 = d2;
        nearest = &cluster;
      }
    }
    const double trace = position_trace(track);
    if (nearest == nullptr) {
      nearest = &clusters_.emplace_back();
      nearest->weighted_sum = Vector2d::Zero();
      nearest->age = track.age;
      nearest->best_trace = std::numeric_limits<double>::infinity();
    }
    // With isotropic covariances, Niehsen's weights are proportional to 1/trace, and the fused mean is the mean of the
    // positions weighted by 1/trace^2.
    const double information = 1.0 / trace;
    nearest->weighted_sum += information * information * position;
    nearest->information += information;
    nearest->information2 += information * information;
    nearest->position = nearest->weighted_sum / nearest->information2;
    nearest->missing *= 1.0 - track.weight;
    nearest->age = std::min(nearest->age, track.age);
    nearest->sources |= source;
    if (trace < nearest->best_trace) {
      nearest->best_trace = trace;
      nearest->velocity = {track.vx, track.vy};
      nearest->label = label_of(estimate);
    }
  }
  std::sort(clusters_.begin(), clusters_.end(), [](const Cluster& a, const Cluster& b) {
    return a.missing != b.missing ? a.missing < b.missing : a.label < b.label;
  });
  if (clusters_.size() > most_) clusters_.resize(most_);

  out.clear();
  for (const Cluster& cluster : clusters_) {
    regista_opponent& opponent = out.emplace_back();
    opponent = {};
    opponent.label = cluster.label;
    opponent.position[0] = cluster.position.x();
    opponent.position[1] = cluster.position.y();
    opponent.velocity[0] = cluster.velocity.x();
    opponent.velocity[1] = cluster.velocity.y();
    // Trace of the intersection: sum(w_i / t_i)^-1 with w_i = (1/t_i) / sum(1/t).
    const double variance = 0.5 * cluster.information / cluster.information2;
    opponent.covariance[0] = opponent.covariance[3] = variance;
    opponent.weight = std::clamp(1.0 - cluster.missing, 1e-3, 1.0);
    opponent.age = cluster.age;
  }
}

}  // namespace regista::mind
