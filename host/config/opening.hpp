// SPDX-License-Identifier: MIT
// An opening: the places of ball and robots from which a short game starts. Chess engines are tested in a similar way,
// from positions of an opening book. World frame: origin at the centre, home attacks towards +x, y to the left of home.
// SI units; radians in memory (degrees in YAML, in keys that end in _deg).
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
    std::optional<double> heading;  // rad; missing: the player faces the ball
  };

  std::string name;
  std::string summary;   // description for people, one line
  double length = 30.0;  // length of the game, s
  Ball ball;
  // The players in the order of shirt numbers, from 1. A team with fewer robots than players uses the first players.
  std::vector<Player> home, away;
};

Map declare(Opening& opening);

// Returns the heading of a player, rad in [-pi, pi]. A player without a heading faces the ball.
double heading(const Opening& opening, const Opening::Player& player);

// A reason why an opening is not playable, and the path of the wrong value ("home.2.at").
struct Misfit {
  std::string path, reason;
  std::string other = {};  // path of a second value that conflicts with the value at `path`; empty: no second value
};

// Finds conflicts of an opening with the rules or with the robots of home and away: too few places; a robot outside of
// the border, on another robot, on the ball or in a goal frame; a ball outside of the lines. Ignores players
// beyond the team size of the rules.
std::vector<Misfit> misfits(const Opening& opening, const Rules& rules, const std::array<Robot, 2>& robots);

inline void check(const Opening& /*opening*/, const Node& /*document*/, Mistakes& /*mistakes*/) {}
// Reports the results of misfits() as mistakes of the document.
void check(const Opening& opening, const Rules& rules, const std::array<Robot, 2>& robots, const Node& document,
           Mistakes& mistakes);

// Returns the first result of misfits(), if there is one.
std::optional<Misfit> misfit(const Opening& opening, const Rules& rules, const std::array<Robot, 2>& robots);

}  // namespace regista::config
