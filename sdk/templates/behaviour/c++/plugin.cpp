// SPDX-License-Identifier: MIT
// Glue between the algorithm and Regista: what it is called, what can be set, which call it answers.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <regista/behaviour.hpp>

#include "algorithm.hpp"

namespace {

struct Plugin {
  static constexpr auto id = "@NAME@", version = "0.1.0",
                        summary = "Stands at the place of its task, away from the ball, and looks at it";
  // Of a frame it reads the heading that the task asks for; see REGISTA_READS_* in <regista/abi.h>.
  static constexpr unsigned reads = REGISTA_READS_FACINGS;

  double distance = 1.1;
  static constexpr std::tuple parameters{
      regista::real("distance", &Plugin::distance, {0.3, 5.0}, "m",
                    "Never nearer to the ball; opponents of a set play have to keep 0.75 m, and a body is 0.3 m wide")
          .tunable()};

  double own_half = 0.0;  // x below which a robot of the own team stands in its half, with room to spare

  void setup(const regista::Environment& environment) { own_half = -environment->robot_radius - 0.2; }

  // Called in every phase. On entry the robot stands and looks ahead; whoever walks in Set is penalised.
  void act(const regista::Frame& frame, const regista::Body& body, regista::Action& out) {
    const regista::World world = frame.mine();
    const int phase = world.game().phase;
    const regista::Task* const task = body.task(frame);
    if (task == nullptr || (phase != REGISTA_PHASE_READY && phase != REGISTA_PHASE_PLAYING)) return;
    Place place{task->after[0], task->after[1], task->after[2]};
    if (world.ball_known()) {
      const double *const ball = world.ball().position, *const pose = body->pose;
      place = beside(ball[0], ball[1], place.x, place.y, distance);
      const double direction = std::atan2(ball[1] - pose[1], ball[0] - pose[0]);
      out.gaze = std::remainder(direction - pose[2], 2.0 * std::numbers::pi);
    }
    if (phase == REGISTA_PHASE_READY) place.x = std::min(place.x, own_half);
    out.motion = REGISTA_MOTION_WALK_TO;
    out.pose[0] = place.x;
    out.pose[1] = place.y;
    out.pose[2] = place.heading;
  }
};

}  // namespace

REGISTA_PLUGIN(Plugin, regista::behaviour)
