// SPDX-License-Identifier: MIT
// Where to look: at the ball most of the time, about the field for landmarks and other robots the rest; to and fro
// while the ball is lost. The robots of a team look about at different moments.
#pragma once

#include <algorithm>
#include <cmath>

#include "situation.hpp"

namespace behaviours {

struct GazeSettings {
  double sweep_period = 4.0;         // s to and fro
  double glance_every = 4.0;         // s
  double glance_lasts = 1.2;         // s
  double eyes_on_ball_within = 0.8;  // m
  double phase_per_robot = 0.37;     // s
};

namespace detail {

// A wave of straight lines in [-1, 1], of period 1; 1 at whole phases plus a half, -1 at whole ones.
inline double triangle(double phase) { return 4.0 * std::abs(phase - std::floor(phase + 0.5)) - 1.0; }

}  // namespace detail

// Wanted heading of the camera, robot frame, as far as the head turns.
inline double look(const Situation& situation, const GazeSettings& settings) {
  const double limit = situation.facts.head_yaw;
  const double shifted = situation.time + settings.phase_per_robot * situation.facts.own_number;
  if (!situation.ball_trusted) return limit * detail::triangle(shifted / settings.sweep_period);
  const Vector2d ball = situation.frame.to_robot(situation.ball);
  const bool glance =
      std::fmod(shifted, settings.glance_every) < settings.glance_lasts && ball.norm() > settings.eyes_on_ball_within;
  if (glance) return limit * detail::triangle(std::fmod(shifted, settings.glance_every) / settings.glance_lasts);
  return std::clamp(angle_of(ball), -limit, limit);
}

}  // namespace behaviours
