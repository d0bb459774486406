// SPDX-License-Identifier: MIT
// The two sides of a match. A side is a colour slot, not a team. Random numbers and kick-off belong to the side.
//
// The world frame has its origin at the centre and x along the field. Home attacks towards +x in odd halves and towards
// -x in even halves. The field is symmetric, so a change of sides changes only the frames.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>

#include "match/plane.hpp"
#include "mind/geometry.hpp"

namespace regista::match {

enum class Side { home = 0, away = 1 };

constexpr std::array<Side, 2> both_sides{Side::home, Side::away};
constexpr Side opposite(Side side) { return side == Side::home ? Side::away : Side::home; }
constexpr std::size_t index(Side side) { return static_cast<std::size_t>(side); }

// Converts the number of a robot, role or body to std::size_t. The value stays the same.
constexpr std::size_t at(int number) { return static_cast<std::size_t>(number); }

constexpr const char* name(Side side) { return side == Side::home ? "home" : "away"; }

// Returns +1 if the side attacks the goal at +x of the world frame in this half, else -1. half: from 1.
constexpr double attack(Side side, int half) { return (side == Side::home) == (half % 2 == 1) ? 1.0 : -1.0; }

// Converts a world pose to the field frame of a side that attacks towards `direction` (+1 or -1), and back.
inline mind::Pose in_field_frame(const mind::Pose& world, double direction) {
  if (direction > 0.0) return {world.x, world.y, mind::wrap(world.heading)};
  return {-world.x, -world.y, mind::wrap(world.heading + mind::pi)};
}

constexpr int largest_team = 22;

using RobotSet = std::uint64_t;  // A set of robots of both sides: bit `id` stands for robot `id`.
static_assert(2 * largest_team <= 64);
constexpr RobotSet only(int id) { return RobotSet{1} << id; }
constexpr bool contains(RobotSet set, int id) { return (set & only(id)) != 0; }

// Converts between robot ids and (side, shirt number). Home 1..n have the ids 0..n-1; away 1..n have n..2n-1.
struct Roster {
  int team_size = 0;
  constexpr int count() const { return 2 * team_size; }
  constexpr int id(Side side, int number) const { return (side == Side::home ? 0 : team_size) + number - 1; }
  constexpr Side side(int id) const { return id < team_size ? Side::home : Side::away; }
  constexpr int number(int id) const { return id % team_size + 1; }
  constexpr RobotSet everybody() const { return only(count()) - 1; }
  constexpr RobotSet team(Side side) const { return (only(team_size) - 1) << (side == Side::home ? 0 : team_size); }
};

// Iterates over the ids of a set in ascending order: for (const int id : Members(set)).
class Members {
 public:
  explicit constexpr Members(RobotSet set) : rest_(set) {}
  constexpr Members begin() const { return *this; }
  constexpr std::default_sentinel_t end() const { return {}; }
  constexpr int operator*() const { return std::countr_zero(rest_); }
  constexpr void operator++() { rest_ &= rest_ - 1; }
  constexpr bool operator==(std::default_sentinel_t) const { return rest_ == 0; }

 private:
  RobotSet rest_;
};

// Returns the robots of `among` for which condition(id) holds.
template <class Condition>
RobotSet those(RobotSet among, Condition condition) {
  RobotSet out = 0;
  for (const int id : Members(among)) {
    if (condition(id)) out |= only(id);
  }
  return out;
}

// Returns the robot of `among` with the least value(id); of equal values, the lowest id. -1: no robot is in `among`.
template <class Value>
int with_least(RobotSet among, Value value) {
  int best = -1;
  double lowest = std::numeric_limits<double>::infinity();
  for (const int id : Members(among)) {
    if (const double own = value(id); own < lowest) {
      lowest = own;
      best = id;
    }
  }
  return best;
}

}  // namespace regista::match
