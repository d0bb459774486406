// SPDX-License-Identifier: MIT
#include "match/metrics_tenure.hpp"

#include <algorithm>
#include <cmath>

#include "match/arena.hpp"
#include "match/sampling.hpp"

namespace regista::match {

TenureMeasures::TenureMeasures(int team_size, double longest) : held_(at(team_size)) {
  finished_.reserve(static_cast<std::size_t>(longest / physics_step) + 1);
}

void TenureMeasures::decided(int number, int role, double time, bool plays) {
  Held& held = held_[at(number - 1)];
  if (!plays) {
    held.role = -1;
    return;
  }
  if (role == held.role) return;
  if (held.role >= 0) {
    const auto steps = static_cast<std::size_t>(std::lround((time - held.since) / physics_step));
    if (steps >= finished_.size()) finished_.resize(steps + 1);
    ++finished_[steps];
    ++count_;
  }
  held = {role, time};
}

void TenureMeasures::crashed(int number) { held_[at(number - 1)].role = -1; }

double TenureMeasures::shortest_but(std::size_t rank) const {
  std::size_t steps = 0;
  for (std::size_t before = finished_[0]; before <= rank; before += finished_[steps]) ++steps;
  return static_cast<double>(steps) * physics_step;
}

double TenureMeasures::quantile(double probability) const {
  const double place = probability * static_cast<double>(count_ - 1);
  const auto below = static_cast<std::size_t>(place);
  const double lower = shortest_but(below), upper = shortest_but(std::min(below + 1, count_ - 1));
  return lower + (place - static_cast<double>(below)) * (upper - lower);
}

TenureMetrics TenureMeasures::result() const {
  if (count_ == 0) return {};
  return {quantile(0.5), quantile(0.1)};
}

}  // namespace regista::match
