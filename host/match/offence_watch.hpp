// SPDX-License-Identifier: MIT
// OffenceWatch detects offences; PenaltyBox measures the time of penalties. Offences: a robot lies too long, makes no
// decision, pushes, holds the ball, crowds its own goal area, leaves the field, or moves in Set. RoboCup SPL rule book
// 2023, section 4. config::Offences has the limits.
//
// The rule book leaves some judgements to a person. These are the definitions of OffenceWatch:
// - Pushing: a robot walks against an opponent for Offences::pushing_lasts, or until the opponent falls, and the
//   opponent does not walk against the robot. A robot whose walk is more than 60 degrees off the opponent's direction
//   does not push. A robot that kicks or lies does not push. A goalkeeper in its own penalty area does not push.
// - Holding: the robot keeps touching the ball, and the ball stays in place. A robot that moves the ball dribbles and
//   does not hold it. The holding time decreases while the robot does not touch the ball.
// - Goal area: a robot is in its goal area when the centre of the robot is in the area.
// - Offences with arms or hands, a wide stance, and the picking up of robots are not simulated.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "config/rules.hpp"
#include "match/game_state.hpp"
#include "match/side.hpp"

namespace regista::match {

// What the referee sees after a physics step. World frame, SI units; robots by id (see Roster). Values of penalised
// robots are ignored. The match owns the memory, which is valid during the call of Referee::update().
struct Scene {
  double time = 0.0;  // match time, s; greater than in the last call
  Vector ball{};
  int touched_by = -1;                                     // robot that touched the ball in this step; -1: none
  bool kicked = false;                                     // the robot `touched_by` kicked the ball
  std::span<const Vector> robots{};                        // positions, by id
  std::span<const Vector> steps{};                         // walking velocities in m/s, by id; empty: no robot walks
  RobotSet turning = 0;                                    // robots that turn, whether they walk or stand
  RobotSet touching = 0;                                   // robots that touch the ball
  RobotSet fallen = 0, kicking = 0;                        // fallen: robots that lie or get up
  RobotSet acted = ~RobotSet{0};                           // robots that decided in this step; default: all robots
  RobotSet at_walls = 0;                                   // robots that touch the border, a goal post or a net
  std::span<const std::array<std::int8_t, 2>> contacts{};  // pairs of ids of robots that touch each other
};

struct Offender {
  int robot;  // id
  Offence offence;
  int victim = -1;  // for pushing: id of the pushed robot; -1: none
};

class OffenceWatch {
 public:
  OffenceWatch(const config::Rules& rules, Roster roster);

  // The caller calls this after each physics step in Ready, Set and Playing. playing: robots that are not penalised.
  // Returns at most one offence for each robot. The result is valid until the next call.
  std::span<const Offender> watch(const Scene& scene, const GameState& state, RobotSet playing);

  void forget(int id) { of(id) = {}; }  // clears all times of a robot that was put down or removed

 private:
  struct Watched {
    double lies = 0.0, idle = 0.0, holds = 0.0, at_wall = 0.0, pushes = 0.0;      // how long the robot has done this, s
    double touched = -1.0, pushed = -1.0, was_pushed = -1.0, was_at_wall = -1.0;  // last times, s; -1: never
    int victim = -1, pusher = -1;  // ids of the pushed robot and of the pushing robot; -1: none
    Vector held_at;                // ball position when the holding time began
    double pushed_in = -1.0;       // match time (s) at which a push moved this robot into its goal area; -1: no push
    bool lay = false, in_goal_area = false;  // state in the last call
  };
  void watch_bodies(const Scene& scene, const GameState& state, RobotSet playing, double passed);
  void watch_pushing(const Scene& scene, const GameState& state, RobotSet playing, double passed);
  void watch_goal_areas(const Scene& scene, const GameState& state, RobotSet playing);
  bool presses(const Scene& scene, int id, Vector towards) const;
  bool guards_its_goal(const Scene& scene, const GameState& state, int id) const;
  void call(int id, Offence offence, int victim = -1);
  // Returns whether `moment` is at most 0.2 s ago: Box2D may part touching bodies for a step, so contacts count longer.
  bool recently(double moment) const { return moment >= 0.0 && time_ - moment <= 0.2; }
  Watched& of(int id) { return watched_[at(id)]; }

  config::Rules rules_;
  Roster roster_;
  std::vector<Watched> watched_;  // by id
  std::vector<Offender> calls_;
  double time_ = 0.0;
};

bool counts(Offence offence);  // Whether the offence makes later penalties of the team longer.

// Returns whether the penalised robot stays in place without moving. If false, the penalised robot leaves the field.
bool on_the_spot(Offence offence);

// The penalised robots, their offences and their remaining penalty times. RoboCup SPL rule book 2023, section 4.2: each
// earlier offence of the team makes a penalty longer. Offences in Set, local game stuck, lying and inactivity are
// exceptions: these do not count as earlier offences, and their own penalties do not get longer.
class PenaltyBox {
 public:
  PenaltyBox(const config::Penalties& penalties, Roster roster);

  void send(int id, Offence offence);             // a penalty begins
  void pass(double seconds);                      // reduces all remaining times; called in Ready and Playing only
  void release(int id) { inside_ &= ~only(id); }  // a penalty ends
  void empty() { inside_ = 0; }  // ends all penalties at the end of a half; the counts of offences remain

  RobotSet inside() const { return inside_; }                    // the penalised robots
  bool served(int id) const { return remaining(id) <= 1e-6; }    // the penalty time is over
  double remaining(int id) const { return remaining_[at(id)]; }  // s
  Offence offence(int id) const { return why_[at(id)]; }

 private:
  config::Penalties penalties_;
  Roster roster_;
  RobotSet inside_ = 0;
  std::vector<double> remaining_;
  std::vector<Offence> why_;      // by id
  std::array<int, 2> counted_{};  // by side: number of earlier offences that count
};

}  // namespace regista::match
