// SPDX-License-Identifier: MIT
// What a behaviour acts on: the robot's beliefs, picked out of worlds and decision so that every skill is a function of
// plain values. SI units, field frame unless said otherwise.
#pragma once

#include <span>

#include "config/robot.hpp"
#include "config/rules.hpp"
#include "config/team.hpp"
#include "mind/geometry.hpp"
#include "mind/world/distributed_world_model.hpp"
#include "plugin/positioner.hpp"

namespace regista::mind {

struct Situation {
  const config::Rules& rules;
  const config::Robot& robot;
  const DistributedWorldModel& world;  // `mine`
  const plugin::Placement& placement;  // V, for walking along its edges
  double time = 0.0;
  int own_number = 0;
  Pose pose;
  Frame2 frame;  // of pose
  config::Behaviour behaviour = config::Behaviour::search;
  bool has_role = false;
  Pose target;  // of the own task, after the offset
  bool along_edges = false;
  bool sees_ball = false;
  bool ball_trusted = false;  // known, and young enough to act on
  Vector2d ball{0, 0}, ball_velocity{0, 0};
  double ball_age = 0.0;
  std::span<const Vector2d> robots_near;  // of either team, seen now or a moment ago
};

}  // namespace regista::mind
