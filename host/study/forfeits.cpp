// SPDX-License-Identifier: MIT
#include "study/forfeits.hpp"

#include <algorithm>

namespace regista::study {
namespace {

constexpr std::size_t most_listed = 100;

}  // namespace

void ForfeitList::add(std::size_t team, const campaign::Failure& failure, std::uint64_t match) {
  ++of_team_[team];
  const auto known = std::ranges::find_if(listed_, [&](const Forfeits& each) {
    return each.team == team && each.failure.plugin == failure.plugin && each.failure.call == failure.call &&
           each.failure.what == failure.what;
  });
  if (known != listed_.end()) {
    ++known->count;
  } else if (listed_.size() < most_listed) {
    listed_.push_back({team, failure, match, 1});
  } else {
    ++unlisted_;
  }
}

}  // namespace regista::study
