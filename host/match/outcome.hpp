// SPDX-License-Identifier: MIT
// What a match does with an outcome of a mind before anything comes of it: is it sound, and into the hash with it.
#pragma once

#include <cstddef>
#include <string>

#include "config/robot.hpp"
#include "match/digest.hpp"
#include "mind/command.hpp"

namespace regista::match {

// How many of each a team has.
struct TeamCounts {
  std::size_t roles = 0, reasons = 0, plugin_metrics = 0;
};

// Why it is not sound: not finite, no such kick of the robot, no such role, task, reason to send or metric of the team.
// Empty when it is.
std::string unsound(const mind::Outcome& outcome, const config::Robot& robot, const TeamCounts& team);

// All of the outcome that a match acts on.
void add(Digest& digest, const mind::Outcome& outcome);

}  // namespace regista::match
