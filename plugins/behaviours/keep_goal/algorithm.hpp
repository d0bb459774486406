// SPDX-License-Identifier: MIT
// Keeping the ball out of the own goal: stands between ball and goal at the place of its task, goes for the line of a
// shot, and clears a ball that lies near.
#pragma once

#include "../interception.hpp"
#include "../legal_place.hpp"
#include "../movement.hpp"
#include "../situation.hpp"

namespace keep_goal {

using behaviours::Movement;
using behaviours::Situation;
using behaviours::Vector2d;

struct Settings {
  double beyond_area =
      0.2;  // m added to the length of the penalty area: how far from the goal's centre it plays the ball
  double near_ball = 1.0;   // m: it plays a ball that is nearer to it wherever that lies
  double slow = 0.5;        // m/s: it does not play a faster ball
  double shot_reach = 1.5;  // m that it leaves its place for the line of a shot
};

// The ball lies so near to the goal, or to the robot, that the keeper should play it.
inline bool plays_ball(const Situation& situation, const Settings& settings) {
  if (!situation.ball_trusted || ball_is_theirs(situation)) return false;
  const behaviours::Field& field = situation.facts.field;
  const Vector2d goal(-field.length / 2.0, 0.0);
  const bool near = (situation.ball - goal).norm() < field.penalty_area_length + settings.beyond_area ||
                    (situation.ball - situation.frame.origin()).norm() < settings.near_ball;
  return near && situation.ball_velocity.norm() < settings.slow;
}

// When it does not play the ball.
inline Movement guard(const Situation& situation, const Settings& settings, const behaviours::RollingSettings& rolling,
                      const behaviours::LegalPlaceSettings& legal) {
  if (situation.ball_velocity.x() < 0.0 && !ball_is_theirs(situation)) {
    if (const auto point = interception(situation, rolling, settings.shot_reach)) {
      behaviours::WalkTo walk = intercept(situation, *point);
      walk.straight = true;
      return walk;
    }
  }
  return behaviours::WalkTo{.target = legal_place(situation, legal, situation.target)};
}

}  // namespace keep_goal
