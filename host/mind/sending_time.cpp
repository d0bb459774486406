// SPDX-License-Identifier: MIT
#include "mind/sending_time.hpp"

#include <algorithm>

namespace regista::mind {
namespace {

// s of Ready and Set until this half's kick-off.
double standing_time_left(const config::Durations& durations, const GameTold& game) {
  if (game.half_time_left < durations.half) return 0.0;  // the clock runs: a Ready after a goal takes none besides
  switch (game.phase) {
    case Phase::initial:
      return durations.ready + durations.set;
    case Phase::ready:
      return std::max(0.0, durations.ready - game.phase_time) + durations.set;
    case Phase::set:
      return std::max(0.0, durations.set - game.phase_time);
    default:
      return 0.0;
  }
}

}  // namespace

double sending_time_left(const config::Durations& durations, const GameTold& game) {
  const double later_halves = (durations.halves - game.half) * (durations.ready + durations.set);
  return game.match_time_left + later_halves + standing_time_left(durations, game);
}

}  // namespace regista::mind
