// SPDX-License-Identifier: MIT
#include "plugin/behaviour.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <span>

namespace regista::plugin {
namespace {

constexpr double farthest = 1e4;    // m, of a place
constexpr double fastest = 1e4;     // m/s and rad/s
constexpr double tolerance = 1e-9;  // what arithmetic may lose
constexpr double half_turn = std::numbers::pi;

// False for NaN.
bool within(double value, double limit) { return std::abs(value) <= limit; }

}  // namespace

Behaviour::Behaviour(std::shared_ptr<Instance> instance)
    : instance_(std::move(instance)), calls_(&instance_->table<regista_behaviour>(REGISTA_KIND_BEHAVIOUR)) {}

const regista_action& Behaviour::act(const regista_frame& frame, const regista_body& body) {
  GuardedValue<regista_action>& answer = instance_->rooms().action;
  regista_action& out = *instance_->open(answer);
  out = {};
  out.size = sizeof out;
  out.kick = REGISTA_NO_KICK;
  instance_->call_with(
      [](Inputs& inputs, const regista_frame* seen, const regista_body* own, auto*) {
        inputs.add("frame", seen);
        inputs.add("body", own);
      },
      "act", calls_->act, instance_->shown(&frame), &body, &out);
  instance_->check("act", Instance::Written{answer, "the action"});
  check(out);
  note_answer(out);
  return out;
}

// What a motion does not use may be anything.
void Behaviour::note_answer(const regista_action& action) const {
  if (!instance_->is_traced()) [[likely]]
    return;
  AnswerDigest used;
  used(action.motion, action.gaze, action.kick);
  const bool walks = action.motion == REGISTA_MOTION_WALK_TO;
  if (walks) used(action.walk, action.pose, std::span<const regista_disc>(action.avoid).first(action.avoid_count));
  if (action.motion == REGISTA_MOTION_VELOCITY || (walks && (action.walk & REGISTA_WALK_CREEP) != 0))
    used(action.velocity);
  if (action.kick != REGISTA_NO_KICK) used(action.kick_direction, action.kick_distance);
  if ((action.flags & REGISTA_ACTION_TARGET) != 0) used(action.target);
  instance_->answered(used.value());
}

void Behaviour::check(const regista_action& action) const {
  if (!within(action.gaze, half_turn + tolerance)) [[unlikely]]
    instance_->fail("act", fmt::format("gaze is {}; it is within -pi and pi", action.gaze));
  switch (action.motion) {
    case REGISTA_MOTION_STAND:
      break;
    case REGISTA_MOTION_WALK_TO: {
      const double* pose = action.pose;
      if (!within(pose[0], farthest) || !within(pose[1], farthest) || !within(pose[2], farthest)) [[unlikely]]
        instance_->fail("act", fmt::format("walks to ({}, {}), heading {}", pose[0], pose[1], pose[2]));
      if (action.avoid_count > REGISTA_MOST_AVOIDED) [[unlikely]] {
        instance_->fail(
            "act", fmt::format("avoids {} discs; there is room for {}", action.avoid_count, int{REGISTA_MOST_AVOIDED}));
      }
      for (const regista_disc& disc : std::span(action.avoid).first(action.avoid_count)) {
        if (!within(disc.x, farthest) || !within(disc.y, farthest) || !within(disc.radius, farthest) ||
            disc.radius < 0.0) [[unlikely]] {
          instance_->fail("act", fmt::format("avoids a disc at ({}, {}) of radius {}", disc.x, disc.y, disc.radius));
        }
      }
      if ((action.walk & REGISTA_WALK_CREEP) == 0) break;
      [[fallthrough]];
    }
    case REGISTA_MOTION_VELOCITY: {
      const double* velocity = action.velocity;
      if (!within(velocity[0], fastest) || !within(velocity[1], fastest) || !within(velocity[2], fastest)) [[unlikely]]
        instance_->fail("act", fmt::format("velocity is ({}, {}), turn {}", velocity[0], velocity[1], velocity[2]));
      break;
    }
    default:
      instance_->fail("act", fmt::format("motion {} does not exist", action.motion));
  }
  if (action.kick != REGISTA_NO_KICK) check_kick(action);
  if ((action.flags & REGISTA_ACTION_TARGET) != 0 &&
      !(within(action.target[0], farthest) && within(action.target[1], farthest))) [[unlikely]] {
    instance_->fail("act", fmt::format("tells of a target at ({}, {})", action.target[0], action.target[1]));
  }
}

void Behaviour::check_kick(const regista_action& action) const {
  const regista_span& kicks = instance_->environment().kicks;
  if (action.kick < 0 || static_cast<std::uint32_t>(action.kick) >= kicks.count) [[unlikely]]
    instance_->fail("act", fmt::format("kick {} of {} does not exist", action.kick, kicks.count));
  const auto& kick = static_cast<const regista_kick*>(kicks.data)[action.kick];
  if (!(action.kick_distance >= kick.minimum_distance - tolerance &&
        action.kick_distance <= kick.maximum_distance + tolerance)) [[unlikely]] {
    instance_->fail("act", fmt::format("asks kick {} ({}) to roll {} m; it rolls {} to {} m", action.kick, kick.name,
                                       action.kick_distance, kick.minimum_distance, kick.maximum_distance));
  }
  if (!within(action.kick_direction, half_turn + tolerance)) [[unlikely]]
    instance_->fail("act", fmt::format("kick's direction is {}; it is within -pi and pi", action.kick_direction));
}

}  // namespace regista::plugin
