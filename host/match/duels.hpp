// SPDX-License-Identifier: MIT
// Duels: for 1 s or more at least one able robot of each team is within 0.5 m of the ball in play. Won by the side that
// touches the ball next once that no longer holds, or scores; undecided when the ball is dead before. When it holds
// again before anybody has touched the ball, the same duel goes on.
//
// A duel is of the robot of each team that was nearest to the ball when it began.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "match/arena.hpp"
#include "match/side.hpp"

namespace regista::match {

constexpr double duel_reach = 0.5;     // m; assumption: two steps from the ball
constexpr double shortest_duel = 1.0;  // s; assumption: shorter is two robots that meet in passing

class Duels {
 public:
  explicit Duels(int team_size) : roster_{team_size} {}

  struct Duel {
    std::array<int, 2> robots{};  // ids, by side
    Side nearer = Side::home;     // whose robot was nearer to the ball when it began
    double began = 0.0;           // s
    Vector at;                    // of the ball then
    int samples = 0;              // how long it held
    std::optional<Side> won;
  };

  // Ten times in a second while the ball is in play; able: who is active, stands and has not crashed.
  void sample(std::span<const BodyState> bodies, RobotSet able, double time);
  // These three decide a duel, if there is one to decide.
  std::optional<Duel> touched(Side side);
  std::optional<Duel> scored(Side side);
  std::optional<Duel> dead();  // the ball, or the match

 private:
  std::optional<Duel> ended(std::optional<Side> won);

  Roster roster_;
  std::optional<Duel> duel_;
  bool holds_ = false;  // in the last sample
};

}  // namespace regista::match
