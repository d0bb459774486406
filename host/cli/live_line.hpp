// SPDX-License-Identifier: MIT
// The course of a match on standard error. On a terminal one line that is rewritten in place: half, clock, score,
// simulated seconds per second, packets left. Elsewhere nothing. Goals as lines of their own when asked for.
#pragma once

#include <array>
#include <chrono>
#include <string>

#include "command/terminal.hpp"
#include "match/game_state.hpp"

namespace regista::cli {

// "03:12"; minutes may have more than two digits
std::string clock_text(double seconds);

class LiveLine {
 public:
  // names: of the teams. live: show the line if standard error is a terminal. goals: a line for each goal.
  LiveLine(std::array<std::string, 2> names, bool live, bool goals);

  void second(double time, const match::GameState& state);
  void event(const match::Event& event, const match::GameState& state);
  void clear() { line_.clear(); }

 private:
  using Clock = std::chrono::steady_clock;
  std::array<std::string, 2> names_;
  bool goals_;
  command::RewrittenLine line_;
  Clock::time_point began_ = Clock::now();
};

}  // namespace regista::cli
