// SPDX-License-Identifier: MIT
// What a behaviour wants its body to do until the next decision.
#pragma once

#include <optional>
#include <variant>

#include "situation.hpp"

namespace behaviours {

struct Stand {};

struct Turn {
  double rate = 0.0;  // rad/s, to the left
};

// The centre of the robot stays out of it.
struct Disc {
  Vector2d centre{0, 0};
  double radius = 0.0;
};

// The host finds the way around robots and goals.
struct WalkTo {
  Pose target;
  bool brisk = false;            // at full speed, also on arrival
  bool straight = false;         // around nobody
  std::optional<Disc> around{};  // one more disc
  // Turn as on the way to the target, but walk with this velocity, robot frame.
  std::optional<Vector2d> creep{};
};

struct KickBall {
  int kind = 0;            // of the kicks that the robot has
  double direction = 0.0;  // in which the ball shall go, robot frame
  double distance = 0.0;   // that it shall roll
  int receiver = 0;        // the teammate that it is meant for, 0 = nobody
};

using Movement = std::variant<Stand, Turn, WalkTo, KickBall>;

}  // namespace behaviours
