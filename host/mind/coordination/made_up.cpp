// SPDX-License-Identifier: MIT
#include "mind/coordination/made_up.hpp"

#include "mind/geometry.hpp"

namespace regista::mind {

void make_up(DistributedWorldModel& world, const TeamPlan& plan, int list, int scene, double time, int own,
             int out_of_play, Dice& dice) {
  const double x = plan.rules().field.length / 2.0, y = plan.rules().field.width / 2.0;
  const int team_size = plan.rules().team_size;
  const auto roles = static_cast<int>(plan.team().role_lists[static_cast<std::size_t>(list)].roles.size());
  for (int number = 1; number <= team_size; ++number) {
    regista_robot& robot = world.robot(number);
    robot.flags = REGISTA_ROBOT_KNOWN | REGISTA_ROBOT_HAS_TARGET;
    robot.flags |= number == out_of_play ? REGISTA_ROBOT_PENALISED : REGISTA_ROBOT_ACTIVE;
    if (number == own) robot.flags |= REGISTA_ROBOT_SELF;
    robot.pose[0] = dice.real(-x, x);
    robot.pose[1] = dice.real(-y, y);
    robot.pose[2] = dice.real(-pi, pi);
    robot.velocity[0] = dice.real(-0.2, 0.2);
    robot.velocity[1] = dice.real(-0.2, 0.2);
    for (const std::size_t k : {0u, 2u, 5u}) robot.covariance[k] = 0.01;
    robot.target[0] = dice.real(-x, x);
    robot.target[1] = dice.real(-y, y);
    robot.age = number == own ? 0.0 : dice.real(0.0, 5.0);
    robot.role = plan.first_role(list) + (number + scene) % roles;
    robot.role_since = time - dice.real(0.0, 20.0);
  }
  for (int k = 0; k < team_size; ++k) {
    regista_opponent& opponent = world.opponents.emplace_back();
    opponent = {};
    opponent.label = k;
    opponent.position[0] = dice.real(-x, x);
    opponent.position[1] = dice.real(-y, y);
    opponent.covariance[0] = opponent.covariance[2] = 0.04;
    opponent.weight = 0.9;
  }
  regista_ball& ball = world.ball_state;
  ball.flags = REGISTA_BALL_KNOWN;
  ball.position[0] = dice.real(-x, x);
  ball.position[1] = dice.real(-y, y);
  ball.velocity[0] = dice.real(-1.0, 1.0);
  ball.velocity[1] = dice.real(-1.0, 1.0);
  for (const std::size_t k : {0u, 2u, 7u, 9u}) ball.covariance[k] = 0.01;
  world.game.phase = REGISTA_PHASE_PLAYING;
  world.game.half = 1;
  world.game.phase_time = time;
  world.game.time_left = plan.rules().durations.half - time;
}

}  // namespace regista::mind
