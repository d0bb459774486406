// SPDX-License-Identifier: MIT
// What robots are told, and when. RoboCup SPL rule book 2023: the game controller sends Goal -> Ready and Set ->
// Playing late, everything else at once; the whistle is the only early cue, and not every robot hears it.
//
// A robot that hears a whistle in Set plays at once. One that hears it while it plays takes it for a goal and gets
// ready; who scored, and so whose kick-off it is, it learns from the network. A robot knows its own penalty.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "config/rules.hpp"
#include "match/game_state.hpp"

namespace regista::match {

class Told {
 public:
  explicit Told(const config::Rules& rules);

  // The game controller sends `state` now, to arrive `delay` s later. follows: it arrives at once, but only at robots
  // that know what was announced before it (a kick-off's ball is free: no news for who has not heard of the kick-off).
  void announce(const GameState& state, double time, double delay, bool follows);

  // Robot `id` has heard the referee's whistle.
  void whistle(int id, double time);

  // What robot `id` knows of the game at `time`. Penalties and budget are those
  // of `state`, which is the truth; the clock runs on from the latest announcement that it knows.
  void tell(int id, const GameState& state, double time, mind::GameTold& out);

 private:
  struct Announcement {
    mind::Phase phase = mind::Phase::initial;
    mind::SetPlay set_play = mind::SetPlay::none;
    Side kicking = Side::home;
    int half = 1;
    std::array<int, 2> score{};
    double began = 0.0, arrives = 0.0;
    bool follows = false;
    double clock = 0.0, said = 0.0;  // s played of the half when this was said, and when that was
    bool clock_runs = false;
  };
  struct Robot {
    std::uint64_t known = 0;  // the latest announcement it knows
    bool ready_by_whistle = false;
    double ready_since = 0.0;
  };
  // The latest few; older ones have reached everybody.
  static constexpr std::uint64_t kept = 64;
  const Announcement& at(std::uint64_t i) const { return announcements_[static_cast<std::size_t>(i % kept)]; }
  void catch_up(Robot& robot, double time) const;
  void know(Robot& robot, std::uint64_t i) const;

  config::Durations durations_;
  Roster roster_;
  std::array<Announcement, kept> announcements_;
  std::uint64_t last_ = 0;  // number of the latest announcement; the first is 1, 0 is "nothing yet"
  std::vector<Robot> robots_;
};

}  // namespace regista::match
