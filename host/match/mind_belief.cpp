// SPDX-License-Identifier: MIT
#include "match/mind_belief.hpp"

#include <regista/abi.h>

namespace regista::match {

void belief_of(const mind::Mind& mind, Belief& out) {
  const mind::WorldModel& model = mind.world();
  const mind::DistributedWorldModel& world = model.mine();
  const regista_track& self = model.local().self();
  out.self = {true, {self.x, self.y}, self.covariance[0], self.covariance[1], self.covariance[2]};
  const regista_ball& ball = world.ball_state;
  out.ball = {world.ball_known() && !model.ball_refuted(),
              {ball.position[0], ball.position[1]},
              ball.covariance[0],
              ball.covariance[1],
              ball.covariance[2]};
  out.teammates.clear();
  for (const regista_robot& robot : world.robots) {
    out.teammates.push_back({(robot.flags & REGISTA_ROBOT_ACTIVE) != 0,
                             {robot.pose[0], robot.pose[1]},
                             robot.covariance[0],
                             robot.covariance[1],
                             robot.covariance[2]});
  }
  out.opponents.clear();
  for (const regista_opponent& opponent : world.opponents) {
    out.opponents.push_back({opponent.position[0], opponent.position[1]});
  }
}

}  // namespace regista::match
