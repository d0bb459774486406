// SPDX-License-Identifier: MIT
#include "mind/behaviour/positions.hpp"

#include <algorithm>
#include <cmath>

namespace regista::mind {
namespace {

constexpr double margin = 0.2;  // m, beyond what a rule asks for, because nobody knows exactly where it stands

Vector2d outside_circle(const Vector2d& point, const Vector2d& centre, double radius) {
  const Vector2d out = point - centre;
  const double distance = out.norm();
  if (distance >= radius) return point;
  // From the centre itself, back towards the own goal.
  return distance < 1e-6 ? Vector2d(centre.x() - radius, centre.y()) : Vector2d(centre + out * (radius / distance));
}

bool takes(const Situation& situation) { return situation.behaviour == config::Behaviour::play_ball; }

Vector2d at_kick_off(const Situation& situation, Vector2d point) {
  const regista_game& game = situation.world.raw.game;
  const double line = -situation.robot.body.radius - margin;
  if (game.own_kick != 0 && takes(situation)) {
    return game.phase == REGISTA_PHASE_PLAYING ? point : Vector2d(line, 0.0);
  }
  point.x() = std::min(point.x(), line);
  if (game.own_kick == 0) {
    const double circle = situation.rules.field.centre_circle_diameter / 2.0 + situation.robot.body.radius + margin;
    point = outside_circle(point, {0.0, 0.0}, circle);
    point.x() = std::min(point.x(), line);
  }
  return point;
}

// The taker waits behind the mark, the goalkeeper on its line; everybody else stays out of the penalty area.
Vector2d at_penalty_kick(const Situation& situation, Vector2d point) {
  const regista_game& game = situation.world.raw.game;
  const config::FieldSize& field = situation.rules.field;
  const double end = game.own_kick != 0 ? 1.0 : -1.0;
  if (game.own_kick != 0 && takes(situation)) {
    if (game.phase == REGISTA_PHASE_PLAYING) return point;
    const double behind = situation.robot.body.radius + situation.rules.ball.diameter + margin;
    return {field.length / 2.0 - field.penalty_mark_distance - behind, 0.0};
  }
  if (game.own_kick == 0 && situation.own_number == 1) {
    const double between = field.goal_width / 2.0 - situation.robot.body.radius;
    return {-field.length / 2.0, std::clamp(point.y(), -between, between)};
  }
  const double edge = field.length / 2.0 - field.penalty_area_length - situation.robot.body.radius - margin;
  return {end * std::min(end * point.x(), edge), point.y()};
}

// Three of a team may stand there; who has no business at the ball leaves the room to those who have.
Vector2d outside_own_goal_area(const config::FieldSize& field, const Vector2d& point) {
  const double edge = -field.length / 2.0 + field.goal_area_length + margin;
  if (point.x() >= edge || std::abs(point.y()) >= field.goal_area_width / 2.0 + margin) return point;
  return {edge, point.y()};
}

}  // namespace

bool ball_is_theirs(const Situation& situation) {
  const regista_game& game = situation.world.raw.game;
  return game.set_play != REGISTA_SET_PLAY_NONE && game.own_kick == 0;
}

Pose legal(const Situation& situation, const Pose& wanted) {
  const regista_game& game = situation.world.raw.game;
  const config::FieldSize& field = situation.rules.field;
  Vector2d point(std::clamp(wanted.x, -field.length / 2.0, field.length / 2.0),
                 std::clamp(wanted.y, -field.width / 2.0, field.width / 2.0));
  double heading = wanted.heading;
  if (game.set_play == REGISTA_SET_PLAY_PENALTY_KICK) {
    point = at_penalty_kick(situation, point);
    // The taker and the goalkeeper face each other.
    if (game.own_kick != 0 && takes(situation)) heading = 0.0;
  } else if (game.phase == REGISTA_PHASE_READY || game.phase == REGISTA_PHASE_SET ||
             game.set_play == REGISTA_SET_PLAY_KICK_OFF) {
    point = at_kick_off(situation, point);
  } else if (ball_is_theirs(situation) && situation.ball_trusted) {
    const double distance = situation.rules.set_play_distance + situation.robot.body.radius + margin;
    point = outside_circle(point, situation.ball, distance);
  }
  if (situation.behaviour != config::Behaviour::keep_goal && !takes(situation)) {
    point = outside_own_goal_area(field, point);
  }
  return {point.x(), point.y(), heading};
}

}  // namespace regista::mind
