// SPDX-License-Identifier: MIT
#include "mind/world/negative_information.hpp"

#include <algorithm>
#include <cmath>

namespace regista::mind {
namespace {

constexpr double well_within_range = 0.8;  // share of the camera's range for the ball
constexpr double least_distance = 0.25;    // m: nearer than this the direction says little
constexpr double blocked_by = 0.3;         // m: half a robot, and as much again for not knowing where it stands
constexpr double known_to = 0.6;           // m: a vaguer estimate cannot be refuted by one look

// The ball would be seen at `ball` (robot frame, standard deviation `deviation`), were it there.
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

void NegativeInformation::look(std::span<const Estimate> balls, const Frame2& own, const Percepts& percepts,
                               double dt) {
  for (const Estimate& estimate : balls) {
    Source& source = sources_[static_cast<std::size_t>(estimate.source)];
    const regista_track& ball = *estimate.track;
    const bool news = ball.age < source.age;
    source.age = ball.age;
    if (news) source.in_vain = 0.0;
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
