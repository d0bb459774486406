// SPDX-License-Identifier: MIT
// What a referee sees after a physics step: where everything is, who touched what, who lies. World frame, SI units.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "match/geometry.hpp"
#include "match/side.hpp"

namespace regista::match {

// Memory is the match's, for the time of the call. Robots by id (see Roster); what is said of penalised ones is not
// looked at.
struct Scene {
  double time = 0.0;  // s since the start of the match; rises from call to call
  Vector ball{};
  int touched_by = -1;               // robot that touched the ball since the last call
  bool kicked = false;               // it did so with a kick
  std::span<const Vector> robots{};  // where they stand
  std::span<const Vector> steps{};   // where their legs carry them, m/s; empty: nobody walks
  RobotSet turning = 0;              // on their feet, whether or not they walk
  RobotSet touching = 0;             // the ball
  RobotSet fallen = 0, kicking = 0;  // lies or gets up; a kick is under way
  RobotSet acted = ~RobotSet{0};     // has decided something since the last call, or need not have
  RobotSet at_walls = 0;             // touches border, goal post or net
  std::span<const std::array<std::int8_t, 2>> contacts{};  // of robots with robots: two ids each
};

}  // namespace regista::match
