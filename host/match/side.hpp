// SPDX-License-Identifier: MIT
// The two sides of a match. A side is a colour slot, not a team: luck and kick-off belong to it, whoever plays there.
//
// The world frame has its origin at the centre and x along the field. In odd halves home attacks towards +x, in even
// halves towards -x; the field is symmetric, so a change of sides is a change of frames and nothing else.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "match/geometry.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

enum class Side { home = 0, away = 1 };

constexpr std::array<Side, 2> both_sides{Side::home, Side::away};
constexpr Side opposite(Side side) { return side == Side::home ? Side::away : Side::home; }
constexpr std::size_t index(Side side) { return static_cast<std::size_t>(side); }
constexpr const char* name(Side side) { return side == Side::home ? "home" : "away"; }

// +1 when the side attacks the goal at +x of the world frame in this half (counted from 1), else -1.
constexpr double attack(Side side, int half) { return (side == Side::home) == (half % 2 == 1) ? 1.0 : -1.0; }

// A pose of the world frame in the field frame of a side that attacks towards `direction`, and back: a half turn, or
// nothing.
inline mind::Pose in_field_frame(const mind::Pose& world, double direction) {
  if (direction > 0.0) return {world.x, world.y, wrapped(world.heading)};
  return {-world.x, -world.y, wrapped(world.heading + std::numbers::pi)};
}

// Robots are counted through both sides: home 1..n are 0..n-1, away 1..n are n..2n-1.
struct Roster {
  int team_size = 0;
  constexpr int count() const { return 2 * team_size; }
  constexpr int id(Side side, int number) const { return (side == Side::home ? 0 : team_size) + number - 1; }
  constexpr Side side(int id) const { return id < team_size ? Side::home : Side::away; }
  constexpr int number(int id) const { return id % team_size + 1; }
};

constexpr int largest_team = 22;

// A set of robots of both sides: bit id.
using RobotSet = std::uint64_t;
static_assert(2 * largest_team <= 64);
constexpr RobotSet only(int id) { return RobotSet{1} << id; }
constexpr bool contains(RobotSet set, int id) { return (set & only(id)) != 0; }

}  // namespace regista::match
