// SPDX-License-Identifier: MIT
// What was done to the bodies of an arena, step by step, so that the bare physics of a match can be played again.
#pragma once

#include <cstdint>
#include <vector>

#include "config/robot.hpp"
#include "config/rules.hpp"

namespace regista::match {

// body: robot id, or the number of robots for the ball. x, y, turn: m/s and rad/s, or m and rad.
struct Operation {
  enum class Kind : std::uint16_t { velocity, place };
  std::uint16_t body;
  Kind kind;
  float x, y, turn;
};

struct PhysicsLog {
  config::FieldSize field;
  config::BallSize ball;
  std::vector<config::Body> robots;
  std::vector<Operation> operations;     // of all steps, in order
  std::vector<std::uint32_t> step_ends;  // operations before the end of each step, so step n does [n - 1], [n])
};

}  // namespace regista::match
