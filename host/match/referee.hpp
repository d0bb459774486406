// SPDX-License-Identifier: MIT
// The rules of a whole game as a state machine with plain input and output: it sees positions and touches, and says
// what is whistled and who or what is put where. RoboCup SPL rule book 2023, with every number from the rules profile.
//
//   Initial -> Ready -> Set -> (whistle) Playing -> goal: Ready, ball out: set play, half over: Initial or Finished
//
// Decided here where the rule book leaves room, or a person would judge:
// - A game from an opening begins in play, in the first half, as if home had taken its kick-off long ago.
// - Before each half robots stand in Initial for one second, so that every robot decides there at least once.
// - Robots that stand illegally at the beginning or end of Set (beyond the own half, in the circle when the others kick
//   off, on the ball) are put back by hand, and so is a robot on the very spot where the ball of a set play is put.
// - An opponent that is too near in a set play has five seconds to leave; who comes near later is removed at once.
//   In a kick-off whoever enters the circle is removed at once.
// - Goal kicks, corner kicks and kick-ins are indirect: a goal counts after a second robot has touched the ball, or the
//   same again after the ball left the circle. Otherwise the game goes on with a goal kick (own goal: corner kick).
// - Nobody touches the ball for long ("game stuck"): a kick-off for the side that did not touch it last.
// - The clock never stops within a half, so there is no added time and no extra allowance of packets from it.
// - Penalties are over at half-time, for the break is longer than they are.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "config/opening.hpp"
#include "config/rules.hpp"
#include "match/game_state.hpp"

namespace regista::match {

// What the referee sees after a physics step. World frame.
struct Scene {
  double time = 0.0;  // s since the start of the match; rises from call to call
  Vector ball;
  int touched_by = -1;             // id of the robot that touched the ball since the last call (see Roster)
  std::span<const Vector> robots;  // by id; those of penalised robots are not looked at
};

struct Placement {
  int robot;  // id
  mind::Pose pose;
};

// What is to be done now, in this order. The memory is the referee's, until the next call.
struct Calls {
  std::vector<int> removed;             // ids of robots that leave the field
  std::vector<Placement> placements;    // robots to be put down by hand
  std::optional<Vector> ball;           // the ball is put here, at rest
  std::optional<Vector> ball_velocity;  // but rolls: the scene of an opening, m/s
  bool whistle = false;
  bool announced = false;       // phase, set play or score changed: the game controller tells
  bool told_late = false;       // but over the network only after Durations::state_delay
  bool ball_came_free = false;  // the announcement is news only to those who know of the kick-off
  std::vector<Event> events;

  void clear();
};

class Referee {
 public:
  // robot_radius: of the largest robot, m; nobody is put nearer to anything than bodies allow.
  // opening: the scene that the game starts from, for the time of the referee; null: from the first kick-off.
  Referee(const config::Rules& rules, double robot_radius, const config::Opening* opening = nullptr);

  const GameState& state() const { return state_; }
  const Calls& update(const Scene& scene);

  // A packet is about to be sent. False: the phase has no radio, or it is longer than the rules allow; it is not sent.
  // The events that follow come with the next update.
  bool packet(Side side, std::size_t bytes);

  // Packets a team may send when `added` seconds were added to the halves.
  static int allowance(const config::Messages& messages, double added);

 private:
  void begin_half();
  void begin_in_play(const config::Opening& opening);
  void begin_ready(Side kicking, bool told_late);
  void begin_set();
  void kick_off();
  void end_half();
  void finish(Ended how);
  void play();
  void touch(int robot);
  bool ball_left();
  void goal(Side scorer);
  void set_play(mind::SetPlay kind, Side kicking, Vector spot);
  void free_ball();
  void watch_distances();
  void clear_spot(Vector spot);
  void put_back_illegal();
  bool legal_in_set(int id) const;
  void put_down(int id, const mind::Pose& wanted);
  void penalise(int id);
  void let_back_in();
  void sanction(Side side, EventKind why);
  void announce(bool late = false);
  void note(EventKind kind, Side side, int number = 0);
  bool plays(int id) const { return !state_.is_penalised(roster_.side(id), roster_.number(id)); }
  bool since(double moment, double duration) const;
  double direction(Side side) const { return attack(side, state_.half); }

  config::Rules rules_;
  const config::Opening* opening_;
  Roster roster_;
  double robot_radius_;
  GameState state_;
  Calls calls_;
  std::vector<Event> pending_;   // of packets, told with the next update
  std::vector<Vector> where_;    // robots by id, as they will be after the calls so far
  std::vector<double> back_at_;  // by id: when the penalty is over
  std::array<int, 2> offences_{};
  Vector ball_;
  double time_ = 0.0, clock_began_ = 0.0;
  double last_action_ = 0.0;  // the last touch, or when the ball came free
  int last_touch_ = -1;       // id
  int first_touch_ = -1;      // id of who took an indirect set play, while no second robot touched the ball
  bool indirect_ = false;
  RobotSet was_near_ = 0;  // ids that stood too near when the set play was called
  bool began_ = false;
};

}  // namespace regista::match
