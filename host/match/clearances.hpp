// SPDX-License-Identifier: MIT
// Clearances: a kick in open play of a ball in the own third of the field (x < -length / 6 in the frame of the kicker's
// team) that is neither a meant pass nor a shot, after which the ball leaves that third, or gets 2 m farther away from
// the centre of the own goal than it lay, before another robot touches it.
//
// Assumption: whoever kicks the ball out of the own third for nobody in particular clears it. A goal kick is none.
#pragma once

#include <optional>

#include "config/rules.hpp"
#include "match/play_event.hpp"

namespace regista::match {

constexpr double cleared_way = 2.0;  // m; assumption: farther than a dribble pushes the ball

class Clearances {
 public:
  explicit Clearances(const config::FieldSize& field) : length_(field.length) {}

  // A robot has kicked the ball that lies at `ball`; direction: where its side attacks. What it kicked before is over.
  void kicked(int id, Vector ball, double direction, double time);
  void touched(int id) {
    if (kick_ && kick_->id != id) kick_.reset();
  }
  void drop() { kick_.reset(); }  // it was a pass or a shot, or the ball is dead

  struct Kick {
    int id;
    Vector at;
    double direction, began;
  };
  // The ball is here now: the kick that has become a clearance by it.
  std::optional<Kick> rolled(Vector ball);

 private:
  double to_goal(Vector ball, double direction) const { return length(direction * ball + Vector{length_ / 2.0, 0.0}); }

  double length_;
  std::optional<Kick> kick_;  // that may become one
};

}  // namespace regista::match
