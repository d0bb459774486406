// SPDX-License-Identifier: MIT
#include "match/metrics_targets.hpp"

#include <algorithm>
#include <limits>

#include "match/sampling.hpp"

namespace regista::match {

TargetMeasures::TargetMeasures(int team_size) : targets_(at(team_size)) { now_.reserve(at(team_size)); }

void TargetMeasures::sample(std::uint32_t active) {
  now_.clear();
  for (std::size_t robot = 0; robot < targets_.size(); ++robot) {
    if ((active >> robot & 1u) != 0 && targets_[robot]) now_.push_back(*targets_[robot]);
  }
  if (now_.size() < 2) return;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < now_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = length(now_[i] - now_[j]);
      all_ += distance;
      least = std::min(least, distance);
      ++pairs_;
    }
  }
  least_ += least;
  ++samples_;
}

TargetMetrics TargetMeasures::result() const { return {mean(all_, pairs_), mean(least_, samples_)}; }

}  // namespace regista::match
