// SPDX-License-Identifier: MIT
#include "match/metrics_ball.hpp"

#include <algorithm>

#include "match/sampling.hpp"

namespace regista::match {
namespace {

double way_in(double time, const config::Robot& robot) { return robot.body.radius + time * robot.walk.forward; }

}  // namespace

BallMeasures::BallMeasures(int team_size, const std::array<config::Robot, 2>& robots)
    : roster_{team_size},
      within_reach_{way_in(soon, robots[0]), way_in(soon, robots[1])},
      decisions_(at(roster_.count())) {}

bool BallMeasures::Decision::goes_for(const Vector& ball) const {
  return plays || kicks || (target && squared_length(*target - ball) <= for_the_ball * for_the_ball);
}

RobotSet BallMeasures::chasing(const GameState& state, const BodyState& ball, RobotSet able) const {
  RobotSet out = 0;
  for (int id = 0; id < roster_.count(); ++id) {
    const Side side = roster_.side(id);
    if (!contains(able, id) || state.is_penalised(side, roster_.number(id))) continue;
    if (decisions_[at(id)].goes_for(attack(side, state.half) * Vector{ball.x, ball.y})) out |= only(id);
  }
  return out;
}

void BallMeasures::sample(const GameState& state, std::span<const BodyState> bodies, RobotSet able) {
  ++samples_;
  const BodyState& ball = bodies.back();
  const Vector place{ball.x, ball.y};
  const RobotSet goes = chasing(state, ball, able);
  bool neglected = false;
  int near = 0;
  for (const Side side : both_sides) {
    int nearest = -1, chasing = 0;
    double least = 0.0;  // m^2
    for (int number = 1; number <= roster_.team_size; ++number) {
      if (state.is_penalised(side, number)) continue;
      const int id = roster_.id(side, number);
      const BodyState& body = bodies[at(id)];
      const double distance = squared_length(Vector{body.x, body.y} - place);
      if (distance <= near_ball * near_ball) {
        ++teams_[index(side)].near;
        ++near;
      }
      if (!contains(able, id)) continue;
      if (nearest < 0 || distance < least) {
        nearest = id;
        least = distance;
      }
      if (contains(goes, id)) ++chasing;
    }
    Team& team = teams_[index(side)];
    if (chasing >= 2) ++team.several;
    if (nearest < 0) continue;
    ++team.nearest;
    if (contains(goes, nearest)) ++team.nearest_plays;
    const double reach = within_reach_[index(side)];
    if (least <= reach * reach) neglected = true;
  }
  if (near >= crowd) ++crowd_;
  if (!neglected || squared_length({ball.vx, ball.vy}) >= at_rest * at_rest) {
    resting_ = 0;
    return;
  }
  ++rest_;
  ++resting_;
  if (resting_ == 1) ++rests_;
  // Counted once, in the sample in which it becomes too long.
  constexpr int too_long = static_cast<int>(long_rest * samples_per_second) + 1;
  if (resting_ == too_long) ++long_rests_;
  longest_rest_ = std::max(longest_rest_, resting_);
}

BallMetrics BallMeasures::result(Side side) const {
  const Team& team = teams_[index(side)];
  return {share(team.nearest_plays, team.nearest), mean(team.near, samples_), seconds(team.several)};
}

BallRests BallMeasures::rests() const { return {seconds(rest_), rests_, long_rests_, seconds(longest_rest_)}; }

double BallMeasures::crowd_seconds() const { return seconds(crowd_); }

}  // namespace regista::match
