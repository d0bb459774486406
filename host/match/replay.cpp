// SPDX-License-Identifier: MIT
#include "match/replay.hpp"

namespace regista::match {

Replay::Replay(const PhysicsLog& log) : log_(log), arena_(log.field, log.ball, log.robots) {}

bool Replay::step() {
  if (next_ == log_.step_ends.size()) return false;
  const std::size_t end = log_.step_ends[next_++];
  arena_.replay_step(std::span(log_.operations).subspan(done_, end - done_));
  done_ = end;
  return true;
}

void Replay::run() {
  while (step()) {
  }
}

std::span<const BodyState> Replay::states() {
  arena_.observe();
  return arena_.states();
}

}  // namespace regista::match
