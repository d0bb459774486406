// SPDX-License-Identifier: MIT
// What happened with the ball, one by one: each shot, meant pass, clearance and duel that the metrics count, told once
// it is decided what became of it. metrics_play.hpp, clearances.hpp and duels.hpp say what counts.
#pragma once

#include <functional>

#include "match/geometry.hpp"
#include "match/side.hpp"

namespace regista::match {

enum class PlayKind { shot, pass, clearance, duel };

// Of a shot: goal, saved, or missed, which is all else. Of a pass: arrived, intercepted, or lost, which is neither. Of
// a duel, as `side` of the event sees it: won, lost, or undecided. Of a clearance: none.
enum class PlayOutcome { none, goal, saved, missed, arrived, intercepted, lost, won, undecided };

struct PlayEvent {
  PlayKind kind = PlayKind::shot;
  Side side = Side::home;
  int number = 0;
  double began = 0.0;  // s of match time
  Vector at;           // of the ball when it began; world frame
  PlayOutcome outcome = PlayOutcome::none;
  int receiver = 0;       // of a pass: whom it was meant for
  int opponent = 0;       // of a duel: the robot of the other side
  double duration = 0.0;  // of a duel, s
};

// time: now that it is decided.
using PlayTeller = std::function<void(double time, const PlayEvent&)>;

}  // namespace regista::match
