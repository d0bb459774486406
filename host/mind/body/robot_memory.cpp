// SPDX-License-Identifier: MIT
#include "mind/body/robot_memory.hpp"

#include <cmath>

namespace regista::mind {
namespace {

constexpr double remembered_for = 1.0;  // s: a robot walks its own diameter in that time
constexpr double same_within = 0.35;    // m
constexpr double near = 2.0;            // m: who is farther away is not in the way yet

}  // namespace

void RobotMemory::update(const Percepts& percepts, const Frame2& own, double touching) {
  for (std::size_t i = 0; i < count_;) {
    if (percepts.time - times_[i] > remembered_for) {
      forget(i);
    } else {
      ++i;
    }
  }
  for (const RobotSighting& seen : percepts.robots) {
    if (seen.position.squaredNorm() < near * near) remember(own.to_field(seen.position), percepts.time);
  }
  if (percepts.contact) {
    const double bearing = *percepts.contact;
    remember(own.to_field(touching * Vector2d(std::cos(bearing), std::sin(bearing))), percepts.time);
  }
}

void RobotMemory::remember(const Vector2d& position, double time) {
  for (std::size_t i = 0; i < count_; ++i) {
    if (times_[i] < time && (positions_[i] - position).squaredNorm() < same_within * same_within) {
      forget(i);
      break;
    }
  }
  if (count_ == most) forget(0);
  positions_[count_] = position;
  times_[count_] = time;
  ++count_;
}

void RobotMemory::forget(std::size_t index) {
  for (std::size_t i = index + 1; i < count_; ++i) {
    positions_[i - 1] = positions_[i];
    times_[i - 1] = times_[i];
  }
  --count_;
}

}  // namespace regista::mind
