// SPDX-License-Identifier: MIT
// The packets of a game that is shorter than a match, where the rules give it a share (messages.short_games).
// Everything that counts packets is scaled alike: how many are left, how many would be left if spent evenly, and the
// time in which they are spent. So who spends by these numbers spends as in the same part of a whole match.
#pragma once

#include <optional>

#include "config/rules.hpp"

namespace regista::config {

// The share of a match that a game of at most so many seconds is: in (0, 1], and 1 where the rules give every game the
// whole budget, or the game has no such length.
double packet_share(const Rules& rules, std::optional<double> seconds);

// Packets that a team has in this game, rounded down.
int packets(const Messages& messages);

// s in which the packets of this game are to be spent, when the clock leaves so much of a whole match.
double packet_time_left(const Rules& rules, double match_time_left);

// Packets that would be left by then if spent evenly.
double packet_line(const Rules& rules, double match_time_left);

}  // namespace regista::config
