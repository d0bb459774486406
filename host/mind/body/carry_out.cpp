// SPDX-License-Identifier: MIT
#include "mind/body/carry_out.hpp"

#include <span>

#include "mind/body/walking.hpp"

namespace regista::mind {
namespace {

Walk walk_to_pose(const Body& body, const regista_action& action) {
  Obstacles obstacles;
  if ((action.walk & REGISTA_WALK_STRAIGHT) == 0) obstacles = obstacles_around(body);
  for (const regista_disc& disc : std::span(action.avoid).first(action.avoid_count)) {
    obstacles.add({disc.x, disc.y}, disc.radius);
  }
  const bool brisk = (action.walk & REGISTA_WALK_BRISK) != 0;
  return walk_to(body, {action.pose[0], action.pose[1], action.pose[2]}, obstacles.list(), brisk);
}

}  // namespace

Command carry_out(const Body& body, const regista_action& action) {
  Command command;
  command.head_yaw = action.gaze;
  if (action.kick != REGISTA_NO_KICK) {
    command.kick = KickRequest{action.kick, action.kick_direction, action.kick_distance};
    return command;
  }
  const Vector2d wanted(action.velocity[0], action.velocity[1]);
  if (action.motion == REGISTA_MOTION_VELOCITY) command.walk = limited(body.robot.walk, wanted, action.velocity[2]);
  if (action.motion == REGISTA_MOTION_WALK_TO) {
    command.walk = walk_to_pose(body, action);
    if ((action.walk & REGISTA_WALK_CREEP) != 0) {
      command.walk = limited(body.robot.walk, wanted, command.walk.turn);
    }
  }
  return command;
}

}  // namespace regista::mind
