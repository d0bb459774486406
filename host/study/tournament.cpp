// SPDX-License-Identifier: MIT
#include "study/tournament.hpp"

#include <algorithm>

namespace regista::study {

void Tally::add(const campaign::Decided& decided) {
  const std::uint64_t index = standing_.games();
  const bool swapped = fixture(index, 0).swapped;
  const std::size_t side_of_a = swapped ? 1 : 0;
  const int goals_a = decided.score[side_of_a], goals_b = decided.score[1 - side_of_a];
  standing_.goals[0] += static_cast<std::uint64_t>(goals_a);
  standing_.goals[1] += static_cast<std::uint64_t>(goals_b);
  if (decided.failure) {
    const int team = static_cast<std::size_t>(decided.failure->side) == side_of_a ? 0 : 1;
    list(*decided.failure, team);
  }
  const int points = goals_a > goals_b ? 2 : goals_a == goals_b ? 1 : 0;
  ++(points == 2 ? standing_.wins : points == 1 ? standing_.draws : standing_.losses);
  if (swapped)
    ++standing_.pairs[static_cast<std::size_t>(first_of_pair_ + points)];
  else
    first_of_pair_ = points;
}

void Tally::list(const campaign::Failure& failure, int team) {
  const auto known = std::ranges::find_if(standing_.forfeits, [&](const Forfeits& each) {
    return each.team == team && each.failure.plugin == failure.plugin && each.failure.call == failure.call &&
           each.failure.what == failure.what;
  });
  if (known != standing_.forfeits.end()) {
    ++known->count;
  } else if (standing_.forfeits.size() < most_listed) {
    standing_.forfeits.push_back({team, failure, standing_.games(), 1});
  } else {
    ++standing_.unlisted_forfeits;
  }
}

}  // namespace regista::study
