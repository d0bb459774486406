// SPDX-License-Identifier: MIT
// Going to where a rolling ball comes along: the nearest point of its way.
#pragma once

#include <optional>

#include "movement.hpp"
#include "rolling_ball.hpp"
#include "situation.hpp"

namespace behaviours {

// Nothing when the ball is lost, lies, leaves, or passes too far away. `reach`: how far to go at most, m.
inline std::optional<Vector2d> interception(const Situation& situation, const RollingSettings& settings, double reach) {
  const double speed = situation.ball_velocity.norm();
  if (!situation.ball_trusted || speed < settings.rolling) return std::nullopt;
  const Vector2d own = situation.frame.origin();
  const Vector2d end = situation.ball + situation.ball_velocity * (rolling_distance(situation) / speed);
  const Vector2d point = nearest_on_segment(situation.ball, end, own);
  if ((point - own).norm() > reach || (point - situation.ball).dot(situation.ball_velocity) <= 0.0) return std::nullopt;
  return point;
}

// At full speed to that point, facing the ball.
inline WalkTo intercept(const Situation& situation, const Vector2d& point) {
  const double heading = angle_of(situation.ball - situation.frame.origin());
  return {.target = {point.x(), point.y(), heading}, .brisk = true};
}

}  // namespace behaviours
