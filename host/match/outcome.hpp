// SPDX-License-Identifier: MIT
// What a match does with an outcome of a mind before anything comes of it: is it sound, and into the hash with it.
#pragma once

#include <string>

#include "config/robot.hpp"
#include "match/digest.hpp"
#include "mind/command.hpp"

namespace regista::match {

// Why it is not sound: not finite, no such kick of the robot, no such role or task of `roles`, none of so many reasons
// to send. Empty when it is.
std::string unsound(const mind::Outcome& outcome, const config::Robot& robot, std::size_t roles, std::size_t reasons);

// The command, and all of the outcome that a match acts on.
void add(Digest& digest, const mind::Command& command);
void add(Digest& digest, const mind::Outcome& outcome);

}  // namespace regista::match
