// SPDX-License-Identifier: MIT
// Checks a team against the rules of its matches. An Error means that the team cannot play. A Warning means that the
// team can play, but probably not as its author intended.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "config/errors.hpp"
#include "config/node.hpp"
#include "config/rules.hpp"
#include "config/team.hpp"

namespace regista::config {

// The area that robots may enter: the field and the strip around it.
struct Carpet {
  double x, y;  // m, from the centre to the edges

  explicit Carpet(const FieldSize& field)
      : x(field.length / 2.0 + field.border_strip), y(field.width / 2.0 + field.border_strip) {}

  bool holds(const std::array<double, 2>& point) const { return std::abs(point[0]) <= x && std::abs(point[1]) <= y; }

  // Returns the end of a message about a place outside of the carpet: "off the field, ..."
  std::string off() const;
};

// Reports every role whose robot number exceeds the team size of the rules. The second function throws the first Error.
void check(const Team& team, const Rules& rules, const Node& document, Mistakes& mistakes);
void check(const Team& team, const Rules& rules, const Node& document);

struct Warning {
  Location where;
  std::string message;
};

std::string to_string(const Warning& warning);  // "file:line:column: warning: message", one line

// Returns whether the document alone proves that the context always holds (`plugin: always`).
bool always_holds(const Context& context);

// Returns the warnings, causes before effects: 1. Contexts that are never in force, because a context above them always
// holds. 2. Role lists that no context uses. 3. Defects of each used role list: no role plays or searches for the ball;
// no role keeps the goal; all roles are for one robot; a target is always off the carpet; the list has fewer roles than
// the team has robots. The warning about too few roles gives the robots without a role by number, or only their count.
std::vector<Warning> warnings(const Team& team, const Rules& rules, const Node& document);

}  // namespace regista::config
