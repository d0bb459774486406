// SPDX-License-Identifier: MIT
// A team against the number of robots that the rules give it.
#pragma once

#include <string>
#include <vector>

#include "config/mistakes.hpp"
#include "config/node.hpp"
#include "config/rules.hpp"
#include "config/team.hpp"

namespace regista::config {

// Tells of every role that only a robot may take which a team of these rules does not have.
void check(const Team& team, const Rules& rules, const Node& document, Mistakes& mistakes);

// Throws Error at the first of them.
void check(const Team& team, const Rules& rules, const Node& document);

// What may be meant, but hardly is.
struct Warning {
  Location where;
  std::string message;
};

// "file:line:column: warning: message", one line
std::string to_string(const Warning& warning);

// For each list of roles that a context plays, in the order of the lists: that it has a role for fewer than all robots
// of a team, how many stand, and which, where that is certain; that nobody plays the ball or searches for it; that
// nobody keeps the goal.
std::vector<Warning> warnings(const Team& team, const Rules& rules, const Node& document);

}  // namespace regista::config
