// SPDX-License-Identifier: MIT
// The functions of Referee that watch, penalise, move and readmit robots. Phases, set plays and goals: referee.cpp.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "match/placement.hpp"
#include "match/referee.hpp"

namespace regista::match {
namespace {

using mind::Phase;
using mind::SetPlay;

constexpr double clearance = 0.05;  // m; gap between bodies when a person puts down a robot
constexpr double moved = 0.25;      // m; the game is not stuck when the ball moves farther

}  // namespace

bool Referee::on_goal_line(int id) const {
  const double line = -direction(roster_.side(id)) * rules_.field.length / 2.0;
  return std::fabs(where(id).x - line) <= robot_radius_ + rules_.field.line_width / 2.0;
}

void Referee::watch_set_play() {
  const Side defender = opposite(state_.kicking);
  RobotSet intruders = 0;
  if (state_.set_play == SetPlay::penalty_kick) {
    intruders = intruders_at_penalty_kick(rules_, state_, roster_, where_, playing());
    const int goalkeeper = roster_.id(defender, 1);
    const bool leaves_line = plays(goalkeeper) && !on_goal_line(goalkeeper) &&
                             in_penalty_area(rules_.field, -direction(defender), where(goalkeeper));
    if (leaves_line) intruders |= only(goalkeeper);
  } else if (state_.set_play == SetPlay::kick_off) {
    intruders = intruders_at_kick_off(rules_, state_, roster_, where_, playing());
  } else {
    const double near = rules_.set_play_distance;
    for (const int id : Members(roster_.team(defender))) {
      double& leave_by = leave_by_[at(id)];
      if (squared_length(where(id) - state_.spot) >= near * near) {
        leave_by = 0.0;
      } else if (plays(id) && since(leave_by, 0.0)) {
        intruders |= only(id);
      }
    }
  }
  for (const int id : Members(intruders)) penalise(id, Offence::illegal_position);
}

void Referee::watch_offences(const Scene& scene) {
  for (const Offender& offender : watch_.watch(scene, state_, playing())) {
    if (!plays(offender.robot)) continue;
    if (offender.offence == Offence::pushing) {
      pushed(offender);
    } else {
      penalise(offender.robot, offender.offence);
    }
  }
}

// Penalises the pusher. If the push was near the ball in open play, the other side gets a penalty kick or a free kick.
void Referee::pushed(const Offender& offender) {
  const Side side = roster_.side(offender.robot);
  const double near = rules_.offences.pushing_near_ball;
  const bool near_ball = squared_length(where(offender.robot) - ball_) <= near * near;
  const bool in_own_area = in_penalty_area(rules_.field, -direction(side), where(offender.victim));
  const bool open_play = state_.in_play();
  penalise(offender.robot, Offence::pushing);
  if (!near_ball || !open_play) return;
  if (in_own_area) {
    begin_ready(SetPlay::penalty_kick, opposite(side), penalty_mark(rules_.field, -direction(side)), false);
  } else {
    set_play(SetPlay::pushing_free_kick, opposite(side), ball_);
  }
}

void Referee::watch_progress() {
  if (squared_length(ball_ - anchor_) > moved * moved) anchor(ball_);
  if (!since(anchored_, rules_.durations.game_stuck)) return;
  const int nearest = with_least(playing(), [this](int id) { return squared_length(where(id) - ball_); });
  if (nearest < 0) return;
  const double near = rules_.offences.stuck_near_ball;
  if (squared_length(where(nearest) - ball_) <= near * near) {
    anchored_ = time_;
    penalise(nearest, Offence::local_game_stuck);
  } else if (touched_since_kick_off_) {
    note(EventKind::game_stuck, roster_.side(nearest));
    begin_ready(SetPlay::kick_off, roster_.side(nearest), {}, false);
  }
}

// Moves robots that touch the ball's place: the kicking side's just off the ball, others to set_play_distance.
void Referee::clear_spot(Vector spot) {
  const double touching = robot_radius_ + rules_.ball.diameter / 2.0 + clearance / 2.0;
  for (int id = 0; id < roster_.count(); ++id) {
    if (!plays(id) && !on_the_spot(box_.offence(id))) continue;  // the robot is not on the field
    const Side side = roster_.side(id);
    const Vector from_ball = where_[at(id)] - spot;
    if (squared_length(from_ball) >= touching * touching) continue;
    const double back = side == state_.kicking ? touching + clearance : rules_.set_play_distance + clearance;
    // The robot moves towards the middle of its own half, where there is always room.
    const Vector inside = Vector{-direction(side) * rules_.field.length / 4.0, 0.0} - spot;
    const Vector target = spot + back / std::max(length(inside), clearance) * inside;
    put_down(id, {target.x, target.y, std::atan2(-inside.y, -inside.x)});
  }
}

void Referee::remove_illegal_in_set() {
  const RobotSet illegal = illegal_in_set(rules_, state_, roster_, where_, playing(), robot_radius_);
  for (const int id : Members(illegal)) penalise(id, Offence::illegal_position_in_set);
}

// Puts the goalkeeper on its line before a penalty kick, unless it is on the line or outside its penalty area.
void Referee::put_goalkeeper_on_line() {
  const Side side = opposite(state_.kicking);
  const int id = roster_.id(side, 1);
  const double end = -direction(side), line = end * rules_.field.length / 2.0;
  if (!plays(id) || !in_penalty_area(rules_.field, end, where(id)) || on_goal_line(id)) return;
  const double between = std::max(0.0, rules_.field.goal_width / 2.0 - robot_radius_);
  put_down(id, {line, std::clamp(where(id).y, -between, between), direction(side) > 0.0 ? 0.0 : std::numbers::pi});
  note(EventKind::put_back, side, 1);
}

void Referee::put_down(int id, const mind::Pose& wanted) {
  const double robot_gap = 2.0 * robot_radius_ + clearance;
  const double ball_gap = robot_radius_ + rules_.ball.diameter / 2.0 + clearance;
  const Vector ball = calls_.ball ? *calls_.ball : state_.phase == Phase::playing ? ball_ : state_.spot;
  const Vector spot = free_spot(rules_.field, {wanted.x, wanted.y}, id, where_, robot_gap, ball, ball_gap);
  where_[at(id)] = spot;
  watch_.forget(id);
  calls_.placements.push_back({id, {spot.x, spot.y, wanted.heading}});
}

void Referee::penalise(int id, Offence offence) {
  const Side side = roster_.side(id);
  box_.send(id, offence);
  watch_.forget(id);
  state_.penalised[index(side)] |= 1u << (roster_.number(id) - 1);
  if (on_the_spot(offence)) {
    calls_.frozen |= only(id);
  } else {
    calls_.removed.push_back(id);
  }
  note(EventKind::penalty, side, roster_.number(id), offence);
}

void Referee::let_back_in() {
  for (int id = 0; id < roster_.count(); ++id) {
    if (plays(id) || !box_.served(id) || contains(calls_.frozen, id)) continue;
    const Side side = roster_.side(id);
    box_.release(id);
    state_.penalised[index(side)] &= ~(1u << (roster_.number(id) - 1));
    if (on_the_spot(box_.offence(id))) {
      leave_by_[at(id)] = time_ + rules_.offences.leave_free_kick;
    } else {
      // If another robot is at the place, put_down() uses the nearest free place.
      put_down(id, re_entry_pose(rules_.field, direction(side), ball_, id, where_, 2.0 * robot_radius_ + clearance));
    }
    note(EventKind::returned, side, roster_.number(id));
  }
}

}  // namespace regista::match
