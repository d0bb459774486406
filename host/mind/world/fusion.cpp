// SPDX-License-Identifier: MIT
#include "mind/world/fusion.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "plugin/predictor.hpp"

namespace regista::mind {
namespace {

// Largest number of sources: own camera, each robot's packets.
constexpr std::size_t most_sources = 32;

// Two tracks that are closer together than this distance (m) count as one object (B-Human: 1.1 m).
constexpr double one_object = 1.1;
constexpr double gate = 9.21;               // 99 % quantile of the chi-square law, two degrees of freedom
constexpr double least_kept_weight = 0.05;  // tracks of lower weight are dropped

// Returns the squared Mahalanobis distance of the positions for the sum of the covariances.
double squared_mahalanobis(const regista_track& a, const regista_track& b) {
  const double xx = a.covariance[0] + b.covariance[0], xy = a.covariance[1] + b.covariance[1];
  const double yy = a.covariance[2] + b.covariance[2], dx = a.x - b.x, dy = a.y - b.y;
  const double determinant = xx * yy - xy * xy;
  return determinant > 0.0 ? (yy * dx * dx - 2.0 * xy * dx * dy + xx * dy * dy) / determinant : gate + 1.0;
}

bool nearer_than(const regista_track& a, const regista_track& b, double distance) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy <= distance * distance;
}

bool may_have_looked_at(const SenderView& sender, const regista_track& track) {
  const Vector2d arm(track.x - sender.pose.x, track.y - sender.pose.y);
  return arm.squaredNorm() <= sender.range * sender.range &&
         std::abs(wrap(angle_of(arm) - sender.pose.heading)) <= sender.half_angle;
}

// Returns the new weight of a known track that a packet of the sender does not contain.
double weight_untold(const regista_track& track, const SenderView& sender) {
  if (!sender.tells_all) return track.weight;
  if (track.age < sender.tells_up_to) return 0.0;  // the sender no longer believes in this young track
  if (!may_have_looked_at(sender, track)) return track.weight;
  return track.weight * (1.0 - sender.probability) / (1.0 - track.weight * sender.probability);
}

constexpr double clearly_nearer = 4.0;  // squared distance; a match farther by 4 is exp(-4/2) = 0.14 times as likely
constexpr double out_of_question = gate + clearly_nearer;
constexpr double never_fits = std::numeric_limits<double>::infinity();
constexpr double least_believed_weight = 0.5;  // tracks of lower weight are not matched
constexpr double matched_for = 5.0;            // s; assumption

// Written out, because the small matrices of Eigen would be stored in halves and loaded whole, which stalls.
double misfit(const regista_robot& robot, const regista_track& track) {
  const double dx = track.x - robot.pose[0], dy = track.y - robot.pose[1];
  const double xx = robot.covariance[0] + track.covariance[0], xy = robot.covariance[1] + track.covariance[1],
               yy = robot.covariance[2] + track.covariance[2], determinant = xx * yy - xy * xy;
  // This quick test excludes most robots: the trace is at least as great as the variance in any direction.
  if (dx * dx + dy * dy > out_of_question * (xx + yy) || determinant <= 0.0) return never_fits;
  const double inverse = 1.0 / determinant, ixx = yy * inverse, ixy = -xy * inverse, iyy = xx * inverse;
  return dx * (ixx * dx + ixy * dy) + dy * (ixy * dx + iyy * dy);
}

bool reckoned_with(const regista_robot& robot, int own) {
  return robot.number != own && (robot.flags & REGISTA_ROBOT_ACTIVE) != 0 && (robot.flags & REGISTA_ROBOT_KNOWN) != 0;
}

using Vector4 = Eigen::Vector4d;

// Least variance of an estimate (m^2, a deviation of 1 mm), so that exact knowledge gets no infinite weight.
constexpr double least_variance = 1e-6;

// While nobody sees the ball, robots may move the ball. So the position's deviation grows at this speed (m/s), added to
// the model's growth. Assumption: half a walking speed (a push of the ball); kicks are ten times faster, but rare.
constexpr double unwatched_speed = 0.3;

double position_trace(const regista_track& track) {
  return std::max(track.covariance[0] + track.covariance[2], 2.0 * least_variance);
}

struct Weighed {  // An estimate of the ball, and the uncertainty that its age adds.
  const regista_track* track;
  double unwatched;    // variance of the position due to age, for each axis
  double information;  // weight / trace of the position's covariance
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

// Whether the squared Mahalanobis distance of the positions, for the sum of the covariances, is within the gate.
bool agree(const Weighed& a, const Weighed& b) {
  const double unwatched = a.unwatched + b.unwatched;
  const double xx = a.track->covariance[0] + b.track->covariance[0] + unwatched;
  const double xy = a.track->covariance[1] + b.track->covariance[1];
  const double yy = a.track->covariance[2] + b.track->covariance[2] + unwatched;
  const double dx = a.track->x - b.track->x, dy = a.track->y - b.track->y;
  return yy * dx * dx - 2.0 * xy * dx * dy + xx * dy * dy <= gate * (xx * yy - xy * xy);
}

constexpr double furthest_pair = 2.0;  // m; two estimates of one opponent are nearer
constexpr double near_place = 1.0;     // m; an opponent is where it is believed to be, for all purposes of play

constexpr double well_within_range = 0.8;  // share of the camera's range for balls
constexpr double least_distance = 0.25;    // m; the direction of a nearer ball is uncertain
constexpr double blocked_by = 0.3;         // m; half of a robot's width, and the same length for its uncertain position
constexpr double known_to = 0.6;           // m; an estimate with a larger deviation is not refuted

// Returns whether the camera has a clear view of a ball at `ball` (robot frame, m). deviation: standard deviation, m.
bool in_clear_view(const Vector2d& ball, double deviation, const Percepts& percepts) {
  const double distance = ball.norm();
  if (distance < least_distance || distance > well_within_range * percepts.view.ball_range) return false;
  const double margin = deviation / distance;
  const double off_axis = std::abs(wrap(angle_of(ball) - percepts.view.heading));
  if (off_axis > percepts.view.half_angle - margin) return false;
  for (const RobotSighting& robot : percepts.robots) {
    if (robot.position.squaredNorm() > distance * distance) continue;
    const double along = robot.position.dot(ball) / distance;
    const double across = std::abs(robot.position.x() * ball.y() - robot.position.y() * ball.x()) / distance;
    if (along > 0.0 && across < blocked_by) return false;
  }
  return true;
}

}  // namespace

void merge_told(std::span<const regista_track> known, std::span<const regista_track> told, const SenderView& sender,
                std::vector<regista_track>& out) {
  out.assign(told.begin(), told.end());
  // Pairs known and received tracks. The pair of least distance comes first. Each track is in at most one pair.
  std::int32_t fresh = 0;
  for (const regista_track& each : known) fresh = std::max(fresh, each.label);
  std::uint64_t continued = 0, continuing = 0;  // one bit for each track; a predictor has at most 64 tracks
  const auto has = [](std::uint64_t bits, std::size_t i) { return (bits >> i & 1u) != 0; };
  const std::size_t known_count = std::min<std::size_t>(known.size(), 64),
                    told_count = std::min<std::size_t>(told.size(), 64);
  for (;;) {
    double least = gate;
    std::optional<std::pair<std::size_t, std::size_t>> pair;
    for (std::size_t i = 0; i < known_count; ++i) {
      for (std::size_t j = 0; j < told_count; ++j) {
        if (has(continued, i) || has(continuing, j)) continue;
        const double d2 = squared_mahalanobis(known[i], told[j]);
        if (d2 > least || (d2 == least && pair)) continue;
        least = d2;
        pair = {i, j};
      }
    }
    if (!pair) break;
    continued |= std::uint64_t{1} << pair->first;
    continuing |= std::uint64_t{1} << pair->second;
    out[pair->second].label = known[pair->first].label;
  }
  for (std::size_t j = 0; j < told_count; ++j) {
    if (!has(continuing, j)) out[j].label = ++fresh;
  }
  for (std::size_t i = 0; i < known_count; ++i) {
    if (has(continued, i)) continue;
    if (std::ranges::any_of(told, [&](const regista_track& each) { return nearer_than(each, known[i], one_object); }))
      continue;
    const double weight = weight_untold(known[i], sender);
    if (weight < least_kept_weight) continue;
    out.push_back(known[i]);
    out.back().weight = weight;
  }
}

void match_teammates(std::span<const regista_track> seen, std::span<const regista_robot> robots, int own,
                     std::vector<SeenTeammate>& out) {
  struct Fit {  // a track's robots of least misfit that are not taken
    double nearest, second;
    int number, second_number;
  };
  constexpr Fit none{never_fits, never_fits, 0, 0};
  std::uint64_t taken = 0;  // one bit for each robot
  const auto fit_of = [&](const regista_track& track) {
    Fit fit = none;
    for (const regista_robot& robot : robots) {
      if (!reckoned_with(robot, own) || (taken >> robot.number & 1u) != 0) continue;
      const double d2 = misfit(robot, track);
      if (d2 < fit.nearest) {
        fit = {d2, fit.nearest, robot.number, fit.number};
      } else if (d2 < fit.second) {
        fit.second = d2;
        fit.second_number = robot.number;
      }
    }
    return fit;
  };
  std::array<Fit, plugin::Predictor::track_capacity> fits;
  assert(seen.size() <= fits.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const bool believed = seen[i].weight >= least_believed_weight && seen[i].age <= matched_for;
    fits[i] = believed ? fit_of(seen[i]) : none;
  }
  for (;;) {
    // Takes the best pair of the remaining tracks and robots.
    double best = gate;
    std::size_t chosen = seen.size();
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (fits[i].nearest >= best || fits[i].second < fits[i].nearest + clearly_nearer) continue;
      best = fits[i].nearest;
      chosen = i;
    }
    if (chosen == seen.size()) return;
    const int number = fits[chosen].number;
    out.push_back({number, &seen[chosen]});
    fits[chosen] = none;
    taken |= std::uint64_t{1} << number;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (fits[i].number == number || fits[i].second_number == number) fits[i] = fit_of(seen[i]);
    }
  }
}

