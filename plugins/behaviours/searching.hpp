// SPDX-License-Identifier: MIT
// Looking for the ball: walks to the place of the task and turns about there; without a task, where it stands.
#pragma once

#include <cmath>

#include "legal_place.hpp"
#include "movement.hpp"
#include "situation.hpp"

namespace behaviours {

struct SearchSettings {
  double at_target = 0.5;    // m
  double turn_rate = 0.6;    // rad/s: slow enough for the camera
  double turns_first = 0.0;  // s in which a search begins with a look about where the robot stands
};

inline Movement search(const Situation& situation, const SearchSettings& settings, const LegalPlaceSettings& legal) {
  const Pose target = legal_place(situation, legal, situation.target);
  const double distance = std::hypot(target.x - situation.pose.x, target.y - situation.pose.y);
  if (situation.has_task && distance > settings.at_target) return WalkTo{.target = target};
  // Neighbours turn in opposite directions, so that together they see more.
  return Turn{situation.facts.own_number % 2 == 0 ? settings.turn_rate : -settings.turn_rate};
}

}  // namespace behaviours
