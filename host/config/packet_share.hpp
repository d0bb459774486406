// SPDX-License-Identifier: MIT
// The packets of a game, and how many would be left by now if they were spent evenly over the time in which a team may
// send: that is play, and Ready and Set before each half, in which the clock stands. A game that begins in play (from
// an opening) has no Ready and Set before its first half.
//
// Where the rules give a game that is shorter than a match a share of the packets (messages.short_games), everything
// that counts packets is of that game: how many are left, how many would be left if spent evenly, and the time in which
// they are spent.
#pragma once

#include <optional>

#include "config/rules.hpp"

namespace regista::config {

// The share of a match that a game of at most so many seconds is: in (0, 1], and 1 where the rules give every game the
// whole budget, or the game has no such length.
double packet_share(const Rules& rules, std::optional<double> seconds);

// Sets what in messages follows from the game: one of at most so many simulated seconds, from the kick-off or in play.
void fit_packets(Rules& rules, std::optional<double> seconds, bool begins_in_play);

// Packets that a team has in this game, rounded down.
int packets(const Messages& messages);

// s in a match in which a team may send.
double sending_time(const Durations& durations);

// s in which the packets of this game are to be spent, when a team may send for so long in the rest of a match.
double packet_time_left(const Rules& rules, double sending_time_left);

// Packets that would be left by then if spent evenly: all at the beginning of the game, none at its end.
double packet_line(const Rules& rules, double sending_time_left);

}  // namespace regista::config
