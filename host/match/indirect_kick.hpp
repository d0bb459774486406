// SPDX-License-Identifier: MIT
// What a goal still needs after a free kick or a penalty kick. RoboCup SPL rule book 2023, sections 3.3.2 and 3.9:
// after a free kick the ball must be played a second time, by another robot, or by the same after it has left a circle
// around it; who takes a penalty kick may score with one touch only, until another robot has touched the ball.
//
// Played is a ball that is kicked, or dribbled: touched for longer than a ball takes to bounce off.
#pragma once

#include "config/rules.hpp"
#include "match/geometry.hpp"
#include "match/side.hpp"

namespace regista::match {

class IndirectKick {
 public:
  explicit IndirectKick(double circle) : circle_(circle) {}

  void free_kick(Side side) { *this = {circle_, Kind::free_kick, side}; }
  void penalty_kick(Side side) { *this = {circle_, Kind::penalty_kick, side}; }
  void over() { kind_ = Kind::none; }

  // Robot `id` of `side` has touched the ball, which is at `ball`; kicked: with a kick.
  void touched(int id, Side side, bool kicked, Vector ball, double time);
  void ball_at(Vector ball);

  bool may_score(Side side) const;

 private:
  enum class Kind { none, free_kick, penalty_kick };
  IndirectKick(double circle, Kind kind, Side side) : circle_(circle), kind_(kind), side_(side) {}
  void played_by_another(int id, bool kicked, double time);

  double circle_;
  Kind kind_ = Kind::none;
  Side side_ = Side::home;
  int taker_ = -1;                    // id; -1: nobody yet
  Vector left_at_;                    // where the taker touched it last
  double touched_ = 0.0;              // and when
  bool played_on_ = false;            // free kick: the ball has left the circle; penalty kick: touched a second time
  int other_ = -1;                    // id of another robot that touches it
  double since_ = 0.0, until_ = 0.0;  // first and last moment of its touches
};

}  // namespace regista::match
