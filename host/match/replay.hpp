// SPDX-License-Identifier: MIT
// The bare physics of a recorded match: the same bodies, the same velocities, Box2D alone. It is what the time of a
// whole match is measured against, so it does nothing that a match could do without.
#pragma once

#include <cstddef>

#include "match/arena.hpp"
#include "match/physics_log.hpp"

namespace regista::match {

class Replay {
 public:
  // `log` is the caller's and must live as long. It must have been started before the first step.
  explicit Replay(const PhysicsLog& log);

  std::size_t steps() const { return log_.step_ends.size(); }
  bool step();  // one physics step; false when the log is over
  void run();   // all that is left
  // As after the last step, so equal to the match's states there, but for the ball's velocity, which lacks the second
  // half of that step's rolling friction.
  std::span<const BodyState> states();

 private:
  const PhysicsLog& log_;
  Arena arena_;
  std::size_t next_ = 0, done_ = 0;
};

}  // namespace regista::match
