// SPDX-License-Identifier: MIT
#include "match/referee.hpp"

#include <algorithm>
#include <cmath>

#include "match/placement.hpp"

namespace regista::match {
namespace {

using mind::Phase;
using mind::SetPlay;

EventKind event_of(SetPlay kind) {
  constexpr std::array events{EventKind::ready,       EventKind::ready,       EventKind::kick_in,
                              EventKind::goal_kick,   EventKind::corner_kick, EventKind::pushing_free_kick,
                              EventKind::penalty_kick};
  return events[static_cast<std::size_t>(kind)];
}

constexpr double touch_is_over = 0.5;  // s; a touch after a longer time without contact is a second touch
constexpr double dribbles = 0.3;       // s; a dribbling robot touches the ball for this time; a bounce is shorter

}  // namespace

void IndirectKick::touched(int id, Side side, bool kicked, Vector ball, double time) {
  if (kind_ == Kind::none) return;
  if (taker_ < 0 && side == side_) taker_ = id;
  if (id != taker_) {
    if (id != other_ || time - until_ > touch_is_over) since_ = time;
    other_ = id;
    until_ = time;
    if (kind_ == Kind::penalty_kick || kicked || until_ - since_ >= dribbles) over();
    return;
  }
  if (kind_ == Kind::free_kick && played_on_ && kicked) over();
  if (kind_ == Kind::penalty_kick && touched_ > 0.0 && time - touched_ > touch_is_over) played_on_ = true;
  left_at_ = ball;
  touched_ = time;
}

void IndirectKick::ball_at(Vector ball) {
  if (kind_ == Kind::free_kick && taker_ >= 0 && squared_length(ball - left_at_) > circle_ * circle_) played_on_ = true;
}

bool IndirectKick::may_score(Side side) const {
  if (kind_ == Kind::none || side != side_) return true;
  return kind_ == Kind::penalty_kick && !played_on_;
}

void Calls::clear() {
  removed.clear();
  frozen = 0;
  placements.clear();
  ball.reset();
  ball_velocity.reset();
  whistle = announced = told_late = ball_came_free = false;
  events.clear();
}

Referee::Referee(const config::Rules& rules, double robot_radius, const config::Opening* opening)
    : rules_(rules),
      opening_(opening),
      roster_{rules.team_size},
      robot_radius_(robot_radius),
      indirect_(rules.set_play_distance),
      watch_(rules, roster_),
      box_(rules.penalties, roster_) {
  where_.resize(at(roster_.count()));
  leave_by_.resize(where_.size());
  calls_.removed.reserve(where_.size());
  calls_.placements.reserve(where_.size());
  calls_.events.reserve(64);
  pending_.reserve(64);
  state_.packets_left.fill(config::packets(rules_.messages));
}

void Referee::note(EventKind kind, Side side, int number, Offence offence) {
  calls_.events.push_back({kind, side, number, offence});
}

void Referee::announce(bool late) {
  calls_.announced = true;
  calls_.told_late = late;
}

const Calls& Referee::update(const Scene& scene) {
  calls_.clear();
  if (state_.phase == Phase::finished) return calls_;
  const double passed = scene.time - time_;
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
  if (state_.phase == Phase::ready || state_.phase == Phase::playing) box_.pass(passed);
  switch (state_.phase) {
    case Phase::initial:
      if (since(state_.phase_began, config::Durations::initial))
        begin_ready(SetPlay::kick_off, state_.kicking, {}, false);
      break;
    case Phase::ready:
      watch_offences(scene);
      if (since(state_.phase_began, state_.set_play == SetPlay::penalty_kick ? rules_.durations.penalty_kick_ready
                                                                             : rules_.durations.ready)) {
        begin_set();
      }
      break;
    case Phase::set:
      watch_offences(scene);
      if (since(state_.phase_began, rules_.durations.set)) whistle_play();
      break;
    case Phase::playing:
      play(scene);
      break;
    case Phase::finished:
      break;
  }
  if (box_.inside() != 0 && state_.phase != Phase::initial) let_back_in();
  return calls_;
}

void Referee::begin_half() {
  enter(Phase::initial);
  state_.set_play = SetPlay::none;
  state_.kicking = state_.half % 2 == 1 ? Side::home : Side::away;
  state_.clock_runs = false;
  state_.clock = 0.0;
  state_.penalised.fill(0);
  box_.empty();
  state_.spot = {};
  last_touch_ = -1;
  indirect_.over();
  calls_.ball = state_.spot;
  for (int id = 0; id < roster_.count(); ++id) {
    const mind::Pose pose = start_pose(rules_.field, direction(roster_.side(id)), roster_.number(id), rules_.team_size);
    where_[at(id)] = {pose.x, pose.y};
    watch_.forget(id);
    calls_.placements.push_back({id, pose});
  }
  announce();
  note(EventKind::half_begins, state_.kicking);
}

void Referee::begin_in_play(const config::Opening& opening) {
  enter(Phase::playing);
  state_.clock_runs = true;
  clock_began_ = time_;
  touched_since_kick_off_ = true;
  state_.spot = {opening.ball.at[0], opening.ball.at[1]};
  anchor(state_.spot);
  calls_.ball = state_.spot;
  calls_.ball_velocity = Vector{opening.ball.velocity[0], opening.ball.velocity[1]};
  for (int id = 0; id < roster_.count(); ++id) {
    const auto& players = roster_.side(id) == Side::home ? opening.home : opening.away;
    const config::Opening::Player& player = players[at(roster_.number(id) - 1)];
    where_[at(id)] = {player.at[0], player.at[1]};
    calls_.placements.push_back({id, {player.at[0], player.at[1], config::heading(opening, player)}});
  }
  announce();
  note(EventKind::opening, state_.kicking);
}

void Referee::begin_ready(SetPlay kind, Side kicking, Vector spot, bool told_late) {
  enter(Phase::ready);
  state_.set_play = kind;
  state_.kicking = kicking;
  state_.spot = spot;
  indirect_.over();
  calls_.ball = state_.spot;
  clear_spot(state_.spot);
  announce(told_late);
  note(event_of(kind), kicking);
}

void Referee::begin_set() {
  enter(Phase::set);
  calls_.ball = state_.spot;
  remove_illegal_in_set();
  if (state_.set_play == SetPlay::penalty_kick) put_goalkeeper_on_line();
  announce();
  note(EventKind::set, state_.kicking);
}

void Referee::whistle_play() {
  enter(Phase::playing);
  calls_.ball = state_.spot;
  remove_illegal_in_set();
  std::ranges::fill(leave_by_, 0.0);
  last_touch_ = -1;
  touched_since_kick_off_ = false;
  anchor(state_.spot);
  if (!state_.clock_runs) {
    state_.clock_runs = true;
    clock_began_ = time_;
  }
  calls_.whistle = true;
  announce(true);
  note(state_.set_play == SetPlay::penalty_kick ? EventKind::whistle : EventKind::kick_off, state_.kicking);
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
  enter(Phase::finished);
  state_.set_play = SetPlay::none;
  state_.clock_runs = false;
  state_.ended = how;
  announce();
  note(EventKind::finished, Side::home);
}

void Referee::touch(const Scene& scene) {
  const int robot = scene.touched_by;
  const Side side = roster_.side(robot);
  if (state_.set_play != SetPlay::none) {
    if (side != state_.kicking) {  // the ball is put back
      calls_.ball = ball_ = state_.spot;
      if (plays(robot)) penalise(robot, Offence::illegal_position);
      return;
    }
    if (state_.set_play == SetPlay::penalty_kick) indirect_.penalty_kick(side);
    free_ball();
  }
  indirect_.touched(robot, side, scene.kicked, ball_, time_);
  last_touch_ = robot;
  touched_since_kick_off_ = true;
}

void Referee::play(const Scene& scene) {
  if (scene.touched_by >= 0) touch(scene);
  if (ball_left()) return;
  indirect_.ball_at(ball_);
  watch_offences(scene);
  if (state_.phase != Phase::playing) return;  // watch_offences() may have awarded a penalty kick
  if (state_.set_play == SetPlay::none) {
    watch_progress();
    return;
  }
  const double lasts = state_.set_play == SetPlay::kick_off       ? rules_.durations.kick_off_free_after
                       : state_.set_play == SetPlay::penalty_kick ? rules_.durations.penalty_kick
                                                                  : rules_.durations.set_play;
  if (since(state_.phase_began, lasts)) {
    free_ball();
  } else {
    watch_set_play();
  }
}

// If the whole ball has crossed a line, awards the goal or set play and returns true.
bool Referee::ball_left() {
  const config::FieldSize& field = rules_.field;
  const double beyond = (field.line_width + rules_.ball.diameter) / 2.0;
  const bool over_goal_line = std::fabs(ball_.x) > field.length / 2.0 + beyond;
  const bool over_touch_line = std::fabs(ball_.y) > field.width / 2.0 + beyond;
  if (!over_goal_line && !over_touch_line) return false;

  // defender: the side of the nearer goal line. last: the side of the last touch; without a touch, the other side.
  const Side defender = (direction(Side::home) > 0.0) == (ball_.x > 0.0) ? Side::away : Side::home;
  const Side last = last_touch_ >= 0 ? roster_.side(last_touch_) : opposite(defender);
  const bool between_posts = std::fabs(ball_.y) < (field.goal_width + field.post_diameter) / 2.0;
  if (!over_goal_line) {
    set_play(SetPlay::kick_in, opposite(last), kick_in_spot(field, ball_));
  } else if (between_posts && goal_counts(opposite(defender))) {
    goal(opposite(defender));
  } else if (between_posts || last != defender) {
    if (between_posts) note(EventKind::goal_not_counted, opposite(defender));
    set_play(SetPlay::goal_kick, defender, goal_kick_spot(field, ball_));
  } else {
    set_play(SetPlay::corner_kick, opposite(defender), corner_spot(field, ball_));
  }
  return true;
}

bool Referee::goal_counts(Side scorer) const {
  const bool own_goal = last_touch_ >= 0 && roster_.side(last_touch_) != scorer;
  const std::uint32_t everybody = (1u << roster_.team_size) - 1u;
  if (own_goal && state_.penalised[index(scorer)] == everybody) return false;  // every robot of `scorer` is penalised
  return indirect_.may_score(scorer);
}

void Referee::goal(Side scorer) {
  if (state_.sanctioned[index(scorer)]) {
    note(EventKind::goal_not_counted, scorer);
  } else {
    ++state_.goals[index(scorer)];
    const bool own_goal = last_touch_ < 0 || roster_.side(last_touch_) != scorer;
    note(EventKind::goal, scorer, own_goal ? 0 : roster_.number(last_touch_));
  }
  calls_.whistle = true;
  begin_ready(SetPlay::kick_off, opposite(scorer), {}, true);
}

void Referee::set_play(SetPlay kind, Side kicking, Vector spot) {
  state_.set_play = kind;
  state_.kicking = kicking;
  state_.phase_began = time_;
  state_.spot = spot;
  indirect_.free_kick(kicking);
  calls_.ball = spot;
  clear_spot(spot);
  for (int id = 0; id < roster_.count(); ++id) {
    const bool near = squared_length(where(id) - spot) < rules_.set_play_distance * rules_.set_play_distance;
    leave_by_[at(id)] = near ? time_ + rules_.offences.leave_free_kick : 0.0;
  }
  announce();
  note(event_of(kind), kicking);
}

void Referee::free_ball() {
  const bool was_whistled = state_.set_play == SetPlay::kick_off || state_.set_play == SetPlay::penalty_kick;
  state_.set_play = SetPlay::none;
  state_.phase_began = time_;
  anchor(ball_);
  announce();
  calls_.ball_came_free = was_whistled;
  note(EventKind::ball_free, state_.kicking);
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