void sharpen(regista_robot& robot, const regista_track& seen) {
  const auto place_covariance = [](const auto& estimate) {
    const double xy = estimate.covariance[1];
    return Eigen::Matrix2d{{estimate.covariance[0], xy}, {xy, estimate.covariance[2]}};
  };
  const Eigen::Matrix2d before = place_covariance(robot), spread = before + place_covariance(seen);
  if (spread.determinant() <= 0.0) return;
  const Eigen::Matrix2d gain = before * spread.inverse();
  const Eigen::Vector2d moved = gain * Vector2d(seen.x - robot.pose[0], seen.y - robot.pose[1]);
  const Eigen::Matrix2d after = before - gain * before;
  robot.pose[0] += moved.x();
  robot.pose[1] += moved.y();
  robot.covariance[0] = after(0, 0);
  robot.covariance[1] = 0.5 * (after(0, 1) + after(1, 0));
  robot.covariance[2] = after(1, 1);
}

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
      // An estimate of tiny weight is left out, because the estimate changes little and its inversion costs time.
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

void OpponentFusion::Cluster::add(const regista_track& track, int from) {
  // Niehsen's weights of isotropic covariances are proportional to 1/trace; those of the fused mean, to 1/trace^2.
  const double own_trace = position_trace(track), added = 1.0 / own_trace, added2 = added * added;
  weighted_sum += added2 * Vector2d(track.x, track.y);
  information += added;
  information2 += added2;
  const double share = 1.0 / information2;
  position = share * weighted_sum;
  // The covariance intersection has the trace sum(w_i / t_i)^-1 with w_i = (1/t_i) / sum(1/t).
  trace = share * information;
  missing *= 1.0 - track.weight;
  likelihood = -1.0;
  age = std::min(age, track.age);
  source = from;
  if (own_trace < best_trace) {
    best_trace = own_trace;
    best = &track;
    source_of_best = from;
  }
}

