// SPDX-License-Identifier: MIT
// Sees offences: robots that lie, sleep, push, hold the ball, crowd their goal area, walk off, move in Set. RoboCup SPL
// rule book 2023, section 4; when something is one stands in config::Offences.
//
// Where a person would judge:
// - Pushing: the legs carry a robot against an opponent that does not itself press back, for some time or until the
//   opponent falls; legs that pass by at more than 60 degrees are a side contact. Not for who kicks, lies, or is the
//   goalkeeper in its own penalty area.
// - Holding: the ball stays in touch and where it is; who moves it on dribbles. Time out of touch counts back at the
//   same rate.
// - A robot is in its goal area when its centre is.
// - Arms, hands and a wide stance are none of this simulation; being picked up neither.
#pragma once

#include <span>
#include <vector>

#include "config/rules.hpp"
#include "match/game_state.hpp"
#include "match/scene.hpp"
#include "match/side.hpp"

namespace regista::match {

struct Offender {
  int robot;  // id
  Offence offence;
  int victim = -1;  // id: who was pushed
};

class OffenceWatch {
 public:
  OffenceWatch(const config::Rules& rules, Roster roster);

  // To be called after each step in Ready, Set and Playing. playing: who is not penalised. At most one offence a
  // robot. The memory is the watch's, until the next call.
  std::span<const Offender> watch(const Scene& scene, const GameState& state, RobotSet playing);

  void forget(int id);  // it has been put down or taken away

 private:
  struct Watched {
    double lies = 0.0, idle = 0.0, holds = 0.0, at_wall = 0.0, pushes = 0.0;      // s of each
    double touched = -1.0, pushed = -1.0, was_pushed = -1.0, was_at_wall = -1.0;  // when last
    int victim = -1, pusher = -1;
    Vector held_at;           // where the ball was when the time of holding it began
    double pushed_in = -1.0;  // into the own goal area, since when
    bool lay = false, in_goal_area = false;
  };
  void watch_bodies(const Scene& scene, const GameState& state, RobotSet playing, double passed);
  void watch_pushing(const Scene& scene, const GameState& state, RobotSet playing, double passed);
  void watch_goal_areas(const Scene& scene, const GameState& state, RobotSet playing);
  bool presses(const Scene& scene, int id, Vector towards) const;
  bool guards_its_goal(const Scene& scene, const GameState& state, int id) const;
  void call(int id, Offence offence, int victim = -1);
  Watched& of(int id) { return watched_[static_cast<std::size_t>(id)]; }

  config::Rules rules_;
  Roster roster_;
  std::vector<Watched> watched_;  // by id
  std::vector<Offender> calls_;
  double time_ = 0.0;
};

}  // namespace regista::match
