// SPDX-License-Identifier: MIT
#include "mind/behaviour/positions.hpp"

#include <algorithm>

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
  const bool kick_off = game.phase == REGISTA_PHASE_READY || game.phase == REGISTA_PHASE_SET ||
                        game.set_play == REGISTA_SET_PLAY_KICK_OFF;
  if (kick_off) {
    const double line = -situation.robot.body.radius - margin;
    const bool taker = game.own_kick != 0 && situation.behaviour == config::Behaviour::play_ball;
    if (!taker) {
      point.x() = std::min(point.x(), line);
      if (game.own_kick == 0) {
        const double circle = field.centre_circle_diameter / 2.0 + situation.robot.body.radius + margin;
        point = outside_circle(point, {0.0, 0.0}, circle);
        point.x() = std::min(point.x(), line);
      }
    } else if (game.phase != REGISTA_PHASE_PLAYING) {
      point = {line, 0.0};
    }
  } else if (ball_is_theirs(situation) && situation.ball_trusted) {
    const double distance = situation.rules.set_play_distance + situation.robot.body.radius + margin;
    point = outside_circle(point, situation.ball, distance);
  }
  return {point.x(), point.y(), wanted.heading};
}

}  // namespace regista::mind
