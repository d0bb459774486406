// SPDX-License-Identifier: MIT
#include "match/referee.hpp"

#include <algorithm>
#include <cmath>

#include "match/placement.hpp"

namespace regista::match {
namespace {

using mind::Phase;
using mind::SetPlay;

constexpr double initial_lasts = 1.0;  // s; see the head of referee.hpp
constexpr double leave_within = 5.0;   // s; see there
constexpr double clearance = 0.05;     // m between bodies when something is put down

bool is_indirect(SetPlay kind) {
  return kind == SetPlay::kick_in || kind == SetPlay::goal_kick || kind == SetPlay::corner_kick;
}

}  // namespace

const char* name(EventKind kind) {
  constexpr std::array names{"half begins",      "ready",     "set",       "kick-off",    "goal",
                             "goal not counted", "kick-in",   "goal kick", "corner kick", "ball free",
                             "game stuck",       "penalty",   "returned",  "put back",    "too many packets",
                             "packet too long",  "half ends", "finished",  "opening"};
  return names[static_cast<std::size_t>(kind)];
}

void Calls::clear() {
  removed.clear();
  placements.clear();
  ball.reset();
  ball_velocity.reset();
  whistle = announced = told_late = ball_came_free = false;
  events.clear();
}

int Referee::allowance(const config::Messages& messages, double added) {
  return messages.budget + messages.extra_per_minute * static_cast<int>(added / 60.0);
}

Referee::Referee(const config::Rules& rules, double robot_radius, const config::Opening* opening)
    : rules_(rules), opening_(opening), roster_{rules.team_size}, robot_radius_(robot_radius) {
  where_.resize(static_cast<std::size_t>(roster_.count()));
  back_at_.resize(where_.size());
  calls_.removed.reserve(where_.size());
  calls_.placements.reserve(where_.size());
  calls_.events.reserve(64);
  pending_.reserve(64);
  state_.packets_left.fill(allowance(rules_.messages, 0.0));
}

// Durations are met at the nearest instant, whatever the rounding of time.
bool Referee::since(double moment, double duration) const { return time_ - moment >= duration - 1e-6; }

void Referee::note(EventKind kind, Side side, int number) { calls_.events.push_back({kind, side, number}); }

void Referee::announce(bool late) {
  calls_.announced = true;
  calls_.told_late = late;
}

const Calls& Referee::update(const Scene& scene) {
  calls_.clear();
  if (state_.phase == Phase::finished) return calls_;
  time_ = scene.time;
  ball_ = scene.ball;
  std::copy(scene.robots.begin(), scene.robots.end(), where_.begin());
  if (!began_) {
    began_ = true;
    if (opening_ != nullptr) {
      begin_in_play(*opening_);
    } else {
      begin_half();
    }
    return calls_;
  }
  calls_.events.insert(calls_.events.end(), pending_.begin(), pending_.end());
  if (!pending_.empty()) announce();
  pending_.clear();

  if (state_.clock_runs) state_.clock = time_ - clock_began_;
  if (std::abs(state_.goals[0] - state_.goals[1]) >= rules_.mercy_difference) {
    finish(Ended::mercy);
    return calls_;
  }
  if (state_.clock_runs && since(clock_began_, rules_.durations.half)) {
    end_half();
    return calls_;
  }
  switch (state_.phase) {
    case Phase::initial:
      if (since(state_.phase_began, initial_lasts)) begin_ready(state_.kicking, false);
      break;
    case Phase::ready:
      if (since(state_.phase_began, rules_.durations.ready)) begin_set();
      break;
    case Phase::set:
      if (since(state_.phase_began, rules_.durations.set)) kick_off();
      break;
    case Phase::playing:
      if (scene.touched_by >= 0) touch(scene.touched_by);
      play();
      break;
    case Phase::finished:
      break;
  }
  if (state_.penalised[0] != 0 || state_.penalised[1] != 0) let_back_in();
  return calls_;
}

void Referee::begin_half() {
  state_.phase = Phase::initial;
  state_.set_play = SetPlay::none;
  state_.kicking = state_.half % 2 == 1 ? Side::home : Side::away;
  state_.phase_began = time_;
  state_.clock_runs = false;
  state_.clock = 0.0;
  state_.penalised.fill(0);
  state_.spot = {};
  last_touch_ = -1;
  indirect_ = false;
  calls_.ball = state_.spot;
  for (int id = 0; id < roster_.count(); ++id) {
    const mind::Pose pose = start_pose(rules_.field, direction(roster_.side(id)), roster_.number(id), rules_.team_size);
    where_[static_cast<std::size_t>(id)] = {pose.x, pose.y};
    calls_.placements.push_back({id, pose});
  }
  announce();
  note(EventKind::half_begins, state_.kicking);
}

void Referee::begin_in_play(const config::Opening& opening) {
  state_.phase = Phase::playing;
  state_.phase_began = time_;
  state_.clock_runs = true;
  clock_began_ = time_;
  last_action_ = time_;
  state_.spot = {opening.ball.at[0], opening.ball.at[1]};
  calls_.ball = state_.spot;
  calls_.ball_velocity = Vector{opening.ball.velocity[0], opening.ball.velocity[1]};
  for (int id = 0; id < roster_.count(); ++id) {
    const auto& players = roster_.side(id) == Side::home ? opening.home : opening.away;
    const config::Opening::Player& player = players[static_cast<std::size_t>(roster_.number(id) - 1)];
    where_[static_cast<std::size_t>(id)] = {player.at[0], player.at[1]};
    calls_.placements.push_back({id, {player.at[0], player.at[1], config::heading(opening, player)}});
  }
  announce();
  note(EventKind::opening, state_.kicking);
}

void Referee::begin_ready(Side kicking, bool told_late) {
  state_.phase = Phase::ready;
  state_.set_play = SetPlay::kick_off;
  state_.kicking = kicking;
  state_.phase_began = time_;
  state_.spot = {};
  indirect_ = false;
  calls_.ball = state_.spot;
  clear_spot(state_.spot);
  announce(told_late);
  note(EventKind::ready, kicking);
}

void Referee::begin_set() {
  state_.phase = Phase::set;
  state_.phase_began = time_;
  calls_.ball = state_.spot;
  put_back_illegal();
  announce();
  note(EventKind::set, state_.kicking);
}

void Referee::kick_off() {
  state_.phase = Phase::playing;
  state_.phase_began = time_;
  calls_.ball = state_.spot;
  put_back_illegal();
  was_near_ = 0;
  last_action_ = time_;
  last_touch_ = -1;
  if (!state_.clock_runs) {
    state_.clock_runs = true;
    clock_began_ = time_;
  }
  calls_.whistle = true;
  announce(true);
  note(EventKind::kick_off, state_.kicking);
}

void Referee::end_half() {
  state_.clock = rules_.durations.half;
  state_.clock_runs = false;
  note(EventKind::half_ends, state_.kicking);
  if (state_.half == rules_.durations.halves) {
    finish(Ended::full_time);
    return;
  }
  ++state_.half;
  begin_half();
}

void Referee::finish(Ended how) {
  state_.phase = Phase::finished;
  state_.set_play = SetPlay::none;
  state_.phase_began = time_;
  state_.clock_runs = false;
  state_.ended = how;
  announce();
  note(EventKind::finished, Side::home);
}

void Referee::touch(int robot) {
  last_action_ = time_;
  last_touch_ = robot;
  if (state_.set_play != SetPlay::none) {
    indirect_ = is_indirect(state_.set_play);
    first_touch_ = robot;
    free_ball();
  } else if (indirect_) {
    const double circle = rules_.set_play_distance;
    if (robot != first_touch_ || squared_length(ball_ - state_.spot) > circle * circle) indirect_ = false;
  }
}

void Referee::play() {
  if (ball_left()) return;
  if (state_.set_play != SetPlay::none) {
    const bool at_kick_off = state_.set_play == SetPlay::kick_off;
    if (since(state_.phase_began, at_kick_off ? rules_.durations.kick_off_free_after : rules_.durations.set_play)) {
      last_action_ = time_;
      free_ball();
    } else {
      watch_distances();
    }
  } else if (since(last_action_, rules_.durations.game_stuck)) {
    const Side other = last_touch_ >= 0 ? opposite(roster_.side(last_touch_)) : opposite(state_.kicking);
    note(EventKind::game_stuck, other);
    begin_ready(other, false);
  }
}

// The ball is out, or in a goal, when all of it has crossed the line.
bool Referee::ball_left() {
  const config::FieldSize& field = rules_.field;
  const double beyond = (field.line_width + rules_.ball.diameter) / 2.0;
  const bool over_goal_line = std::fabs(ball_.x) > field.length / 2.0 + beyond;
  const bool over_touch_line = std::fabs(ball_.y) > field.width / 2.0 + beyond;
  if (!over_goal_line && !over_touch_line) return false;

  // Who defends the end over whose goal line the ball went, and who touched it last; nobody: the other side's ball.
  const Side defender = (direction(Side::home) > 0.0) == (ball_.x > 0.0) ? Side::away : Side::home;
  const Side last = last_touch_ >= 0 ? roster_.side(last_touch_) : opposite(defender);
  const bool between_posts = std::fabs(ball_.y) < (field.goal_width + field.post_diameter) / 2.0;
  if (over_goal_line && between_posts && !indirect_) {
    goal(opposite(defender));
  } else if (!over_goal_line) {
    set_play(SetPlay::kick_in, opposite(last), kick_in_spot(field, ball_));
  } else {
    if (between_posts) note(EventKind::goal_not_counted, opposite(defender));
    if (last == defender) {
      set_play(SetPlay::corner_kick, opposite(defender), corner_spot(field, ball_));
    } else {
      set_play(SetPlay::goal_kick, defender, goal_kick_spot(field, ball_));
    }
  }
  return true;
}

void Referee::goal(Side scorer) {
  if (state_.sanctioned[index(scorer)]) {
    note(EventKind::goal_not_counted, scorer);
  } else {
    ++state_.goals[index(scorer)];
    note(EventKind::goal, scorer, last_touch_ >= 0 ? roster_.number(last_touch_) : 0);
  }
  calls_.whistle = true;
  begin_ready(opposite(scorer), true);
}

void Referee::set_play(SetPlay kind, Side kicking, Vector spot) {
  state_.set_play = kind;
  state_.kicking = kicking;
  state_.phase_began = time_;
  state_.spot = spot;
  indirect_ = true;
  first_touch_ = -1;
  calls_.ball = spot;
  clear_spot(spot);
  was_near_ = 0;
  const double near = rules_.set_play_distance;
  for (int id = 0; id < roster_.count(); ++id) {
    if (squared_length(where_[static_cast<std::size_t>(id)] - spot) < near * near) was_near_ |= only(id);
  }
  announce();
  note(kind == SetPlay::kick_in     ? EventKind::kick_in
       : kind == SetPlay::goal_kick ? EventKind::goal_kick
                                    : EventKind::corner_kick,
       kicking);
}

void Referee::free_ball() {
  const bool was_kick_off = state_.set_play == SetPlay::kick_off;
  state_.set_play = SetPlay::none;
  state_.phase_began = time_;
  announce();
  calls_.ball_came_free = was_kick_off;
  note(EventKind::ball_free, state_.kicking);
}

void Referee::watch_distances() {
  const bool at_kick_off = state_.set_play == SetPlay::kick_off;
  const double near = at_kick_off ? rules_.field.centre_circle_diameter / 2.0 : rules_.set_play_distance;
  const bool time_to_leave = !at_kick_off && !since(state_.phase_began, leave_within);
  const Side defender = opposite(state_.kicking);
  for (int number = 1; number <= rules_.team_size; ++number) {
    const int id = roster_.id(defender, number);
    if (squared_length(where_[static_cast<std::size_t>(id)] - state_.spot) >= near * near) {
      was_near_ &= ~only(id);
    } else if (plays(id) && !(time_to_leave && contains(was_near_, id))) {
      penalise(id);
    }
  }
}

// Nobody stands where the ball is put: the kicking side steps back a little, the other side to where it must be.
void Referee::clear_spot(Vector spot) {
  const double touching = robot_radius_ + rules_.ball.diameter / 2.0 + clearance / 2.0;
  for (int id = 0; id < roster_.count(); ++id) {
    if (!plays(id)) continue;
    const Side side = roster_.side(id);
    const Vector from_ball = where_[static_cast<std::size_t>(id)] - spot;
    if (squared_length(from_ball) >= touching * touching) continue;
    const double back = side == state_.kicking ? touching + clearance : rules_.set_play_distance + clearance;
    // Towards the inside of the field and the own goal, where there is always room.
    const Vector inside = Vector{-direction(side) * rules_.field.length / 4.0, 0.0} - spot;
    const Vector target = spot + back / std::max(length(inside), clearance) * inside;
    put_down(id, {target.x, target.y, std::atan2(-inside.y, -inside.x)});
  }
}

bool Referee::legal_in_set(int id) const {
  const Side side = roster_.side(id);
  const Vector at = where_[static_cast<std::size_t>(id)];
  const double on_ball = robot_radius_ + rules_.ball.diameter / 2.0, circle = rules_.field.centre_circle_diameter / 2.0;
  const double free = side == state_.kicking ? on_ball : circle;
  return at.x * direction(side) <= 0.0 && squared_length(at - state_.spot) >= free * free;
}

void Referee::put_back_illegal() {
  for (int id = 0; id < roster_.count(); ++id) {
    if (!plays(id) || legal_in_set(id)) continue;
    const Side side = roster_.side(id);
    put_down(id, manual_pose(rules_.field, direction(side), roster_.number(id), rules_.team_size));
    note(EventKind::put_back, side, roster_.number(id));
  }
}

void Referee::put_down(int id, const mind::Pose& wanted) {
  const double robot_gap = 2.0 * robot_radius_ + clearance;
  const double ball_gap = robot_radius_ + rules_.ball.diameter / 2.0 + clearance;
  const Vector ball = calls_.ball ? *calls_.ball : state_.phase == Phase::playing ? ball_ : state_.spot;
  const Vector spot = free_spot(rules_.field, {wanted.x, wanted.y}, id, where_, robot_gap, ball, ball_gap);
  where_[static_cast<std::size_t>(id)] = spot;
  calls_.placements.push_back({id, {spot.x, spot.y, wanted.heading}});
}

void Referee::penalise(int id) {
  const Side side = roster_.side(id);
  const config::Penalties& penalties = rules_.penalties;
  state_.penalised[index(side)] |= 1u << (roster_.number(id) - 1);
  back_at_[static_cast<std::size_t>(id)] =
      time_ + penalties.removal + penalties.removal_growth * offences_[index(side)];
  ++offences_[index(side)];
  calls_.removed.push_back(id);
  note(EventKind::penalty, side, roster_.number(id));
}

void Referee::let_back_in() {
  for (int id = 0; id < roster_.count(); ++id) {
    if (plays(id) || !since(back_at_[static_cast<std::size_t>(id)], 0.0)) continue;
    const Side side = roster_.side(id);
    state_.penalised[index(side)] &= ~(1u << (roster_.number(id) - 1));
    put_down(id, re_entry_pose(rules_.field, direction(side), ball_));
    note(EventKind::returned, side, roster_.number(id));
  }
}

void Referee::sanction(Side side, EventKind why) {
  if (state_.sanctioned[index(side)]) return;
  state_.sanctioned[index(side)] = true;
  state_.goals[index(side)] = 0;
  pending_.push_back({why, side, 0});
}

bool Referee::packet(Side side, std::size_t bytes) {
  if (state_.phase != Phase::ready && state_.phase != Phase::set && state_.phase != Phase::playing) return false;
  ++state_.packets[index(side)];
  int& left = state_.packets_left[index(side)];
  if (left == 0) {
    sanction(side, EventKind::too_many_packets);
  } else {
    --left;
  }
  if (bytes <= static_cast<std::size_t>(rules_.messages.size)) return true;
  sanction(side, EventKind::packet_too_long);
  return false;
}

}  // namespace regista::match
