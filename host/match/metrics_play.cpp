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
      walked_(at(roster_.count())),
      clearances_(rules.field),
      duels_(rules.team_size) {}

void PlayMeasures::tell(PlayKind kind, const Begun& begun, PlayOutcome outcome) const {
  if (!tell_) return;
  tell_(now_, {.kind = kind,
               .side = roster_.side(begun.robot),
               .number = roster_.number(begun.robot),
               .began = begun.began,
               .at = begun.at,
               .outcome = outcome,
               .receiver = begun.receiver});
}

void PlayMeasures::end_shot(PlayOutcome outcome) {
  if (!shot_) return;
  Team& shooting = team(roster_.side(shot_->robot));
  if (outcome == PlayOutcome::goal) ++shooting.scored;
  if (outcome == PlayOutcome::saved) ++shooting.saved;
  tell(PlayKind::shot, *shot_, outcome);
  shot_.reset();
}

void PlayMeasures::end_pass(PlayOutcome outcome) {
  if (!pass_) return;
  Team& passing = team(roster_.side(pass_->robot));
  if (outcome == PlayOutcome::arrived) ++passing.arrived;
  if (outcome == PlayOutcome::intercepted) ++passing.intercepted;
  tell(PlayKind::pass, *pass_, outcome);
  pass_.reset();
}

void PlayMeasures::pass_met_by(int robot) {
  if (!pass_ || pass_->robot == robot) return;
  const bool own = roster_.side(pass_->robot) == roster_.side(robot);
  end_pass(own ? PlayOutcome::arrived : PlayOutcome::intercepted);
}

void PlayMeasures::end_duel(const std::optional<Duels::Duel>& duel) {
  if (!duel) return;
  ++duel_count_;
  if (duel->won) ++team(*duel->won).duels_won;
  if (!tell_) return;
  const Side side = duel->nearer;
  const PlayOutcome outcome = !duel->won           ? PlayOutcome::undecided
                              : *duel->won == side ? PlayOutcome::won
                                                   : PlayOutcome::lost;
  tell_(now_, {.kind = PlayKind::duel,
               .side = side,
               .number = roster_.number(duel->robots[index(side)]),
               .began = duel->began,
               .at = duel->at,
               .outcome = outcome,
               .opponent = roster_.number(duel->robots[index(opposite(side))]),
               .duration = seconds(duel->samples)});
}

void PlayMeasures::step(const BodyState& ball, int touched_by, int half) {
  const Ball now{{ball.x, ball.y}, {ball.vx, ball.vy}};
  half_ = half;
  if (touched_by >= 0) touched(touched_by, now, half);
  if (const auto kick = clearances_.rolled(now.position)) {
    ++team(roster_.side(kick->id)).clearances;
    tell(PlayKind::clearance, {kick->id, kick->began, kick->at}, PlayOutcome::none);
  }
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
  pass_met_by(robot);
  end_duel(duels_.touched(side));
  clearances_.touched(robot);
  // A post may have turned it away.
  if (shot_ && !on_target(roster_.side(shot_->robot), ball_, half)) end_shot(PlayOutcome::missed);
  bool saved = false;
  if (shot_ && !on_target(roster_.side(shot_->robot), ball, half)) {
    saved = side != roster_.side(shot_->robot);
    end_shot(saved ? PlayOutcome::saved : PlayOutcome::missed);
  }
  if (!shot_ && on_target(side, ball, half)) {
    ++team(side).shots;
    shot_ = {robot, now_, ball.position};
    clearances_.drop();
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
  pass_met_by(id);
  end_pass(PlayOutcome::lost);
  clearances_.drop();
  if (receiver == 0) {
    // Nobody has touched it since it was put down: a goal kick, or another set play.
    if (last_) clearances_.kicked(id, ball_.position, attack(roster_.side(id), half_), now_);
    return;
  }
  pass_ = {id, now_, ball_.position, receiver};
  ++team(roster_.side(id)).meant;
}

void PlayMeasures::scored(Side side) {
  end_pass(PlayOutcome::lost);
  if (shot_) end_shot(roster_.side(shot_->robot) == side ? PlayOutcome::goal : PlayOutcome::missed);
  end_duel(duels_.scored(side));
}

void PlayMeasures::ball_placed() {
  finish();
  last_.reset();
}

void PlayMeasures::finish() {
  end_pass(PlayOutcome::lost);
  end_shot(PlayOutcome::missed);
  end_duel(duels_.dead());
  clearances_.drop();
}

void PlayMeasures::sample(const GameState& state, std::span<const BodyState> bodies, std::optional<Side> last_touch,
                          RobotSet able) {
  for (int id = 0; id < roster_.count(); ++id) {
    if (state.is_penalised(roster_.side(id), roster_.number(id))) {
      able &= ~only(id);
      continue;
    }
    const BodyState& body = bodies[at(id)];
    walked_[at(id)] += length({body.vx, body.vy}) / samples_per_second;
  }
  if (!state.in_play()) {
    end_duel(duels_.dead());
    return;
  }
  duels_.sample(bodies, able, now_);
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
  out.clearances = own.clearances;
  out.duels_won = own.duels_won;
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
