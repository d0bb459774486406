// SPDX-License-Identifier: MIT
#include "mind/world/seen_teammates.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <cstdint>
#include <limits>

namespace regista::mind {
namespace {

constexpr double teammate_gate = 9.21;  // chi-square, two degrees of freedom, 99 %
constexpr double clearly_nearer = 4.0;  // the second best is so much less likely: exp(-4/2) = 0.14
constexpr double out_of_question = teammate_gate + clearly_nearer;
constexpr double never_fits = std::numeric_limits<double>::infinity();
constexpr double least_believed_weight = 0.5;  // a track that is less likely to be anybody at all says nothing

Eigen::Matrix2d place_covariance(const regista_robot& robot) {
  Eigen::Matrix2d out;
  out << robot.covariance[0], robot.covariance[1], robot.covariance[1], robot.covariance[2];
  return out;
}

Eigen::Matrix2d place_covariance(const regista_track& track) {
  Eigen::Matrix2d out;
  out << track.covariance[0], track.covariance[1], track.covariance[1], track.covariance[2];
  return out;
}

Eigen::Vector2d gap_between(const regista_robot& robot, const regista_track& track) {
  return {track.x - robot.pose[0], track.y - robot.pose[1]};
}

double misfit(const regista_robot& robot, const regista_track& track) {
  const Eigen::Vector2d apart = gap_between(robot, track);
  const Eigen::Matrix2d spread = place_covariance(robot) + place_covariance(track);
  // The trace is no less than the variance in any direction: most robots are too far away at a glance.
  if (apart.squaredNorm() > out_of_question * spread.trace() || spread.determinant() <= 0.0) return never_fits;
  return apart.dot(spread.inverse() * apart);
}

bool reckoned_with(const regista_robot& robot, int own) {
  return robot.number != own && (robot.flags & REGISTA_ROBOT_ACTIVE) != 0 && (robot.flags & REGISTA_ROBOT_KNOWN) != 0;
}

}  // namespace

void match_teammates(std::span<const regista_track> seen, std::span<const regista_robot> robots, int own,
                     std::vector<SeenTeammate>& out) {
  std::uint64_t taken = 0;  // bits of robots
  for (std::size_t count = 0; count < seen.size(); ++count) {
    // The pair that is least in doubt among those left.
    double best = teammate_gate;
    SeenTeammate pair{0, nullptr};
    for (const regista_track& track : seen) {
      if (track.weight < least_believed_weight) continue;
      bool used = false;
      for (const SeenTeammate& each : out) used = used || each.track == &track;
      if (used) continue;
      double nearest = never_fits, second = nearest;
      int number = 0;
      for (const regista_robot& robot : robots) {
        if (!reckoned_with(robot, own) || (taken >> robot.number & 1u) != 0) continue;
        const double d2 = misfit(robot, track);
        if (d2 < nearest) {
          second = nearest;
          nearest = d2;
          number = robot.number;
        } else if (d2 < second) {
          second = d2;
        }
      }
      if (nearest >= best || second < nearest + clearly_nearer) continue;
      best = nearest;
      pair = {number, &track};
    }
    if (pair.track == nullptr) return;
    taken |= std::uint64_t{1} << pair.number;
    out.push_back(pair);
  }
}

void sharpen(regista_robot& robot, const regista_track& seen) {
  const Eigen::Matrix2d before = place_covariance(robot), spread = before + place_covariance(seen);
  if (spread.determinant() <= 0.0) return;
  const Eigen::Matrix2d gain = before * spread.inverse();
  const Eigen::Vector2d moved = gain * gap_between(robot, seen);
  const Eigen::Matrix2d after = before - gain * before;
  robot.pose[0] += moved.x();
  robot.pose[1] += moved.y();
  robot.covariance[0] = after(0, 0);
  robot.covariance[1] = 0.5 * (after(0, 1) + after(1, 0));
  robot.covariance[2] = after(1, 1);
}

}  // namespace regista::mind
