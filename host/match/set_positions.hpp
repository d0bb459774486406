// SPDX-License-Identifier: MIT
// Where robots may stand in Set, before a kick-off or a penalty kick. RoboCup SPL rule book 2023, sections 3.6 and 3.9
// and 4.4. A robot stands where its centre is.
#pragma once

#include <span>

#include "config/rules.hpp"
#include "match/game_state.hpp"
#include "match/side.hpp"

namespace regista::match {

// Those of the robots `playing` that stand illegally. robots: positions by id, world frame.
RobotSet illegal_in_set(const config::Rules& rules, const GameState& state, Roster roster,
                        std::span<const Vector> robots, RobotSet playing, double robot_radius);

// Those of `playing` that are in the other side's part of the field at a kick-off: beyond the halfway line, defenders
// also in the circle. One robot of the side that kicks off may be beyond the line within the circle.
RobotSet intruders_at_kick_off(const config::Rules& rules, const GameState& state, Roster roster,
                               std::span<const Vector> robots, RobotSet playing);

// Those of `playing` that are in the penalty area of a penalty kick and must not be: all but the goalkeeper of the
// defending side and the attacker that is nearest to the ball.
RobotSet intruders_at_penalty_kick(const config::Rules& rules, const GameState& state, Roster roster,
                                   std::span<const Vector> robots, RobotSet playing);

}  // namespace regista::match
