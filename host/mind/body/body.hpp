// SPDX-License-Identifier: MIT
// What a robot needs to move: what it can do, where it is, and what may stand in its way. SI units, field frame.
#pragma once

#include <span>

#include "config/robot.hpp"
#include "config/rules.hpp"
#include "mind/geometry.hpp"
#include "mind/world/distributed_world_model.hpp"

namespace regista::mind {

struct Body {
  const config::Rules& rules;
  const config::Robot& robot;
  const DistributedWorldModel& world;  // `mine`
  int own_number = 0;
  Pose pose;
  Frame2 frame;                           // of pose
  std::span<const Vector2d> robots_near;  // of either team, seen now or a moment ago
};

}  // namespace regista::mind
