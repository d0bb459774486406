// SPDX-License-Identifier: MIT
// Where a robot may stand: the rules of kick-off and set plays laid over the place that its role asks for.
#pragma once

#include "mind/behaviour/situation.hpp"
#include "mind/geometry.hpp"

namespace regista::mind {

// The nearest legal pose to the wanted one.
Pose legal(const Situation& situation, const Pose& wanted);

// The set play, or the kick-off until the ball is free, is the opponent's: the ball must not be touched.
bool ball_is_theirs(const Situation& situation);

}  // namespace regista::mind
