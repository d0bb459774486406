// SPDX-License-Identifier: MIT
// Situations for the tests of the behaviours' algorithms: the field of the SPL rule book 2023, a NAO, nobody else.
#pragma once

#include "situation.hpp"

namespace behaviours {

// In Playing, with a task where it stands.
inline Situation standing(double x, double y, double heading = 0.0) {
  Situation out;
  out.pose = out.target = {x, y, heading};
  out.frame = Frame2(out.pose);
  out.has_task = true;
  return out;
}

// The same, with a ball that it sees and trusts.
inline Situation with_ball(Situation situation, const Vector2d& ball, const Vector2d& velocity = {0, 0}) {
  situation.sees_ball = situation.ball_trusted = true;
  situation.ball = ball;
  situation.ball_velocity = velocity;
  return situation;
}

inline Situation in_set_play(Situation situation, SetPlay set_play, bool own_kick, Phase phase = Phase::playing) {
  situation.set_play = set_play;
  situation.own_kick = own_kick;
  situation.phase = phase;
  return situation;
}

}  // namespace behaviours
