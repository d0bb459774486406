// SPDX-License-Identifier: MIT
// Draws the rounds of tournaments in which results decide who meets: Swiss and knock-out. Plain numbers in, pairs of
// teams out; teams are indices, and an earlier team is seeded higher.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace regista::study {

using TeamPair = std::array<std::size_t, 2>;  // the higher seeded team first

struct DrawnRound {
  std::vector<TeamPair> meetings;
  std::optional<std::size_t> bye;  // a team without an opponent in this round
};

// What a Swiss tournament knows of its earlier rounds, by team.
struct SwissStanding {
  std::vector<double> points;
  std::vector<char> plays;             // 0: the team has left the tournament
  std::vector<char> had_bye;           // 1: the team has been without an opponent before
  std::vector<std::vector<char>> met;  // [i][j]: i and j have met
};

// Draws a round after Monrad: teams stand in the order of their points, and each meets the next one that it has not
// met. If that leaves teams over, the draw is changed from its end, and two teams meet again only if nothing else is
// possible. With an odd number of teams, the last team that had no bye gets one.
DrawnRound swiss_round(const SwissStanding& standing);

// The usual number of rounds: as many as a knock-out of these teams has.
std::size_t knock_out_rounds(std::size_t teams);

// Draws a round of a knock-out, from 0. The higher seeds meet as late as possible, and have byes in the first round if
// the number of teams is no power of two. winner: decides a meeting of an earlier round.
std::vector<TeamPair> knock_out_round(std::size_t teams, std::size_t round,
                                      const std::function<std::size_t(const TeamPair&)>& winner);

}  // namespace regista::study
