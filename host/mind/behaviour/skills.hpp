// SPDX-License-Identifier: MIT
// What a robot can do about the ball: play it, receive it, keep it out of the goal, look for it. Each skill is a
// function from a situation to a command.
#pragma once

#include <optional>

#include "mind/behaviour/kick_choice.hpp"
#include "mind/behaviour/situation.hpp"
#include "mind/command.hpp"

namespace regista::mind {

// Walks behind the ball as seen from where it shall go, then kicks it there.
Command play_ball(const Situation& situation, const KickPlan& kick);

// A point on the way of a rolling ball where the robot can be in time; nothing when the ball lies, leaves, or passes
// too far away. `reach`: how far to go at most, m.
std::optional<Vector2d> interception(const Situation& situation, double reach);

// The ball lies so near the goal that its keeper should play it.
bool keeper_plays_ball(const Situation& situation);

// Stands between ball and goal at the own target; goes for a shot's line.
Command keep_goal(const Situation& situation);

// Walks to the own target, legally, facing as the role asks; receives a ball that comes along.
Command support(const Situation& situation);

// Turns about at the own target.
Command search(const Situation& situation);

}  // namespace regista::mind
