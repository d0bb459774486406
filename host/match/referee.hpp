// SPDX-License-Identifier: MIT
// The rules of a whole game as a state machine with plain input and output: it sees positions and touches, and says
// what is whistled and who or what is put where. RoboCup SPL rule book 2023, with every number from the rules profile.
//
//   Initial -> Ready -> Set -> (whistle) Playing -> goal: Ready, ball out: set play, half over: Initial or Finished
//
// Offences are seen by OffenceWatch, positions in Set judged by illegal_in_set, penalties timed by PenaltyBox.
//
// Decided here where the rule book leaves room, or a person would judge:
// - A game from an opening begins in play, in the first half, as if home had taken its kick-off long ago.
// - Before each half robots stand in Initial for one second, so that every robot decides there at least once.
// - Whoever stands on the very spot where the ball of a set play is put is moved aside by hand.
// - A free kick is taken, and the kick-off's ball in play, with the first touch by the kicking side. A ball that the
//   others touch before lies where it was, and who touched it is removed.
// - A deliberate play, which makes an indirect kick whole, is a kick or a dribble (touches for 0.3 s); whom the ball
// hits
//   has not played it. In a penalty kick the taker's touches count as one until the ball was free of it for half a
//   second.
// - The game is stuck when the ball has not moved by a quarter of a metre for the time that the rules give. Somebody
//   near it is removed (local); with nobody near, who is nearer kicks off (global), if the ball was touched before.
// - The clock never stops within a half, so there is no added time, and no packets for it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "config/opening.hpp"
#include "config/rules.hpp"
#include "match/game_state.hpp"
#include "match/indirect_kick.hpp"
#include "match/offence_watch.hpp"
#include "match/penalty_box.hpp"
#include "match/scene.hpp"

namespace regista::match {

struct Placement {
  int robot;  // id
  mind::Pose pose;
};

// What is to be done now, in this order. The memory is the referee's, until the next call.
struct Calls {
  std::vector<int> removed;             // ids of robots that leave the field
  RobotSet frozen = 0;                  // robots that must not move from now on, where they are
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

 private:
  void begin_half();
  void begin_in_play(const config::Opening& opening);
  void begin_ready(mind::SetPlay kind, Side kicking, Vector spot, bool told_late);
  void begin_set();
  void whistle_play();
  void end_half();
  void finish(Ended how);
  void play(const Scene& scene);
  void touch(const Scene& scene);
  void touched_too_early(int robot);
  bool ball_left();
  bool goal_counts(Side scorer) const;
  void goal(Side scorer);
  void set_play(mind::SetPlay kind, Side kicking, Vector spot);
  void free_ball();
  void watch_set_play();
  void watch_offences(const Scene& scene);
  void pushed(const Offender& offender);
  void watch_progress();
  void clear_spot(Vector spot);
  void remove_illegal_in_set();
  void put_goalkeeper_on_line();
  void put_down(int id, const mind::Pose& wanted);
  void penalise(int id, Offence offence);
  void let_back_in();
  void sanction(Side side, EventKind why);
  void announce(bool late = false);
  void note(EventKind kind, Side side, int number = 0, Offence offence = Offence::none);
  bool plays(int id) const { return !contains(box_.inside(), id); }
  RobotSet playing() const;
  bool since(double moment, double duration) const;
  bool on_goal_line(int id) const;
  double direction(Side side) const { return attack(side, state_.half); }
  Vector where(int id) const { return where_[static_cast<std::size_t>(id)]; }

  config::Rules rules_;
  const config::Opening* opening_;
  Roster roster_;
  double robot_radius_;
  GameState state_;
  Calls calls_;
  std::vector<Event> pending_;  // of packets, told with the next update
  std::vector<Vector> where_;   // robots by id, as they will be after the calls so far
  IndirectKick indirect_;
  OffenceWatch watch_;
  PenaltyBox box_;
  Vector ball_;
  double time_ = 0.0, clock_began_ = 0.0;
  int last_touch_ = -1;  // id
  bool touched_since_kick_off_ = false;
  Vector anchor_;  // the ball has not moved away from here
  double anchored_ = 0.0;
  std::vector<double> leave_by_;  // by id: until when who stands too near in a free kick may do so; 0: it may not
  bool began_ = false;
};

}  // namespace regista::match
