// SPDX-License-Identifier: MIT
#include "match/metrics_play.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "match/metrics.hpp"
#include "match/placement.hpp"

namespace regista::match {

void Clearances::kicked(int id, Vector ball, double direction, double time) {
  kick_.reset();
  direction_ = direction;
  if (direction * ball.x < -length_ / 6.0) kick_ = {id, time, ball};
}

std::optional<Begun> Clearances::rolled(Vector ball) {
  if (!kick_) return std::nullopt;
  const bool left = direction_ * ball.x >= -length_ / 6.0;
  const bool far = to_goal(ball) > to_goal(kick_->at) + cleared_way;
  return left || far ? std::exchange(kick_, std::nullopt) : std::nullopt;
}

void Duels::sample(std::span<const BodyState> bodies, RobotSet able, double time) {
  const Vector ball{bodies.back().x, bodies.back().y};
  const auto squared_distance = [&](int id) {
    return squared_length(Vector{bodies[at(id)].x, bodies[at(id)].y} - ball);
  };
  const std::array<int, 2> nearest{with_least(able & roster_.team(Side::home), squared_distance),
                                   with_least(able & roster_.team(Side::away), squared_distance)};
  holds_ =
      std::ranges::all_of(nearest, [&](int id) { return id >= 0 && squared_distance(id) <= duel_reach * duel_reach; });
  if (holds_) {
    const bool home_is_nearer = squared_distance(nearest[0]) <= squared_distance(nearest[1]);
    if (!duel_) duel_ = {nearest, home_is_nearer ? Side::home : Side::away, time, ball, 0, {}};
    ++duel_->samples;
  } else if (duel_ && seconds(duel_->samples) < shortest_duel) {
    duel_.reset();
  }
}

std::optional<Duels::Duel> Duels::ended(std::optional<Side> won) {
  holds_ = false;
  std::optional<Duel> out = std::exchange(duel_, std::nullopt);
  if (!out || seconds(out->samples) < shortest_duel) return std::nullopt;
  out->won = won;
  return out;
}

PlayMeasures::PlayMeasures(const config::Rules& rules)
    : roster_{rules.team_size},
      field_(rules.field),
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

void PlayMeasures::end(std::optional<Begun>& play, PlayOutcome outcome) {
  if (!play) return;
  PlayMetrics& own = counts(roster_.side(play->robot));
  if (outcome == PlayOutcome::goal) ++own.shots_scored;
  if (outcome == PlayOutcome::saved) ++own.shots_saved;
  if (outcome == PlayOutcome::arrived) ++own.meant_passes_arrived;
  if (outcome == PlayOutcome::intercepted) ++own.meant_passes_intercepted;
  tell(&play == &shot_ ? PlayKind::shot : PlayKind::pass, *play, outcome);
  play.reset();
}

void PlayMeasures::pass_met_by(int robot) {
  if (!pass_ || pass_->robot == robot) return;
  const bool own = roster_.side(pass_->robot) == roster_.side(robot);
  end(pass_, own ? PlayOutcome::arrived : PlayOutcome::intercepted);
}

void PlayMeasures::end_duel(const std::optional<Duels::Duel>& duel) {
  if (!duel) return;
  ++duel_count_;
  if (duel->won) ++counts(*duel->won).duels_won;
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
    ++counts(roster_.side(kick->robot)).clearances;
    tell(PlayKind::clearance, *kick, PlayOutcome::none);
  }
  ball_ = now;
}

bool PlayMeasures::on_target(Side side, const Ball& ball, int half) const {
  const double direction = attack(side, half);
  const double to_line = goal_line_ - direction * ball.position.x, towards = direction * ball.velocity.x;
  if (to_line <= 0.0 || towards <= 0.0) return false;
  const double time = to_line / towards;  // s until the ball reaches the line at constant speed
  if (std::abs(ball.position.y + time * ball.velocity.y) >= half_goal_) return false;
  const double way = time * length(ball.velocity);
  return 2.0 * deceleration_ * way <= squared_length(ball.velocity);
}

void PlayMeasures::touched(int robot, const Ball& ball, int half) {
  const Side side = roster_.side(robot);
  pass_met_by(robot);
  end_duel(duels_.touched(side));
  clearances_.touched(robot);
  // The shot has missed if the ball was not on target before this touch, for example after it hit a goal post.
  if (shot_ && !on_target(roster_.side(shot_->robot), ball_, half)) end(shot_, PlayOutcome::missed);
  bool saved = false;
  if (shot_ && !on_target(roster_.side(shot_->robot), ball, half)) {
    saved = side != roster_.side(shot_->robot);
    end(shot_, saved ? PlayOutcome::saved : PlayOutcome::missed);
  }
  if (!shot_ && on_target(side, ball, half)) {
    ++counts(side).shots;
    shot_ = {robot, now_, ball.position};
    clearances_.drop();
  }
  if (last_ && last_->robot != robot && squared_length(ball.position - last_->ball) > shortest_pass * shortest_pass) {
    if (roster_.side(last_->robot) == side) {
      ++counts(side).passes;
    } else if (!saved) {
      ++counts(side).interceptions;
    }
  }
  last_ = {robot, ball.position};
}

