// SPDX-License-Identifier: MIT
#include "match/replay.hpp"

namespace regista::match {

Replay::Replay(const Recording& recording)
    : recording_(recording), arena_(recording.field, recording.ball, recording.robots) {}

bool Replay::step() {
  if (next_ == recording_.step_ends.size()) return false;
  const std::size_t end = recording_.step_ends[next_++];
  arena_.replay_step(std::span(recording_.operations).subspan(done_, end - done_));
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
