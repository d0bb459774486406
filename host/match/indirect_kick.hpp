// SPDX-License-Identifier: MIT
// What a goal still needs after a free kick or a penalty kick. RoboCup SPL rule book 2023, sections 3.3.2 and 3.9:
// after a free kick the ball must be played a second time, by another robot or, after it has left the circle, by the
// same; who takes a penalty kick may score with one touch only, until another robot has touched the ball.
#pragma once

#include "config/rules.hpp"
#include "match/geometry.hpp"
#include "match/side.hpp"

namespace regista::match {

class IndirectKick {
 public:
  explicit IndirectKick(double circle) : circle_(circle) {}

  void free_kick(Side side, Vector spot) { *this = {circle_, Kind::free_kick, side, spot}; }
  void penalty_kick(Side side, Vector spot) { *this = {circle_, Kind::penalty_kick, side, spot}; }
  void over() { kind_ = Kind::none; }

  // Robot `id` of `side` has touched the ball; kicked: on purpose.
  void touched(int id, Side side, bool kicked, double time);
  void ball_at(Vector ball);

  bool may_score(Side side) const;

 private:
  enum class Kind { none, free_kick, penalty_kick };
  IndirectKick(double circle, Kind kind, Side side, Vector spot)
      : circle_(circle), kind_(kind), side_(side), spot_(spot) {}

  double circle_;
  Kind kind_ = Kind::none;
  Side side_ = Side::home;
  Vector spot_;
  int taker_ = -1;          // id; -1: nobody yet
  double touched_ = 0.0;    // when the taker touched it last
  bool played_on_ = false;  // free kick: the ball has left the circle; penalty kick: touched a second time
};

}  // namespace regista::match
