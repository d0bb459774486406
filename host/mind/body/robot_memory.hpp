// SPDX-License-Identifier: MIT
// Robots of either team that were seen a moment ago, for walking around them: a detector misses every third robot, and
// the head looks elsewhere, but who stood there a second ago still does.
#pragma once

#include <array>
#include <span>

#include "mind/geometry.hpp"
#include "mind/percepts.hpp"

namespace regista::mind {

class RobotMemory {
 public:
  static constexpr std::size_t most = 16;
  // `own`: frame of the own pose when the percepts were taken. touching: between the centres of robots in contact.
  void update(const Percepts& percepts, const Frame2& own, double touching);
  // Field frame, the latest seen last.
  std::span<const Vector2d> positions() const { return {positions_.data(), count_}; }

 private:
  void remember(const Vector2d& position, double time);
  void forget(std::size_t index);

  std::array<Vector2d, most> positions_;
  std::array<double, most> times_{};
  std::size_t count_ = 0;
};

}  // namespace regista::mind
