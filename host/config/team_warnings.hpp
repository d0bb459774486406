// SPDX-License-Identifier: MIT
// What a sound team may mean, but hardly does.
#pragma once

#include <string>
#include <vector>

#include "config/node.hpp"
#include "config/rules.hpp"
#include "config/team.hpp"

namespace regista::config {

struct Warning {
  Location where;
  std::string message;
};

// "file:line:column: warning: message", one line
std::string to_string(const Warning& warning);

// Whether it holds at all times by the page alone: plugin: always.
bool always_holds(const Context& context);

// Contexts that are never in force, because one above them always holds. Then in the order of the lists of roles. Of a
// list that no context plays: that. Of each other one: that nobody plays the ball or searches for it; that nobody keeps
// the goal; roles that are all for one robot; targets that are always off the carpet; that it has a role for fewer than
// all robots of a team, how many stand, and which, where that is certain. In this order, so that what explains the last
// one stands before it.
std::vector<Warning> warnings(const Team& team, const Rules& rules, const Node& document);

}  // namespace regista::config
