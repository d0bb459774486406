// SPDX-License-Identifier: MIT
// What every behaviour does alike, whatever it is for: it stands while the body cannot act or the game wants everybody
// to stand, and walks to its place in Ready. Only in Playing does it play.
#pragma once

#include "legal_place.hpp"
#include "movement.hpp"
#include "situation.hpp"

namespace behaviours {

// play(): the movement in Playing.
template <class Play>
Movement by_phase(const Situation& situation, const LegalPlaceSettings& legal, const Play& play) {
  if (situation.incapable) return Stand{};
  switch (situation.phase) {
    case Phase::ready:
      if (!situation.has_task) return Stand{};
      return WalkTo{.target = legal_place(situation, legal, situation.target)};
    case Phase::playing:
      return play();
    case Phase::initial:
    case Phase::set:
    case Phase::finished:
      break;
  }
  return Stand{};
}

}  // namespace behaviours
