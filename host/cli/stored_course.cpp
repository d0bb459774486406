// SPDX-License-Identifier: MIT
#include "cli/stored_course.hpp"

#include <optional>
#include <string>
#include <utility>

namespace regista::cli {

StoredCourse::StoredCourse(const campaign::Store& store, const study::TournamentPlan& plan)
    : store_(store), calendar_(plan) {
  std::vector<std::string> keys;
  for (campaign::Store::Fixture& each : study::fixtures(plan)) keys.push_back(std::move(each.key));
  numbers_ = store.numbers(keys);
}

std::optional<campaign::Decided> StoredCourse::match(std::uint64_t index, campaign::Metrics metrics) const {
  const study::Fixture fixture = calendar_.at(index);
  return store_.find(static_cast<std::int64_t>(index) + 1, {numbers_[fixture.number], fixture.seed}, metrics);
}

void StoredCourse::play(study::Tournament& course, campaign::Metrics metrics, const After& after) const {
  bool more = true;
  for (std::uint64_t index = 0; more && index < calendar_.matches(); ++index) {
    std::optional<campaign::Decided> decided;
    if (course.wanted(index)) {
      decided = match(index, metrics);
      if (!decided) return;
    }
    const campaign::Decided* const given = decided ? &*decided : nullptr;
    more = course.take(given);
    after(index, given);
  }
}

}  // namespace regista::cli
