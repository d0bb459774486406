// SPDX-License-Identifier: MIT
// How far the robots of one team want to stand from each other: the distances between the targets of two active
// robots, each where that robot last decided to play its own task. In the phase Playing; the goalkeeper counts like all
// others, and robots without a task do not.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "match/geometry.hpp"

namespace regista::match {

// Nothing where no two robots ever had a target at once.
struct TargetMetrics {
  std::optional<double> mean_metres;   // over all pairs of all samples
  std::optional<double> least_metres;  // of the pair that is nearest together; mean over samples
};

class TargetMeasures {
 public:
  explicit TargetMeasures(int team_size);

  // Robot `number` has decided; target: in the same frame as those of the others.
  void decided(int number, std::optional<Vector> target) { targets_[static_cast<std::size_t>(number - 1)] = target; }

  // A sample; active: bit n - 1 for robot n.
  void sample(std::uint32_t active);

  TargetMetrics result() const;

 private:
  std::vector<std::optional<Vector>> targets_;  // by robot
  std::vector<Vector> now_;                     // of active robots, in this sample
  int samples_ = 0, pairs_ = 0;
  double all_ = 0.0, least_ = 0.0;  // m, sums over pairs and over samples
};

}  // namespace regista::match
