// SPDX-License-Identifier: MIT
// When a robot bids anew. Utilities change at each tick, and with bids that followed them negotiations would never rest
// (shared rule of the league): a robot bids with its utilities of a moment, and keeps to these until one of them has
// changed by more than a threshold or the tasks that it may take are others. How large the threshold is we chose.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "path.hpp"

namespace consensus_bundle {

class StandingBid {
 public:
  void setup(std::size_t tasks) { tasks_.assign(tasks, Chance{}); }
  // The next look bids anew.
  void forget() { stands_ = false; }

  // chances: as they are now, by task. start: where the robot is.
  void look(std::span<const Chance> chances, const Place& start, double threshold) {
    if (stands_ && !moved(chances, threshold)) return;
    std::copy(chances.begin(), chances.end(), tasks_.begin());
    start_ = start;
    stands_ = true;
  }

  // As they were when the robot bid.
  std::span<const Chance> tasks() const { return tasks_; }
  const Place& start() const { return start_; }

 private:
  bool moved(std::span<const Chance> chances, double threshold) const {
    for (std::size_t task = 0; task < chances.size(); ++task) {
      const Chance &now = chances[task], &then = tasks_[task];
      if (now.allowed != then.allowed) return true;
      if (now.allowed && std::abs(now.utility - then.utility) > threshold) return true;
    }
    return false;
  }

  std::vector<Chance> tasks_;
  Place start_;
  bool stands_ = false;
};

}  // namespace consensus_bundle
