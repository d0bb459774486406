// SPDX-License-Identifier: MIT
// A ranking that cannot be swayed by adding copies of a team, and that shows cycles: the teams play a symmetric
// zero-sum game of choosing a team, and the answer is its equilibrium of the largest entropy. D. Balduzzi et al.,
// "Re-evaluating Evaluation", NeurIPS 2018.
#pragma once

#include <vector>

#include "statistics/square_table.hpp"

namespace regista::statistics {

struct NashAverage {
  std::vector<double> share;  // of each team in the equilibrium: of [0, 1], sum 1
  std::vector<double> value;  // what each team expects against the equilibrium: 0 for its teams, 0 or below for others
};

// `payoff.at(i, j)`: what i wins against j on average, finite, in any unit where 0 is even: Elo, goal difference, score
// less 1/2. Only the antisymmetric part (payoff(i, j) - payoff(j, i)) / 2 counts. Accuracy: a part in a million of the
// largest payoff. Empty for no team; equal shares where all payoffs are 0, which is no information.
NashAverage nash_average(const SquareTable& payoff);

}  // namespace regista::statistics