std::int32_t OpponentFusion::Cluster::label() const {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(best->label) << 5 |
                                   static_cast<std::uint32_t>(source_of_best));
}

// Each cluster is compared with all tracks, not each track with all clusters, so that the processor need not wait for
// one comparison before it begins the next.
void OpponentFusion::add(std::span<const regista_track> tracks, int source) {
  constexpr double none = std::numeric_limits<double>::infinity();
  struct Seen {
    double x, y, trace;
    double distance;  // squared Mahalanobis, to the nearest cluster without a track of this source; none: too far
    Cluster* nearest;
  };
  std::array<Seen, plugin::Predictor::track_capacity> room;
  assert(tracks.size() <= room.size());
  const std::span seen(room.data(), tracks.size());
  for (std::size_t i = 0; i < seen.size(); ++i)
    seen[i] = {tracks[i].x, tracks[i].y, position_trace(tracks[i]), none, nullptr};
  const auto compare = [](Seen& one, Cluster& cluster) {
    const double dx = cluster.position.x() - one.x, dy = cluster.position.y() - one.y, squared = dx * dx + dy * dy;
    if (squared > furthest_pair * furthest_pair) return;
    const double distance = squared / (0.5 * (one.trace + cluster.trace));
    if (distance > gate || distance >= one.distance) return;
    one.distance = distance;
    one.nearest = &cluster;
  };
  for (Cluster& cluster : clusters_) {
    for (Seen& one : seen) compare(one, cluster);
  }
  std::uint64_t placed = 0;  // one bit for each track
  for (;;) {
    // The track of least distance, without a branch, which would be mispredicted.
    double least = none;
    std::size_t i = seen.size();
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const bool less = seen[k].distance < least;
      least = less ? seen[k].distance : least;
      i = less ? k : i;
    }
    if (i == seen.size()) break;
    seen[i].distance = none;
    if (seen[i].nearest->source == source) {  // a nearer track of this source has taken the cluster
      for (Cluster& cluster : clusters_) {
        if (cluster.source != source) compare(seen[i], cluster);
      }
      continue;
    }
    seen[i].nearest->add(tracks[i], source);
    placed |= std::uint64_t{1} << i;
  }
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if ((placed >> i & 1u) == 0) clusters_.emplace_back(tracks[i], source);
  }
}

