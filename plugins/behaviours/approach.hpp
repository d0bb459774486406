// SPDX-License-Identifier: MIT
// How to get behind the ball and kick: around the ball to the side away from where it shall go, then onto it, then the
// kick.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "kick_choice.hpp"
#include "movement.hpp"
#include "situation.hpp"

namespace behaviours {

// --- The ball that rolls: from which speed on it is met where it will be, how far it rolls by itself, and where
// somebody meets it first.

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

struct ApproachSettings {
  double meet_within = 2.0;    // s: a rolling ball is met no later than this
  double behind = 0.8;         // cosine of the angle between the ways to the ball and of the kick: behind the ball
  double aligned = 0.30;       // rad between heading and kick that still gives a clean one
  double stand_off = 0.5;      // share of (distance of touching the ball + reach) at which it stands behind the ball
  double berth = 0.15;         // m beyond touching that it keeps from the ball on its way around it
  double step_back = 0.15;     // m farther than the stand-off that it aims at on its way around the ball
  double creep_within = 0.12;  // m from the stand-off in which it creeps onto the ball
  double creep_aligned = 2.0;  // times `aligned`: farther turned away it does not creep
  double creep_speed = 0.12;   // m/s
};

// `kick`: what shall become of the ball.
inline Movement approach(const Situation& situation, const ApproachSettings& settings, const RollingSettings& rolling,
                         const KickPlan& kick) {
  if (kick.kind == KickPlan::no_kind) return Stand{};
  const Facts& facts = situation.facts;
  const Vector2d own = situation.frame.origin();
  const double touching = facts.robot_radius + facts.ball_radius;  // from centre to centre
  const double stand_off = settings.stand_off * (touching + facts.reach);
  const double direction = angle_of(kick.direction);

  // A rolling ball is met where it will be.
  Vector2d ball = situation.ball;
  const double speed = situation.ball_velocity.norm();
  if (speed > rolling.rolling) {
    const double arrival = std::min(settings.meet_within, (ball - own).norm() / facts.walk_forward);
    const double rolled = std::min(speed * arrival, rolling_distance(situation));
    ball += situation.ball_velocity * (rolled / speed);
  }
  const Vector2d to_ball = situation.ball - own;
  const double distance = to_ball.norm();
  const double turn = wrap(direction - situation.pose.heading);
  const bool behind = distance > 1e-6 && to_ball.dot(kick.direction) > settings.behind * distance;
  if (distance < facts.reach && behind && std::abs(turn) < settings.aligned && situation.sees_ball) {
    return KickBall{kick.kind, turn, kick.distance, kick.receiver};
  }

  WalkTo walk;
  const double off = behind ? stand_off : stand_off + settings.step_back;
  const Vector2d stand = ball - kick.direction * off;
  walk.target = {stand.x(), stand.y(), direction};
  // The ball is in its own way until the robot is behind it.
  if (!behind) walk.around = Disc{ball, touching + settings.berth};
  // From behind, creep onto the ball: pushing it on is better than stopping short of it.
  const bool creeps = behind && distance < stand_off + settings.creep_within &&
                      std::abs(turn) < settings.creep_aligned * settings.aligned;
  if (creeps) {
    const Vector2d ahead = situation.frame.direction_to_robot(to_ball.normalized());
    walk.creep = Vector2d(settings.creep_speed * ahead.x(), settings.creep_speed * ahead.y());
  }
  return walk;
}

// --- Going to where a rolling ball comes along: the nearest point of its way.

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
