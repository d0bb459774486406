// SPDX-License-Identifier: MIT
#include "mind/world/fusion.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include "mind/world/symmetric4.hpp"

namespace regista::mind {
namespace {

using Vector4 = Eigen::Vector4d;

// A covariance of exact knowledge would weigh infinitely; no estimate of a ball is better than a millimetre.
constexpr double least_variance = 1e-6;

// A ball that nobody watches may be kicked: the deviation of its place grows so fast on top of its model's. Half of a
// robot's walking speed pushes it about; a kick is ten times that, but rare. Assumption. m/s
constexpr double unwatched_speed = 0.3;

double position_trace(const regista_track& track) {
  return std::max(track.covariance[0] + track.covariance[2], 2.0 * least_variance);
}

// An estimate of the ball, with what its age adds to its uncertainty.
struct Weighed {
  const regista_track* track;
  double unwatched;    // variance of the position, per axis
  double information;  // weight over the trace of the position's covariance
};

Weighed weighed(const regista_track& ball) {
  const double deviation = unwatched_speed * ball.age;
  const double unwatched = deviation * deviation + least_variance;
  return {&ball, unwatched, ball.weight / (ball.covariance[0] + ball.covariance[2] + 2.0 * unwatched)};
}

Vector4 state(const regista_track& track) { return {track.x, track.y, track.vx, track.vy}; }

Symmetric4 covariance(const Weighed& ball) {
  Symmetric4 out = Symmetric4::from(ball.track->covariance, ball.track->motion);
  out.position.xx += ball.unwatched;
  out.position.yy += ball.unwatched;
  out.velocity.xx += least_variance;
  out.velocity.yy += least_variance;
  return out;
}

// Whether the positions agree: squared Mahalanobis distance under the sum of both covariances.
bool agree(const Weighed& a, const Weighed& b) {
  constexpr double gate = 9.21;  // chi-square, two degrees of freedom, 99 %
  const double unwatched = a.unwatched + b.unwatched;
  const double xx = a.track->covariance[0] + b.track->covariance[0] + unwatched;
  const double xy = a.track->covariance[1] + b.track->covariance[1];
  const double yy = a.track->covariance[2] + b.track->covariance[2] + unwatched;
  const double dx = a.track->x - b.track->x, dy = a.track->y - b.track->y;
  return yy * dx * dx - 2.0 * xy * dx * dy + xx * dy * dy <= gate * (xx * yy - xy * xy);
}

// Own eyes and packets: bits of a word.
constexpr std::size_t most_sources = 32;

// Unique over all sources for labels below 2^27.
std::int32_t label_of(const Estimate& estimate) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(estimate.track->label) << 5 |
                                   static_cast<std::uint32_t>(estimate.source));
}

}  // namespace

regista_ball fuse_ball(std::span<const Estimate> estimates) {
  std::array<Weighed, most_sources> balls;
  std::size_t count = 0, best = 0;
  for (const Estimate& estimate : estimates) {
    if (estimate.track->weight <= 0.0) continue;
    assert(count < balls.size());
    balls[count] = weighed(*estimate.track);
    if (balls[count].information > balls[best].information) best = count;
    ++count;
  }
  regista_ball ball{};
  if (count == 0) return ball;

  const Weighed chosen = balls[best];
  double age = chosen.track->age, information = 0.0;
  std::size_t agreeing = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i != best && !agree(chosen, balls[i])) continue;
    information += balls[i].information;
    age = std::min(age, balls[i].track->age);
    balls[agreeing++] = balls[i];
  }

  Vector4 mean = state(*chosen.track);
  Symmetric4 fused = covariance(chosen);
  if (agreeing > 1) {
    Symmetric4 inverse;
    Vector4 weighted = Vector4::Zero();
    for (const Weighed& each : std::span(balls.data(), agreeing)) {
      const double share = each.information / information;
      // What weighs next to nothing changes nothing, but costs an inversion.
      if (share < 1e-3) continue;
      const Symmetric4 information_matrix = covariance(each).inverse();
      inverse.add(share, information_matrix);
      weighted += share * (information_matrix * state(*each.track));
    }
    fused = inverse.inverse();
    mean = fused * weighted;
  }
  ball.flags = REGISTA_BALL_KNOWN;
  ball.position[0] = mean[0];
  ball.position[1] = mean[1];
  ball.velocity[0] = mean[2];
  ball.velocity[1] = mean[3];
  fused.write(ball.covariance);
  ball.age = age;
  return ball;
}

void OpponentFusion::fuse(std::span<const Estimate> estimates, std::vector<regista_opponent>& out, int without) {
  clusters_.clear();
  out.reserve(most_);
  for (const Estimate& estimate : estimates) {
    if (estimate.source == without) continue;
    const regista_track& track = *estimate.track;
    const Vector2d position(track.x, track.y);
    const std::uint32_t source = 1u << estimate.source;
    // Selected, not branched on: which one is nearest is anybody's guess.
    Cluster* nearest = nullptr;
    double nearest2 = merge_distance_ * merge_distance_;
    for (Cluster& cluster : clusters_) {
      const double d2 = (cluster.position - position).squaredNorm();
      // One source tells two tracks apart for a reason.
      const bool nearer = (d2 < nearest2) & ((cluster.sources & source) == 0);
      nearest = nearer ? &cluster : nearest;
      nearest2 = nearer ? d2 : nearest2;
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
    if (a.missing != b.missing) return a.missing < b.missing;
    return a.age != b.age ? a.age < b.age : a.label < b.label;
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
    opponent.covariance[0] = opponent.covariance[2] = variance;
    opponent.weight = std::clamp(1.0 - cluster.missing, 1e-3, 1.0);
    opponent.age = cluster.age;
  }
}

}  // namespace regista::mind
