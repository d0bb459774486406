// SPDX-License-Identifier: MIT
// The areas of a field that rules speak of, for who stands with its centre in them. World frame; `end` is +1 for the
// goal at +x, -1 for the one at -x. RoboCup SPL rule book 2023, section 1.1.
#pragma once

#include <cmath>

#include "config/rules.hpp"
#include "match/geometry.hpp"

namespace regista::match {

// grown: by so much to every side.
inline bool in_box(const config::FieldSize& field, double end, double length, double width, Vector at, double grown) {
  return end * at.x > field.length / 2.0 - length - grown && end * at.x < field.length / 2.0 + grown &&
         std::fabs(at.y) < width / 2.0 + grown;
}

inline bool in_goal_area(const config::FieldSize& field, double end, Vector at, double grown = 0.0) {
  return in_box(field, end, field.goal_area_length, field.goal_area_width, at, grown);
}

inline bool in_penalty_area(const config::FieldSize& field, double end, Vector at, double grown = 0.0) {
  return in_box(field, end, field.penalty_area_length, field.penalty_area_width, at, grown);
}

inline bool in_centre_circle(const config::FieldSize& field, Vector at) {
  const double radius = field.centre_circle_diameter / 2.0;
  return squared_length(at) < radius * radius;
}

// Wholly on the border strip, but not in a goal.
inline bool on_border_strip(const config::FieldSize& field, Vector at, double robot_radius) {
  if (std::fabs(at.y) > field.width / 2.0 + robot_radius) return true;
  return std::fabs(at.x) > field.length / 2.0 + robot_radius && std::fabs(at.y) > field.goal_width / 2.0;
}

inline Vector penalty_mark(const config::FieldSize& field, double end) {
  return {end * (field.length / 2.0 - field.penalty_mark_distance), 0.0};
}

}  // namespace regista::match
