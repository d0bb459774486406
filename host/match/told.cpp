// SPDX-License-Identifier: MIT
#include "match/told.hpp"

#include <algorithm>

namespace regista::match {

using mind::Phase;
using mind::SetPlay;

Told::Told(const config::Rules& rules) : durations_(rules.durations), roster_{rules.team_size} {
  robots_.resize(static_cast<std::size_t>(roster_.count()));
}

void Told::announce(const GameState& state, double time, double delay, bool follows) {
  ++last_;
  announcements_[static_cast<std::size_t>(last_ % kept)] = {
      state.phase,  state.set_play, state.kicking, state.half, state.goals,     state.phase_began,
      time + delay, follows,        state.clock,   time,       state.clock_runs};
}

void Told::know(Robot& robot, std::uint64_t i) const {
  robot.known = i;
  robot.ready_by_whistle = false;
}

// Of all that has arrived the latest counts, even if something sent earlier is still on its way.
void Told::catch_up(Robot& robot, double time) const {
  if (robot.known == last_) return;
  const std::uint64_t oldest = last_ >= kept ? last_ - kept + 1 : 1;
  for (std::uint64_t i = std::max(robot.known + 1, oldest); i <= last_; ++i) {
    if (at(i).follows ? robot.known + 1 == i : at(i).arrives <= time) know(robot, i);
  }
}

void Told::whistle(int id, double time) {
  Robot& robot = robots_[static_cast<std::size_t>(id)];
  catch_up(robot, time);
  if (at(robot.known).phase == Phase::set) {
    for (std::uint64_t i = robot.known + 1; i <= last_; ++i) {
      if (at(i).phase == Phase::playing) {
        know(robot, i);
        return;
      }
    }
  } else if (at(robot.known).phase == Phase::playing && !robot.ready_by_whistle) {
    robot.ready_by_whistle = true;
    robot.ready_since = time;
  }
}

void Told::tell(int id, const GameState& state, double time, mind::GameTold& out) {
  Robot& robot = robots_[static_cast<std::size_t>(id)];
  catch_up(robot, time);
  const Announcement& news = at(robot.known);
  const Side side = roster_.side(id);
  out.phase = robot.ready_by_whistle ? Phase::ready : news.phase;
  out.set_play = robot.ready_by_whistle ? SetPlay::kick_off : news.set_play;
  out.own_kick = news.kicking == side;
  out.half = news.half;
  out.own_score = news.score[index(side)];
  out.opponent_score = news.score[index(opposite(side))];
  out.phase_time = time - (robot.ready_by_whistle ? robot.ready_since : news.began);
  // The clock as far as the news go: it does not give away a kick-off that the robot has not heard of.
  const double clock = news.clock + (news.clock_runs ? time - news.said : 0.0);
  out.half_time_left = durations_.half - clock;
  out.match_time_left = out.half_time_left + (durations_.halves - news.half) * durations_.half;
  out.packets_left = state.packets_left[index(side)];
  out.own_penalised = state.penalised[index(side)];
  out.opponent_penalised = state.penalised[index(opposite(side))];
}

}  // namespace regista::match
