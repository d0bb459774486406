// SPDX-License-Identifier: MIT
// How long a team may still send in a match: in play, and in Ready and Set before a half, in which the clock stands.
#pragma once

#include "config/rules.hpp"
#include "mind/percepts.hpp"

namespace regista::mind {

// s, by what a robot was told. It never jumps while the news are on time, and falls by a second each second but in
// Initial.
double sending_time_left(const config::Durations& durations, const GameTold& game);

}  // namespace regista::mind
