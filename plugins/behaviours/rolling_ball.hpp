// SPDX-License-Identifier: MIT
// The ball that rolls: from which speed on it is met where it will be, how far it rolls by itself, and where somebody
// meets it first.
#pragma once

#include <algorithm>
#include <cmath>

#include "situation.hpp"

namespace behaviours {

struct RollingSettings {
  double rolling = 0.25;  // m/s: slower balls are walked to, not met
};

inline double rolling_distance(const Situation& situation) {
  return situation.ball_velocity.squaredNorm() / (2.0 * situation.facts.ball_deceleration);
}

// Where and when somebody who walks at full speed is at the ball first, if nobody else touches it.
struct Meeting {
  Vector2d place{0, 0};
  double time = 0.0;  // s from now
};

// `from`: the centre of who walks. It is there when its body touches the ball. At the latest where the ball comes to
// rest.
inline Meeting meeting(const Situation& situation, const Vector2d& from) {
  const Facts& facts = situation.facts;
  const double touching = facts.robot_radius + facts.ball_radius;
  const auto walk_time = [&](const Vector2d& place) {
    return std::max(0.0, (place - from).norm() - touching) / facts.walk_forward;
  };
  const double speed = situation.ball_velocity.norm(), slows = facts.ball_deceleration;
  constexpr double resting = 0.05, step = 0.2;  // m/s, s
  if (speed < resting) return {situation.ball, walk_time(situation.ball)};
  const Vector2d ahead = situation.ball_velocity / speed;
  const double stops = speed / slows, rolls = rolling_distance(situation);
  const auto place_at = [&](double time) {
    return Vector2d(situation.ball + ahead * (time * (speed - 0.5 * slows * time)));
  };
  const auto met = [&](double time) { return walk_time(place_at(time)) <= time; };
  // It may come by so fast that it is out of reach again before the next step: around then, in small steps.
  const double along = std::clamp((from - situation.ball).dot(ahead), 0.0, rolls);
  const double passes = (speed - std::sqrt(std::max(0.0, speed * speed - 2.0 * slows * along))) / slows;
  double passing = passes;
  while (passing < passes + step && !met(passing)) passing += 0.25 * step;
  if (passing >= passes + step) passing = stops;
  for (double time = 0.0; time < stops; time += step) {
    if (passing <= time) break;
    if (met(time)) return {place_at(time), time};
  }
  if (passing < stops) return {place_at(passing), passing};
  const Vector2d rest = situation.ball + ahead * rolls;
  return {rest, std::max(stops, walk_time(rest))};
}

}  // namespace behaviours
