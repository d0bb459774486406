// SPDX-License-Identifier: MIT
#include "mind/behaviour/behaviour.hpp"

#include <algorithm>
#include <cmath>

#include "mind/behaviour/positions.hpp"
#include "mind/behaviour/skills.hpp"
#include "mind/behaviour/walking.hpp"

namespace regista::mind {
namespace {

constexpr double sweep_period = 4.0;         // s to and fro
constexpr double glance_every = 4.0;         // s
constexpr double glance_lasts = 1.2;         // s
constexpr double eyes_on_ball_within = 0.8;  // m: who plays the ball looks at it

// Triangle wave in [-1, 1].
double triangle(double phase) { return 4.0 * std::abs(phase - std::floor(phase + 0.5)) - 1.0; }

}  // namespace

KickPlan Behaviour::kick(const Situation& situation) {
  last_kick_ = choose_kick(situation, last_kick_);
  return *last_kick_;
}

Command Behaviour::act(const Situation& situation, const Percepts& percepts) {
  Command command;
  const int phase = situation.world.raw.game.phase;
  const bool stands = percepts.fallen || percepts.penalised || percepts.kicking || phase == REGISTA_PHASE_INITIAL ||
                      phase == REGISTA_PHASE_SET || phase == REGISTA_PHASE_FINISHED;
  if (!stands) {
    using Role = config::Behaviour;
    const bool ready = phase == REGISTA_PHASE_READY;
    const bool can_kick = !situation.robot.kicks.empty();
    if (!situation.has_role) {
      command = ready ? Command{} : search(situation);
    } else if (ready) {
      command.walk = walk_to(situation, legal(situation, situation.target), obstacles_around(situation).list());
    } else if (situation.behaviour == Role::keep_goal) {
      const bool plays = can_kick && keeper_plays_ball(situation);
      command = plays ? mind::play_ball(situation, kick(situation)) : mind::keep_goal(situation);
    } else if (situation.behaviour == Role::play_ball && can_kick && situation.ball_trusted &&
               !ball_is_theirs(situation)) {
      command = mind::play_ball(situation, kick(situation));
    } else if (situation.behaviour == Role::search ||
               (situation.behaviour == Role::play_ball && !situation.ball_trusted)) {
      command = mind::search(situation);
    } else {
      command = support(situation);
    }
  }
  command.head_yaw = look(situation);
  return command;
}

double look(const Situation& situation) {
  const double limit = situation.robot.camera.head_yaw;
  // Everyone sweeps at an own phase.
  const double shifted = situation.time + 0.37 * situation.own_number;
  if (!situation.ball_trusted) return limit * triangle(shifted / sweep_period);
  const Vector2d ball = situation.frame.to_robot(situation.ball);
  const bool glance = std::fmod(shifted, glance_every) < glance_lasts && ball.norm() > eyes_on_ball_within;
  if (glance) return limit * triangle(std::fmod(shifted, glance_every) / glance_lasts);
  return std::clamp(angle_of(ball), -limit, limit);
}

}  // namespace regista::mind
