// SPDX-License-Identifier: MIT
// The landmarks of a field, computed from its size: what a camera can recognise, and what a plugin is told to expect.
// The set is symmetric under a half turn, so it is the same in both teams' field frames.
#pragma once

#include <regista/abi.h>

#include <vector>

#include "config/rules.hpp"

namespace regista::mind {

// Field frame, metres. Order: goal posts, centre, penalty marks, corners, T junctions.
inline std::vector<regista_landmark> landmarks(const config::FieldSize& field) {
  const double goal_line = field.length / 2.0, touch_line = field.width / 2.0;
  const double post = (field.goal_width + field.post_diameter) / 2.0;
  std::vector<regista_landmark> out;
  const auto add = [&out](int kind, double x, double y) { out.push_back({kind, 0, x, y}); };
  const auto add_mirrored = [&add](int kind, double x, double y) {
    add(kind, x, y);
    add(kind, x, -y);
    add(kind, -x, y);
    add(kind, -x, -y);
  };
  add_mirrored(REGISTA_LANDMARK_GOAL_POST, goal_line, post);
  add(REGISTA_LANDMARK_CENTRE, 0.0, 0.0);
  add(REGISTA_LANDMARK_PENALTY_MARK, goal_line - field.penalty_mark_distance, 0.0);
  add(REGISTA_LANDMARK_PENALTY_MARK, -(goal_line - field.penalty_mark_distance), 0.0);
  add_mirrored(REGISTA_LANDMARK_CORNER, goal_line, touch_line);
  add(REGISTA_LANDMARK_T_JUNCTION, 0.0, touch_line);
  add(REGISTA_LANDMARK_T_JUNCTION, 0.0, -touch_line);
  add_mirrored(REGISTA_LANDMARK_T_JUNCTION, goal_line, field.goal_area_width / 2.0);
  add_mirrored(REGISTA_LANDMARK_T_JUNCTION, goal_line, field.penalty_area_width / 2.0);
  return out;
}

}  // namespace regista::mind
