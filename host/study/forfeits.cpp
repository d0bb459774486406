// SPDX-License-Identifier: MIT
#include "study/forfeits.hpp"

#include <algorithm>

namespace regista::study {
namespace {

constexpr std::size_t most_listed = 100;

}  // namespace

std::vector<Forfeits>::iterator ForfeitList::find(std::size_t team, const campaign::Failure& failure) {
  return std::ranges::find_if(listed_, [&](const Forfeits& each) {
    return each.team == team && each.failure.plugin == failure.plugin && each.failure.call == failure.call &&
           each.failure.what == failure.what;
  });
}

void ForfeitList::add(std::size_t team, const campaign::Failure& failure, std::uint64_t match) {
  ++of_team_[team];
  const auto known = find(team, failure);
  if (known != listed_.end()) {
    ++known->count;
  } else if (listed_.size() < most_listed) {
    listed_.push_back({team, failure, match, 1});
  } else {
    ++unlisted_;
  }
}

void ForfeitList::take_back(std::size_t team, const campaign::Failure& failure) {
  --of_team_[team];
  const auto known = find(team, failure);
  if (known == listed_.end())
    --unlisted_;
  else if (--known->count == 0)
    listed_.erase(known);
}

}  // namespace regista::study
