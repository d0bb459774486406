// SPDX-License-Identifier: MIT
#include "match/metrics_play.hpp"

#include <cmath>

#include "match/sampling.hpp"

namespace regista::match {

PlayMeasures::PlayMeasures(const config::Rules& rules)
    : roster_{rules.team_size},
      goal_line_((rules.field.length + rules.field.line_width + rules.ball.diameter) / 2.0),
      half_goal_(rules.field.goal_width / 2.0),
      deceleration_(rules.ball.rolling_deceleration),
      walked_(at(roster_.count())) {}

void PlayMeasures::step(const BodyState& ball, int touched_by, int half) {
  const Ball now{{ball.x, ball.y}, {ball.vx, ball.vy}};
  if (touched_by >= 0) touched(touched_by, now, half);
  ball_ = now;
}

bool PlayMeasures::on_target(Side side, const Ball& ball, int half) const {
  const double direction = attack(side, half);
  const double to_line = goal_line_ - direction * ball.position.x, towards = direction * ball.velocity.x;
  if (to_line <= 0.0 || towards <= 0.0) return false;
  const double time = to_line / towards;  // at this speed
  if (std::abs(ball.position.y + time * ball.velocity.y) >= half_goal_) return false;
  const double way = time * length(ball.velocity);
  return 2.0 * deceleration_ * way <= squared_length(ball.velocity);
}

void PlayMeasures::touched(int robot, const Ball& ball, int half) {
  const Side side = roster_.side(robot);
  if (passer_ && *passer_ != robot) {
    Team& passing = team(roster_.side(*passer_));
    ++(roster_.side(*passer_) == side ? passing.arrived : passing.intercepted);
    passer_.reset();
  }
  // A post may have turned it away.
  if (shot_ && !on_target(*shot_, ball_, half)) shot_.reset();
  bool saved = false;
  if (shot_ && !on_target(*shot_, ball, half)) {
    saved = side != *shot_;
    if (saved) ++team(*shot_).saved;
    shot_.reset();
  }
  if (!shot_ && on_target(side, ball, half)) {
    ++team(side).shots;
    shot_ = side;
  }
  if (last_ && last_->robot != robot && squared_length(ball.position - last_->ball) > shortest_pass * shortest_pass) {
    if (roster_.side(last_->robot) == side) {
      ++team(side).passes;
    } else if (!saved) {
      ++team(side).interceptions;
    }
  }
  last_ = {robot, ball.position};
}

void PlayMeasures::kicked(int id, int receiver) {
  passer_.reset();
  if (receiver == 0) return;
  passer_ = id;
  ++team(roster_.side(id)).meant;
}

void PlayMeasures::scored(Side side) {
  passer_.reset();
  if (shot_ == side) ++team(side).scored;
  shot_.reset();
}

void PlayMeasures::ball_placed() {
  passer_.reset();
  shot_.reset();
  last_.reset();
}

void PlayMeasures::sample(const GameState& state, std::span<const BodyState> bodies, std::optional<Side> last_touch) {
  for (int id = 0; id < roster_.count(); ++id) {
    if (state.is_penalised(roster_.side(id), roster_.number(id))) continue;
    const BodyState& body = bodies[at(id)];
    walked_[at(id)] += length({body.vx, body.vy}) / samples_per_second;
  }
  if (!state.in_play()) return;
  ++in_play_;
  if (last_touch) ++team(*last_touch).possession;
  for (const Side side : both_sides) {
    const double x = attack(side, state.half) * static_cast<double>(bodies.back().x);
    team(side).ball_x += x;
    if (x > 0.0) ++team(side).in_opponent_half;
  }
}

PlayMetrics PlayMeasures::result(Side side) const {
  const Team &own = teams_[index(side)], &other = teams_[index(opposite(side))];
  PlayMetrics out;
  out.shots = own.shots;
  out.shots_scored = own.scored;
  out.shots_saved = own.saved;
  out.passes = own.passes;
  out.interceptions = own.interceptions;
  out.meant_passes = own.meant;
  out.meant_passes_arrived = own.arrived;
  out.meant_passes_intercepted = own.intercepted;
  out.possession_seconds = static_cast<double>(own.possession) / samples_per_second;
  const int possessed = own.possession + other.possession;
  if (possessed > 0) out.possession_share = static_cast<double>(own.possession) / possessed;
  if (in_play_ > 0) {
    out.ball_x_metres = own.ball_x / in_play_;
    out.opponent_half_share = static_cast<double>(own.in_opponent_half) / in_play_;
  }
  for (int number = 1; number <= roster_.team_size; ++number) {
    const double walked = walked_[at(roster_.id(side, number))];
    out.robot_distance_metres.push_back(walked);
    out.distance_walked_metres += walked;
  }
  return out;
}

}  // namespace regista::match
