// SPDX-License-Identifier: MIT
// Where people put things: robots before a half, robots that come back, the ball
// of a set play. RoboCup SPL rule book 2023. World frame; `direction` is +1 for a side that attacks towards +x.
#pragma once

#include <span>

#include "config/rules.hpp"
#include "match/geometry.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

// On a touch line of the own half, facing into the field: odd numbers at the left of the side, even ones at its right.
mind::Pose start_pose(const config::FieldSize& field, double direction, int number, int team_size);

// Back from a penalty: own half, level with the penalty mark, on the touch line far from the ball; where somebody
// stands there, beside that along the line, rather away from the ball. robots, self, gap: as for free_spot.
mind::Pose re_entry_pose(const config::FieldSize& field, double direction, Vector ball, int self,
                         std::span<const Vector> robots, double gap);

// Out of play: robot `id` waits beyond the border, out of everybody's way.
mind::Pose waiting_pose(const config::FieldSize& field, int id, double robot_radius);

// The ball left over a goal line or a touch line at `left_at`.
Vector kick_in_spot(const config::FieldSize& field, Vector left_at);
Vector goal_kick_spot(const config::FieldSize& field, Vector left_at);
Vector corner_spot(const config::FieldSize& field, Vector left_at);

// The first point, in rings of rising distance around `wanted`, that is inside the lines and at least `robot_gap`
// from every other robot and `ball_gap` from the ball (centres). robots: all positions by id, `self` is skipped.
// Where there is none within 20 rings, `wanted` itself.
Vector free_spot(const config::FieldSize& field, Vector wanted, int self, std::span<const Vector> robots,
                 double robot_gap, Vector ball, double ball_gap);

}  // namespace regista::match
