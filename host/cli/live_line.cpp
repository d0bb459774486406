// SPDX-License-Identifier: MIT
#include "cli/live_line.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cli/terminal.hpp"

namespace regista::cli {
namespace {

constexpr std::chrono::milliseconds between_drawings{100};

}  // namespace

std::string clock_text(double seconds) {
  const auto whole = static_cast<long>(std::floor(seconds));
  return fmt::format("{:02}:{:02}", whole / 60, whole % 60);
}

LiveLine::LiveLine(std::array<std::string, 2> names, bool live, bool goals)
    : names_(std::move(names)), live_(live && can_rewrite()), goals_(goals) {}

LiveLine::~LiveLine() { clear(); }

void LiveLine::second(double time, const match::GameState& state) {
  if (!live_) return;
  const auto now = Clock::now();
  if (now - drawn_ < between_drawings) return;
  drawn_ = now;
  shown_ = true;
  const double rate = time / std::chrono::duration<double>(now - began_).count();
  say(fmt::format("\r\x1b[Khalf {}  {}  {}:{}  {:.0f} s/s  packets left {}, {}", state.half, clock_text(state.clock),
                  state.goals[0], state.goals[1], rate, state.packets_left[0], state.packets_left[1]));
}

void LiveLine::event(const match::Event& event, const match::GameState& state) {
  if (!goals_ || event.kind != match::EventKind::goal) return;
  clear();
  say(fmt::format("{}:{}  goal for {} ({}), half {}, {}\n", state.goals[0], state.goals[1],
                  names_[match::index(event.side)], match::name(event.side), state.half, clock_text(state.clock)));
}

void LiveLine::clear() {
  if (!shown_) return;
  shown_ = false;
  say("\r\x1b[K");
}

}  // namespace regista::cli
