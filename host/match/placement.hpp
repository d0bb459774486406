// SPDX-License-Identifier: MIT
// Positions on the field according to the RoboCup SPL rule book 2023: areas, places where people put robots and the
// ball, and legal positions in Set. The position of a robot is the position of its centre. World frame, metres.
// `direction`: +1 for a side that attacks towards +x, else -1. `end`: +1 for the goal at +x, -1 for the goal at -x.
#pragma once

#include <cmath>
#include <span>

#include "config/rules.hpp"
#include "match/game_state.hpp"
#include "match/side.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

// --- Areas of section 1.1 of the rule book.

inline bool in_box(const config::FieldSize& field, double end, double length, double width, Vector at) {
  return end * at.x > field.length / 2.0 - length && end * at.x < field.length / 2.0 && std::fabs(at.y) < width / 2.0;
}

inline bool in_goal_area(const config::FieldSize& field, double end, Vector at) {
  return in_box(field, end, field.goal_area_length, field.goal_area_width, at);
}

inline bool in_penalty_area(const config::FieldSize& field, double end, Vector at) {
  return in_box(field, end, field.penalty_area_length, field.penalty_area_width, at);
}

inline bool in_centre_circle(const config::FieldSize& field, Vector at) {
  const double radius = field.centre_circle_diameter / 2.0;
  return squared_length(at) < radius * radius;
}

// Returns whether the whole robot is on the border strip outside the lines. A goal is not a part of the strip.
inline bool on_border_strip(const config::FieldSize& field, Vector at, double robot_radius) {
  if (std::fabs(at.y) > field.width / 2.0 + robot_radius) return true;
  return std::fabs(at.x) > field.length / 2.0 + robot_radius && std::fabs(at.y) > field.goal_width / 2.0;
}

inline Vector penalty_mark(const config::FieldSize& field, double end) {
  return {end * (field.length / 2.0 - field.penalty_mark_distance), 0.0};
}

// --- Places where people put robots and the ball.

// Returns the pose of a robot before a half: on a touch line of its own half, facing into the field. Seen in the
// direction of attack, robots with odd numbers are on the left, robots with even numbers on the right.
mind::Pose start_pose(const config::FieldSize& field, double direction, int number, int team_size);

// Returns the pose of a robot after a penalty: in its own half, level with the penalty mark, on the touch line that is
// farther from the ball. If another robot is there, the pose moves along the line, first away from the ball. robots,
// self: as for free_spot(). gap: least distance from other robots.
mind::Pose re_entry_pose(const config::FieldSize& field, double direction, Vector ball, int self,
                         std::span<const Vector> robots, double gap);

// Returns the pose of robot `id` while it is out of play: beyond the border, where it disturbs no other robot.
mind::Pose waiting_pose(const config::FieldSize& field, int id, double robot_radius);

// These functions return the place of the ball for a set play after the ball has left the field at `left_at`.
Vector kick_in_spot(const config::FieldSize& field, Vector left_at);
Vector goal_kick_spot(const config::FieldSize& field, Vector left_at);
Vector corner_spot(const config::FieldSize& field, Vector left_at);

// Returns the first free point: `wanted`, or a point in rings of rising distance around `wanted`. If 20 rings contain
// no free point, returns `wanted`. A free point is inside the lines, at least `robot_gap` from every other robot and
// `ball_gap` from the ball (between centres). robots: positions of all robots by id. self: id of the placed robot.
Vector free_spot(const config::FieldSize& field, Vector wanted, int self, std::span<const Vector> robots,
                 double robot_gap, Vector ball, double ball_gap);

// --- Set, before a kick-off or a penalty kick: sections 3.6, 3.9 and 4.4.

// Returns the robots of `playing` that are at an illegal position. robots: positions by id.
RobotSet illegal_in_set(const config::Rules& rules, const GameState& state, Roster roster,
                        std::span<const Vector> robots, RobotSet playing, double robot_radius);

// Returns the robots of `playing` that are in a forbidden part of the field at a kick-off: beyond the halfway line, or,
// for the defending side, in the centre circle. One robot of the kicking side may be beyond the line within the circle.
RobotSet intruders_at_kick_off(const config::Rules& rules, const GameState& state, Roster roster,
                               std::span<const Vector> robots, RobotSet playing);

// Returns the robots of `playing` that are illegally in the penalty area at a penalty kick. Only the goalkeeper of the
// defending side and the attacker nearest to the ball may be in the area.
RobotSet intruders_at_penalty_kick(const config::Rules& rules, const GameState& state, Roster roster,
                                   std::span<const Vector> robots, RobotSet playing);

}  // namespace regista::match
