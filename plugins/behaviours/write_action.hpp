// SPDX-License-Identifier: MIT
// Glue of all behaviours: hands a movement and a gaze to the host.
#pragma once

#include <regista/behaviour.hpp>
#include <regista/pass.hpp>

#include "movement.hpp"

namespace behaviours {

namespace detail {

struct ActionWriter {
  regista::Action& out;

  void operator()(const Stand&) const { out.motion = REGISTA_MOTION_STAND; }
  void operator()(const Turn& turn) const {
    out.motion = REGISTA_MOTION_VELOCITY;
    out.velocity[2] = turn.rate;
  }
  void operator()(const WalkTo& walk) const {
    out.motion = REGISTA_MOTION_WALK_TO;
    if (walk.brisk) out.walk |= REGISTA_WALK_BRISK;
    if (walk.straight) out.walk |= REGISTA_WALK_STRAIGHT;
    out.pose[0] = walk.target.x;
    out.pose[1] = walk.target.y;
    out.pose[2] = walk.target.heading;
    if (walk.around) regista::avoid(out, walk.around->centre.x(), walk.around->centre.y(), walk.around->radius);
    if (walk.creep) {
      out.walk |= REGISTA_WALK_CREEP;
      out.velocity[0] = walk.creep->x();
      out.velocity[1] = walk.creep->y();
    }
  }
  void operator()(const KickBall& kick) const {
    out.kick = kick.kind;
    out.kick_direction = kick.direction;
    out.kick_distance = kick.distance;
  }
};

}  // namespace detail

// `out` as it came from the host.
inline void write_action(const Movement& movement, double gaze, regista::Action& out) {
  std::visit(detail::ActionWriter{out}, movement);
  out.gaze = gaze;
}

// For those who count passes.
inline void say_receiver(const Movement& movement, const regista::Pass& pass) {
  const auto* const kick = std::get_if<KickBall>(&movement);
  if (kick != nullptr && kick->receiver != 0) pass.meant_for(kick->receiver);
}

// Teammates are told that the robot goes there, and not to the place of its task.
inline void announce(const Vector2d& place, regista::Action& out) {
  out.flags |= REGISTA_ACTION_TARGET;
  out.target[0] = place.x();
  out.target[1] = place.y();
}

}  // namespace behaviours
