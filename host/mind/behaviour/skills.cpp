// SPDX-License-Identifier: MIT
#include "mind/behaviour/skills.hpp"

#include <algorithm>
#include <cmath>

#include "mind/behaviour/edge_path.hpp"
#include "mind/behaviour/positions.hpp"
#include "mind/behaviour/walking.hpp"

namespace regista::mind {
namespace {

constexpr double aligned = 0.30;          // rad between heading and kick that still gives a clean one
constexpr double rolling = 0.25;          // m/s: slower balls are walked to, not intercepted
constexpr double search_turn_rate = 0.6;  // rad/s: slow enough for the camera

double rolling_distance(const Situation& situation) {
  return situation.ball_velocity.squaredNorm() / (2.0 * situation.rules.ball.rolling_deceleration);
}

// From the centre of a robot to that of a ball that touches it.
double touching(const Situation& situation) {
  return situation.robot.body.radius + situation.rules.ball.diameter / 2.0;
}

}  // namespace

Command play_ball(const Situation& situation, const KickPlan& kick) {
  Command command;
  const Vector2d own = situation.frame.origin();
  const double reach = situation.robot.body.reach;
  const double stand_off = 0.5 * (touching(situation) + reach);
  const double direction = angle_of(kick.direction);

  // A rolling ball is met where it will be.
  Vector2d ball = situation.ball;
  const double speed = situation.ball_velocity.norm();
  if (speed > rolling) {
    const double arrival = std::min(2.0, (ball - own).norm() / situation.robot.walk.forward);
    const double rolled = std::min(speed * arrival, rolling_distance(situation));
    ball += situation.ball_velocity * (rolled / speed);
  }
  const Vector2d to_ball = situation.ball - own;
  const double distance = to_ball.norm();
  const double turn = wrap(direction - situation.pose.heading);
  const bool behind = distance > 1e-6 && to_ball.dot(kick.direction) > 0.8 * distance;
  if (distance < reach && behind && std::abs(turn) < aligned && situation.sees_ball) {
    command.kick = KickRequest{kick.kind, turn, kick.distance};
    return command;
  }

  Obstacles obstacles = obstacles_around(situation);
  const Vector2d stand = ball - kick.direction * stand_off;
  // The ball is in its own way until the robot is behind it.
  if (!behind) obstacles.add(ball, touching(situation) + 0.15);
  const Vector2d step_back = behind ? stand : Vector2d(ball - kick.direction * (stand_off + 0.15));
  command.walk = walk_to(situation, {step_back.x(), step_back.y(), direction}, obstacles.list());
  // From behind, creep onto the ball: pushing it on is better than stopping short of it.
  if (behind && distance < stand_off + 0.12 && std::abs(turn) < 2.0 * aligned) {
    const Vector2d ahead = situation.frame.direction_to_robot(to_ball.normalized());
    command.walk.forward = 0.12 * ahead.x();
    command.walk.sideways = 0.12 * ahead.y();
  }
  return command;
}

std::optional<Vector2d> interception(const Situation& situation, double reach) {
  const double speed = situation.ball_velocity.norm();
  if (!situation.ball_trusted || speed < rolling) return std::nullopt;
  const Vector2d own = situation.frame.origin();
  const Vector2d end = situation.ball + situation.ball_velocity * (rolling_distance(situation) / speed);
  const Vector2d point = nearest_on_segment(situation.ball, end, own);
  if ((point - own).norm() > reach || (point - situation.ball).dot(situation.ball_velocity) <= 0.0) return std::nullopt;
  return point;
}

bool keeper_plays_ball(const Situation& situation) {
  if (!situation.ball_trusted || ball_is_theirs(situation)) return false;
  const Vector2d goal(-situation.rules.field.length / 2.0, 0.0);
  const bool near = (situation.ball - goal).norm() < situation.rules.field.penalty_area_length + 0.2 ||
                    (situation.ball - situation.frame.origin()).norm() < 1.0;
  return near && situation.ball_velocity.norm() < 0.5;
}

Command keep_goal(const Situation& situation) {
  Command command;
  if (situation.ball_velocity.x() < 0.0 && !ball_is_theirs(situation)) {
    if (const auto point = interception(situation, 1.5)) {
      const double heading = angle_of(situation.ball - situation.frame.origin());
      command.walk = walk_to(situation, {point->x(), point->y(), heading}, {}, true);
      return command;
    }
  }
  command.walk = walk_to(situation, legal(situation, situation.target), obstacles_around(situation).list());
  return command;
}

Command support(const Situation& situation) {
  Command command;
  const Obstacles obstacles = obstacles_around(situation);
  if (!ball_is_theirs(situation)) {
    if (const auto point = interception(situation, 1.0)) {
      const double heading = angle_of(situation.ball - situation.frame.origin());
      command.walk = walk_to(situation, {point->x(), point->y(), heading}, obstacles.list(), true);
      return command;
    }
  }
  Pose target = legal(situation, situation.target);
  if (situation.along_edges) {
    const Vector2d next = along_edges(situation.placement, situation.frame.origin(), {target.x, target.y});
    if (next != Vector2d(target.x, target.y)) target = {next.x(), next.y(), target.heading};
  }
  command.walk = walk_to(situation, target, obstacles.list());
  return command;
}

Command search(const Situation& situation) {
  Command command;
  const Pose target = legal(situation, situation.target);
  const double distance = std::hypot(target.x - situation.pose.x, target.y - situation.pose.y);
  if (situation.has_role && distance > 0.5) {
    command.walk = walk_to(situation, target, obstacles_around(situation).list());
  } else {
    // Neighbours turn in opposite directions, so that together they see more.
    command.walk.turn = situation.own_number % 2 == 0 ? search_turn_rate : -search_turn_rate;
  }
  return command;
}

}  // namespace regista::mind