void PlayMeasures::kicked(int id, int receiver) {
  pass_met_by(id);
  end(pass_, PlayOutcome::lost);
  clearances_.drop();
  if (receiver == 0) {
    // A goal kick or other set play is not a clearance. In a set play ball_placed() has cleared last_.
    if (last_) clearances_.kicked(id, ball_.position, attack(roster_.side(id), half_), now_);
    return;
  }
  pass_ = {id, now_, ball_.position, receiver};
  ++counts(roster_.side(id)).meant_passes;
}

void PlayMeasures::scored(Side side) {
  end(pass_, PlayOutcome::lost);
  if (shot_) end(shot_, roster_.side(shot_->robot) == side ? PlayOutcome::goal : PlayOutcome::missed);
  end_duel(duels_.scored(side));
}

void PlayMeasures::ball_placed() {
  finish();
  last_.reset();
}

void PlayMeasures::finish() {
  end(pass_, PlayOutcome::lost);
  end(shot_, PlayOutcome::missed);
  end_duel(duels_.dead());
  clearances_.drop();
}

void PlayMeasures::sample(const GameState& state, std::span<const BodyState> bodies, std::optional<Side> last_touch,
                          RobotSet able) {
  const RobotSet active = roster_.everybody() & ~state.all_penalised(roster_);
  able &= active;
  for (const int id : Members(active)) {
    const BodyState& body = bodies[at(id)];
    walked_[at(id)] += length({body.vx, body.vy}) / samples_per_second;
  }
  if (!state.in_play()) {
    end_duel(duels_.dead());
    return;
  }
  duels_.sample(bodies, able, now_);
  ++in_play_;
  if (last_touch) ++teams_[index(*last_touch)].possession;
  for (const Side side : both_sides) {
    const double x = attack(side, state.half) * static_cast<double>(bodies.back().x);
    Team& team = teams_[index(side)];
    team.ball_x += x;
    if (x > 0.0) ++team.in_opponent_half;
    const RobotSet keepers = those(able & roster_.team(side), [&](int id) {
      return in_penalty_area(field_, -attack(side, state.half), {bodies[at(id)].x, bodies[at(id)].y});
    });
    if (keepers == 0) ++team.goal_empty;
  }
}

PlayMetrics PlayMeasures::result(Side side) const {
  const Team &own = teams_[index(side)], &other = teams_[index(opposite(side))];
  PlayMetrics out = own.counts;
  out.possession_seconds = seconds(own.possession);
  out.possession_share = share(own.possession, own.possession + other.possession);
  out.ball_x_metres = mean(own.ball_x, in_play_);
  out.goal_empty_seconds = seconds(own.goal_empty);
  out.opponent_half_share = share(own.in_opponent_half, in_play_);
  for (const int id : Members(roster_.team(side))) {
    const double walked = walked_[at(id)];
    out.robot_distance_metres.push_back(walked);
    out.distance_walked_metres += walked;
  }
  return out;
}

BallMeasures::BallMeasures(int team_size, const std::array<config::Robot, 2>& robots)
    : roster_{team_size}, decisions_(at(roster_.count())) {
  for (std::size_t i = 0; i < 2; ++i) within_reach_[i] = robots[i].body.radius + soon * robots[i].walk.forward;
}

RobotSet BallMeasures::chasing(const GameState& state, const BodyState& ball, RobotSet able) const {
  return those(able & roster_.everybody() & ~state.all_penalised(roster_), [&](int id) {
    const auto& [plays, kicks, target] = decisions_[at(id)];
    const Vector place = attack(roster_.side(id), state.half) * Vector{ball.x, ball.y};
    return plays || kicks || (target && squared_length(*target - place) <= for_the_ball * for_the_ball);
  });
}

void BallMeasures::sample(const GameState& state, std::span<const BodyState> bodies, RobotSet able) {
  ++samples_;
  const BodyState& ball = bodies.back();
  const RobotSet goes = chasing(state, ball, able);
  const auto squared_distance = [&](int id) {
    return squared_length(Vector{bodies[at(id)].x, bodies[at(id)].y} - Vector{ball.x, ball.y});
  };
  bool neglected = false;
  int near = 0;
  for (const Side side : both_sides) {
    Team& team = teams_[index(side)];
    const RobotSet active = roster_.team(side) & ~state.all_penalised(roster_);
    const int near_of_team =
        std::popcount(those(active, [&](int id) { return squared_distance(id) <= near_ball * near_ball; }));
    team.near += near_of_team;
    near += near_of_team;
    if (std::popcount(goes & active) >= 2) ++team.several;
    const int nearest = with_least(active & able, squared_distance);
    if (nearest < 0) continue;
    ++team.nearest;
    if (contains(goes, nearest)) ++team.nearest_plays;
    const double reach = within_reach_[index(side)];
    if (squared_distance(nearest) <= reach * reach) neglected = true;
  }
  if (near >= crowd) ++crowd_;
  if (!neglected || squared_length({ball.vx, ball.vy}) >= at_rest * at_rest) {
    resting_ = 0;
    return;
  }
  ++rest_;
  ++resting_;
  if (resting_ == 1) ++rests_;
  // A rest is counted as long once: in the first sample in which its length exceeds long_rest.
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
