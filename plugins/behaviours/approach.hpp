// SPDX-License-Identifier: MIT
// How to get behind the ball and kick: around the ball to the side away from where it shall go, then onto it, then the
// kick.
#pragma once

#include <algorithm>
#include <cmath>

#include "kick_choice.hpp"
#include "movement.hpp"
#include "rolling_ball.hpp"
#include "situation.hpp"

namespace behaviours {

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

}  // namespace behaviours
