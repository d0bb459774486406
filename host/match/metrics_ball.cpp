// SPDX-License-Identifier: MIT
#include "match/metrics_ball.hpp"

#include "match/sampling.hpp"

namespace regista::match {
namespace {

double way_in(double time, const config::Robot& robot) { return robot.body.radius + time * robot.walk.forward; }

}  // namespace

BallMeasures::BallMeasures(int team_size, const std::array<config::Robot, 2>& robots)
    : roster_{team_size},
      within_reach_{way_in(soon, robots[0]), way_in(soon, robots[1])},
      decisions_(at(roster_.count())) {}

void BallMeasures::sample(const GameState& state, std::span<const BodyState> bodies, RobotSet able) {
  ++samples_;
  const BodyState& ball = bodies.back();
  const Vector place{ball.x, ball.y};
  bool neglected = false;
  for (const Side side : both_sides) {
    const Vector in_frame = attack(side, state.half) * place;
    int nearest = -1, chasing = 0;
    double least = 0.0;  // m^2
    for (int number = 1; number <= roster_.team_size; ++number) {
      if (state.is_penalised(side, number)) continue;
      const int id = roster_.id(side, number);
      const BodyState& body = bodies[at(id)];
      const double distance = squared_length(Vector{body.x, body.y} - place);
      if (distance <= near_ball * near_ball) ++teams_[index(side)].near;
      if (!contains(able, id)) continue;
      if (nearest < 0 || distance < least) {
        nearest = id;
        least = distance;
      }
      const Decision& decision = decisions_[at(id)];
      const bool there = decision.target && squared_length(*decision.target - in_frame) <= for_the_ball * for_the_ball;
      if (decision.plays || decision.kicks || there) ++chasing;
    }
    Team& team = teams_[index(side)];
    if (chasing >= 2) ++team.several;
    if (nearest < 0) continue;
    ++team.nearest;
    if (decisions_[at(nearest)].plays) ++team.nearest_plays;
    const double reach = within_reach_[index(side)];
    if (least <= reach * reach) neglected = true;
  }
  if (neglected && squared_length({ball.vx, ball.vy}) < at_rest * at_rest) ++rest_;
}

BallMetrics BallMeasures::result(Side side) const {
  const Team& team = teams_[index(side)];
  return {share(team.nearest_plays, team.nearest), mean(team.near, samples_), seconds(team.several)};
}

double BallMeasures::rest_seconds() const { return seconds(rest_); }

}  // namespace regista::match