void OpponentFusion::write(std::size_t most, std::vector<regista_opponent>& out) {
  for (Cluster& each : clusters_) {
    if (each.likelihood >= 0.0) continue;
    each.likelihood = (1.0 - each.missing) * -std::expm1(-near_place * near_place / each.trace);
  }
  const auto comes_first = [](const Cluster* a, const Cluster* b) {
    if (a->likelihood != b->likelihood) return a->likelihood > b->likelihood;
    return a->age != b->age ? a->age < b->age : a->label() < b->label();
  };
  order_.clear();
  for (const Cluster& each : clusters_) order_.push_back(&each);
  std::ranges::sort(order_, comes_first);
  out.clear();
  for (const Cluster* const cluster : std::span(order_).first(std::min(most, order_.size()))) {
    regista_opponent& opponent = out.emplace_back();
    opponent = {};
    opponent.label = cluster->label();
    opponent.position[0] = cluster->position.x();
    opponent.position[1] = cluster->position.y();
    opponent.velocity[0] = cluster->best->vx;
    opponent.velocity[1] = cluster->best->vy;
    opponent.covariance[0] = opponent.covariance[2] = 0.5 * cluster->trace;
    opponent.weight = std::clamp(1.0 - cluster->missing, 1e-3, 1.0);
    opponent.age = cluster->age;
  }
}

void NegativeInformation::look(std::span<const Estimate> balls, const Frame2& own, const Percepts& percepts,
                               double dt) {
  for (const Estimate& estimate : balls) {
    Source& source = sources_[static_cast<std::size_t>(estimate.source)];
    const regista_track& ball = *estimate.track;
    if (ball.age < source.age) source.in_vain = 0.0;
    source.age = ball.age;
    const double deviation = std::sqrt(0.5 * (ball.covariance[0] + ball.covariance[2]));
    if (!percepts.camera || deviation > known_to) continue;
    const Vector2d expected = own.to_robot({ball.x, ball.y});
    if (!in_clear_view(expected, deviation, percepts)) continue;
    const bool seen = std::ranges::any_of(percepts.balls, [&](const BallSighting& sighting) {
      return (sighting.position - expected).norm() < 0.3 + 2.0 * deviation + 2.0 * sighting.along;
    });
    source.in_vain = seen ? 0.0 : source.in_vain + dt;
  }
}

}  // namespace regista::mind
