// SPDX-License-Identifier: MIT
// The results of a tournament in the order of its schedule, from the file they are kept in.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "campaign/store.hpp"
#include "study/tournament.hpp"
#include "study/tournament_plan.hpp"

namespace regista::cli {

class StoredCourse {
 public:
  // The store must hold the plan's fixtures, as far as it holds matches. Throws campaign::StoreError.
  StoredCourse(const campaign::Store& store, const study::TournamentPlan& plan);

  // The match of a place in the schedule; nothing when it is not there. Throws campaign::StoreError.
  std::optional<campaign::Decided> match(std::uint64_t index, campaign::Metrics metrics) const;

  // Takes all results up to the first gap, or to the tournament's end. `after` is told each, after the course took it;
  // null: one that is not wanted. Throws campaign::StoreError.
  using After = std::function<void(std::uint64_t index, const campaign::Decided* decided)>;
  void play(study::Tournament& course, campaign::Metrics metrics, const After& after) const;

 private:
  const campaign::Store& store_;
  study::Calendar calendar_;
  std::vector<std::int64_t> numbers_;  // of the fixtures, in the store
};

}  // namespace regista::cli
