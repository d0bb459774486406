// SPDX-License-Identifier: MIT
// An opening: a scene in the middle of a game from which a short one starts, as chess engines start from positions of a
// book. World frame: origin at the centre, home attacks towards +x, y to the left of home. SI units; radians in memory
// (degrees in YAML, in keys that end in _deg).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "config/declaration.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"

namespace regista::config {

struct Opening {
  struct Ball {
    std::array<double, 2> at{};        // m
    std::array<double, 2> velocity{};  // m/s
  };
  struct Player {
    std::array<double, 2> at{};     // m, centre of the torso
    std::optional<double> heading;  // rad; none: looks at the ball
  };

  std::string name;
  std::string summary;   // for people; one line
  double length = 30.0;  // s of play, then the game ends
  Ball ball;
  // Number 1 first. A team of fewer robots uses the first ones.
  std::vector<Player> home, away;
};

Map declare(Opening& opening);

// Heading of a player of this opening, rad in [-pi, pi] where the document says none: towards the ball.
double heading(const Opening& opening, const Opening::Player& player);

// Why an opening cannot be played, and the path of the value that is to blame ("home.2.at").
struct Misfit {
  std::string path, reason;
  std::string other = {};  // path of the value that it does not go with, where that is one of the opening, too
};

// What of the opening does not go with rules and robots (by side: home, away): too few places for a team, somebody
// beyond the border, on another, on the ball or in a goal's frame, or the ball not within the lines. Looks at the
// robots that take part alone.
std::vector<Misfit> misfits(const Opening& opening, const Rules& rules, const std::array<Robot, 2>& robots);

// The same as mistakes of the document.
inline void check(const Opening& /*opening*/, const Node& /*document*/, Mistakes& /*mistakes*/) {}
// Against what it is played by.
void check(const Opening& opening, const Rules& rules, const std::array<Robot, 2>& robots, const Node& document,
           Mistakes& mistakes);

// The first of them.
std::optional<Misfit> misfit(const Opening& opening, const Rules& rules, const std::array<Robot, 2>& robots);

}  // namespace regista::config
