// SPDX-License-Identifier: MIT
// Keeping the ball out of the own goal: stands between ball and goal at the place of its task, or comes out of the goal
// to cover the angle; goes for the line of a shot, and clears a ball that lies near, if it is there in time.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "../approach.hpp"
#include "../legal_place.hpp"
#include "../movement.hpp"
#include "../situation.hpp"

namespace keep_goal {

using behaviours::Blocker;
using behaviours::Movement;
using behaviours::Pose;
using behaviours::Situation;
using behaviours::Vector2d;

inline constexpr double never_leaves = 60.0;  // s: it leaves no ball to opponents

struct Settings {
  double beyond_area =
      0.2;  // m added to the length of the penalty area: how far from the goal's centre it plays the ball
  double near_ball = 1.0;     // m: it plays a ball that is nearer to it wherever that lies
  double slow = 0.5;          // m/s: it does not play a faster ball
  double shot_reach = 1.5;    // m that it leaves its place for the line of a shot
  double narrow_angle = 0.0;  // m from the goal line to which it comes out to cover the angle; 0: it keeps to its place
  double share = 0.4;         // of the way from the goal to the ball, as which it comes out
  double leave_lost_ball = never_leaves;  // s: it leaves a ball that an opponent reaches so much earlier
};

// Between the lines from the ball to both posts, in their middle: there one body covers most of the goal. As far out as
// the nearer ball asks for it. Nothing where it keeps to the place of its task.
inline std::optional<Pose> covering_place(const Situation& situation, const Settings& settings) {
  if (settings.narrow_angle <= 0.0 || !situation.ball_trusted) return std::nullopt;
  const behaviours::Field& field = situation.facts.field;
  const double line = -field.length / 2.0, half_goal = field.goal_width / 2.0;
  const Vector2d to_left = Vector2d(line, half_goal) - situation.ball;
  const Vector2d to_right = Vector2d(line, -half_goal) - situation.ball;
  if (to_left.x() > -0.1) return std::nullopt;  // on the goal line, or behind it
  const Vector2d middle = (to_left.normalized() + to_right.normalized()).normalized();
  const double whole = to_left.x() / middle.x();  // m along it to the goal line
  const double out = std::min(settings.narrow_angle, settings.share * whole);
  const Vector2d place = situation.ball + middle * (whole - out);
  return Pose{place.x(), place.y(), behaviours::angle_of(-middle)};
}

// An opponent reaches the ball too much earlier than the keeper.
inline bool comes_too_late(const Situation& situation, const Settings& settings, std::span<const Blocker> opponents) {
  if (settings.leave_lost_ball >= never_leaves) return false;
  constexpr double believed = 0.5;  // probability from which on an opponent counts
  const double own = behaviours::meeting(situation, situation.frame.origin()).time;
  return std::any_of(opponents.begin(), opponents.end(), [&](const Blocker& opponent) {
    return opponent.weight >= believed &&
           behaviours::meeting(situation, opponent.position).time + settings.leave_lost_ball < own;
  });
}

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
  const Pose place = covering_place(situation, settings).value_or(situation.target);
  return behaviours::WalkTo{.target = legal_place(situation, legal, place)};
}

}  // namespace keep_goal
