// SPDX-License-Identifier: MIT
// Room between the players of a team: whoever supports stays clear of the ball, where a teammate plays it, and apart
// from the targets of more important tasks. Targets are given as places about the ball and collapse where the ball is
// near a line or a corner; then robots stand in each other's way. All robots of a team move the same targets alike, as
// far as they believe the same.
#pragma once

#include <algorithm>
#include <span>

#include "legal_place.hpp"
#include "situation.hpp"

namespace behaviours {

struct SpreadSettings {
  double clear_of_ball = 0.0;  // m: nobody stands nearer to the ball without playing it
  double apart = 0.0;          // m: least distance between two targets
  double moved_at_most = 1.2;  // m: a target is moved no farther, so that it keeps its sense
};

// The target, moved as little as needed. more_important: the targets of tasks that come first in the list of tasks.
inline Vector2d spread(const Situation& situation, const SpreadSettings& settings, const Vector2d& target,
                       std::span<const Vector2d> more_important) {
  if (settings.clear_of_ball <= 0.0 && settings.apart <= 0.0) return target;
  const Field& field = situation.facts.field;
  const Vector2d corner(field.length / 2.0, field.width / 2.0);
  Vector2d place = target;
  // Leaving one target may lead to another: a second round mends most of it.
  for (int round = 0; round < 2; ++round) {
    for (const Vector2d& other : more_important) place = detail::outside_circle(place, other, settings.apart);
    if (situation.ball_trusted) place = detail::outside_circle(place, situation.ball, settings.clear_of_ball);
    place = place.cwiseMin(corner).cwiseMax(-corner);
  }
  const Vector2d moved = place - target;
  const double distance = moved.norm();
  return distance <= settings.moved_at_most ? place : Vector2d(target + moved * (settings.moved_at_most / distance));
}

}  // namespace behaviours
