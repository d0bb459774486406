// SPDX-License-Identifier: MIT
// Whether the team's budget allows a packet now: B-Human's line (Roefer et al., "B-Human 2022 - More Team Play with
// Less Communication", RoboCup 2022, LNCS 13561; numbers of the code release of 2025). The line falls evenly from the
// whole budget to the reserve over the time left, with 10 s more for each half and 5 s less in all. Above it a packet
// may go at any time. Below it the team must have been silent for twice the even interval, or longer: so that what is
// left above the half's reserve lasts to the end of the half, and in proportion to how far the team is below the line.
//
// Decided by us: the numbers 2.085 s, 615 and 30 follow from 1200 packets, two halves of 600 s and the reserve of 30,
// and are computed from those here. Several robots that wait for the same silence would send at once and leave fewer
// than the reserve: so when fewer than a packet for each robot are left above it the silence is asked for in any case,
// and each robot waits some decisions longer, another number of them for each robot, in turn.
//
// The line is no hard limit. Robots that decide at the same moment all see the same packets left: when one packet is
// left above the line, all may send at once, so that in play seven robots end up to seven packets below it. Before a
// kick-off the clock stands, and the line with it, while packets go out: there it may be up to 30 packets. The
// reserve of each half holds but for whistles, which have a reserve of their own (test_budget.cpp).
#pragma once

#include <algorithm>
#include <limits>

namespace extrapolated_change {

// Of a match, or of the share of one that a game has.
struct Allowance {
  double budget = 1200.0;  // packets
  double reserve = 30.0;   // packets that are left at the end
  double halves = 2.0, half_length = 600.0;
  double more_per_half = 10.0;  // s that a half takes longer
  double ahead = 5.0;           // s: the line is that of so much later

  double whole() const { return halves * (half_length + more_per_half); }
  // Packets that should be left when this share of the time is left.
  double line(double share_left) const { return budget * share_left + reserve * (1.0 - share_left); }
  // s between two packets at an even rate.
  double even_interval() const {
    return budget > reserve ? whole() / (budget - reserve) : std::numeric_limits<double>::infinity();
  }
};

// Where the game stands.
struct Clock {
  int half = 1;            // from 1
  double half_left = 0.0;  // s
};

// Share of the time that counts as left.
inline double share_left(const Allowance& allowance, const Clock& clock) {
  const double later = std::max(0.0, allowance.halves - clock.half);
  const double left = clock.half_left + later * allowance.half_length + (later + 1.0) * allowance.more_per_half;
  return std::clamp((left - allowance.ahead) / allowance.whole(), 0.0, 1.0);
}

// Packets that must be left at the end of this half.
inline double half_reserve(const Allowance& allowance, int half) {
  return allowance.line(std::max(0.0, allowance.halves - half) / allowance.halves);
}

struct Purse {
  double left = 0.0;         // packets
  double line = 0.0;         // packets that should be left now
  double line_before = 0.0;  // and when the team's last packet was sent
  double reserve = 0.0;      // of this half
  double half_left = 0.0;    // s
  double silent = 0.0;       // s since the team's last packet
  int robots = 7;
  double turn = 0.0;  // s that this robot waits longer
};

// Whether a packet that can wait may go.
inline bool may_spend(const Allowance& allowance, const Purse& purse) {
  constexpr double deficit = 30.0;  // packets below the line for twice the even interval more
  constexpr double rounding = 1e-9;
  const double above = purse.left - purse.reserve;
  if (above < 1.0) return false;
  if (purse.left > purse.line && above >= purse.robots) return true;
  const double twice = 2.0 * allowance.even_interval();
  const double silence = std::max({twice, purse.half_left / above, twice * (purse.line_before - purse.left) / deficit});
  return purse.silent > silence + purse.turn - rounding;
}

}  // namespace extrapolated_change
