// SPDX-License-Identifier: MIT
// Which kick to play: at goal, to a teammate, or ahead. Every option is a straight line that the ball would roll; it is
// worth what it gains towards the opponent's goal less what opponents near the line may cost.
#pragma once

#include <optional>

#include "mind/behaviour/situation.hpp"
#include "mind/geometry.hpp"

namespace regista::mind {

struct KickPlan {
  Vector2d direction{1, 0};  // unit, field frame
  double distance = 0.0;     // that the ball shall roll, m
  int kind = 0;              // index into config::Robot::kicks
};

// The best option from where the ball lies. `last`: the option of the last decision, which is kept unless another one
// is clearly better. Needs at least one kind of kick.
KickPlan choose_kick(const Situation& situation, const std::optional<KickPlan>& last);

}  // namespace regista::mind
