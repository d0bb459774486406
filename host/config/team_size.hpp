// SPDX-License-Identifier: MIT
// A team against the number of robots that the rules give it.
#pragma once

#include "config/mistakes.hpp"
#include "config/node.hpp"
#include "config/rules.hpp"
#include "config/team.hpp"

namespace regista::config {

// Tells of every role that only a robot may take which a team of these rules does not have.
void check(const Team& team, const Rules& rules, const Node& document, Mistakes& mistakes);

// Throws Error at the first of them.
void check(const Team& team, const Rules& rules, const Node& document);

}  // namespace regista::config
