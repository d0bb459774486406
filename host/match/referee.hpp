// SPDX-License-Identifier: MIT
// Referee applies the rules of a whole game as a state machine. Its input is positions and touches (Scene); its output
// is whistles, placements and penalties (Calls). RoboCup SPL rule book 2023. All numbers come from the rules profile.
//
//   Initial -> Ready -> Set -> (whistle) Playing -> goal: Ready, ball out: set play, half over: Initial or Finished
//
// OffenceWatch detects offences. illegal_in_set() checks positions in Set. PenaltyBox measures the time of penalties.
//
// The rule book leaves some cases open or to a person's judgement. Referee decides these cases as follows:
// - A game from an opening begins in play in the first half, as if home had taken the kick-off.
// - Before each half robots stand in the phase Initial for one second, so that every robot decides once in Initial.
// - If a robot is at the place where a set play puts the ball, a person moves the robot aside.
// - The first touch by the kicking side takes the set play, and the ball is then in play. If the other side touches the
//   ball first, the ball is put back and the robot that touched it is removed.
// - After a free kick a goal counts only after a second play of the ball (see IndirectKick). To play the ball is to
//   kick it or to dribble it (touches for 0.3 s). A ball that hits a robot is not played. Touches of a penalty taker
//   count as one touch until the taker has not touched the ball for 0.5 s.
// - The game is stuck when the ball has moved less than 0.25 m for Durations::game_stuck. If the nearest robot is
//   within Offences::stuck_near_ball of the ball, this robot is removed (local game stuck). Else, if a robot has
//   touched the ball since the kick-off, the nearest robot's side gets a kick-off (global game stuck).
// - The clock never stops within a half. The rule book's added time and additional packets are therefore not needed.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "config/opening.hpp"
#include "config/rules.hpp"
#include "match/game_state.hpp"
#include "match/offence_watch.hpp"
#include "match/side.hpp"

namespace regista::match {

// Tells whether a goal counts after a free kick or a penalty kick. RoboCup SPL rule book 2023, sections 3.3.2 and 3.9.
// A goal after a free kick counts only after a second play: another robot kicks or dribbles the ball, or the taker
// kicks it after the ball has left a circle around the place of the taker's last touch. After a penalty kick, a goal by
// a second touch of the taker does not count, unless another robot has touched the ball.
class IndirectKick {
 public:
  explicit IndirectKick(double circle) : circle_(circle) {}  // circle: radius of the circle, m

  void free_kick(Side side) { *this = {circle_, Kind::free_kick, side}; }
  void penalty_kick(Side side) { *this = {circle_, Kind::penalty_kick, side}; }
  void over() { kind_ = Kind::none; }  // from now on every goal counts

  // Robot `id` of `side` has touched the ball at the position `ball`. kicked: the touch was a kick.
  void touched(int id, Side side, bool kicked, Vector ball, double time);
  void ball_at(Vector ball);  // must be called with each new ball position

  bool may_score(Side side) const;  // whether a goal of `side` would count now

 private:
  enum class Kind { none, free_kick, penalty_kick };
  IndirectKick(double circle, Kind kind, Side side) : circle_(circle), kind_(kind), side_(side) {}

  double circle_;
  Kind kind_ = Kind::none;
  Side side_ = Side::home;
  int taker_ = -1;                    // id of the robot that took the kick; -1: nobody yet
  Vector left_at_;                    // ball position at the taker's last touch
  double touched_ = 0.0;              // time of the taker's last touch, s
  bool played_on_ = false;            // free kick: the ball left the circle; penalty kick: the taker touched twice
  int other_ = -1;                    // id of the last robot except the taker that touched the ball; -1: none
  double since_ = 0.0, until_ = 0.0;  // times of the first and last touch by robot `other_`, s
};

struct Placement {  // a robot that a person puts down
  int robot;        // id
  mind::Pose pose;
};

// What the match must do now, in the order of the members. The referee owns the memory, valid until the next update().
struct Calls {
  std::vector<int> removed;             // ids of robots that leave the field
  RobotSet frozen = 0;                  // penalised robots that stay in place and must not move
  std::vector<Placement> placements;    // robots and their new poses
  std::optional<Vector> ball;           // new position of the ball; the ball is at rest unless ball_velocity is set
  std::optional<Vector> ball_velocity;  // initial ball velocity of an opening, m/s
  bool whistle = false;                 // the referee whistles
  bool announced = false;               // the game state has changed, and the game controller sends it
  bool told_late = false;               // the game controller's message arrives after Durations::state_delay
  bool ball_came_free = false;          // the message reaches only robots that know of the kick-off or penalty kick
  std::vector<Event> events;

  void clear();
};

class Referee {
 public:
  // robot_radius: radius of the largest robot, m; determines the distance of placements. opening: scene at the start of
  // the game, must outlive the referee; null: the game starts with the first kick-off.
  Referee(const config::Rules& rules, double robot_radius, const config::Opening* opening = nullptr);

  const GameState& state() const { return state_; }
  const Calls& update(const Scene& scene);  // must be called after each physics step

  // The caller calls this before a robot of `side` sends a packet. Charges the packet in Ready, Set and Playing.
  // Returns false if it must not be sent: in other phases, or if it is too long. The next update() returns the events.
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
  void enter(mind::Phase phase) {
    state_.phase = phase;
    state_.phase_began = time_;
  }
  void anchor(Vector ball) {
    anchor_ = ball;
    anchored_ = time_;
  }
  void note(EventKind kind, Side side, int number = 0, Offence offence = Offence::none);
  bool plays(int id) const { return !contains(box_.inside(), id); }
  RobotSet playing() const { return roster_.everybody() & ~box_.inside(); }
  // Returns whether `duration` has passed since `moment`. The tolerance exists because sums of steps are not exact.
  bool since(double moment, double duration) const { return time_ - moment >= duration - 1e-6; }
  bool on_goal_line(int id) const;
  double direction(Side side) const { return attack(side, state_.half); }
  Vector where(int id) const { return where_[at(id)]; }

  config::Rules rules_;
  const config::Opening* opening_;
  Roster roster_;
  double robot_radius_;
  GameState state_;
  Calls calls_;
  std::vector<Event> pending_;  // events caused by packets since the last update()
  std::vector<Vector> where_;   // robot positions by id, after the placements of this update()
  IndirectKick indirect_;
  OffenceWatch watch_;
  PenaltyBox box_;
  Vector ball_;
  double time_ = 0.0, clock_began_ = 0.0;
  int last_touch_ = -1;  // id
  bool touched_since_kick_off_ = false;
  Vector anchor_;          // the ball has stayed within 0.25 m of this place
  double anchored_ = 0.0;  // match time at which the ball came to anchor_, s
  // By id: match time (s) until which a robot may still be too near to a free kick; 0: the robot must not come near.
  std::vector<double> leave_by_;
  bool began_ = false;  // update() has been called once
};

}  // namespace regista::match
