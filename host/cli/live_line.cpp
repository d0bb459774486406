// SPDX-License-Identifier: MIT
#include "cli/live_line.hpp"

#include <fmt/format.h>

#include <cmath>

#include "command/terminal.hpp"

namespace regista::cli {

std::string clock_text(double seconds) {
  const auto whole = static_cast<long>(std::floor(seconds));
  return fmt::format("{:02}:{:02}", whole / 60, whole % 60);
}

LiveLine::LiveLine(std::array<std::string, 2> names, bool live, bool goals)
    : names_(std::move(names)), goals_(goals), line_(live) {}

void LiveLine::second(double time, const match::GameState& state) {
  if (!line_.due()) return;
  const double rate = time / std::chrono::duration<double>(Clock::now() - began_).count();
  line_.show(fmt::format("half {}  {}  {}:{}  {:.0f} s/s  packets left {}, {}", state.half, clock_text(state.clock),
                         state.goals[0], state.goals[1], rate, state.packets_left[0], state.packets_left[1]));
}

void LiveLine::event(const match::Event& event, const match::GameState& state) {
  if (!goals_ || event.kind != match::EventKind::goal) return;
  clear();
  command::say(fmt::format("{}:{}  goal for {} ({}), half {}, {}\n", state.goals[0], state.goals[1],
                           names_[match::index(event.side)], match::name(event.side), state.half,
                           clock_text(state.clock)));
}

}  // namespace regista::cli
