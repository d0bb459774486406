// SPDX-License-Identifier: MIT
// Which changes of roles the robots concerned have all agreed to (Weigel, Gutmann, Dietl, Kleiner and Nebel, "CS
// Freiburg: Coordinating Robots for Successful Soccer Playing", IEEE T-RA 18(5), 2002: a change needs the wish of
// both).
//
// Everybody keeps one table: for each robot the role that it plays and the one that it has said to wish for. From a
// robot to the holder of the role that it wishes for, to the holder of the role which that one wishes for, and so on
// leads a chain. All robots of it change when it ends in a free role, or at a robot that wishes for none, or returns to
// its beginning. A robot that wishes for what it has, or that was not heard, ends the chain without a change. All who
// have the same table find the same changes, so nobody has to say that a change has taken place.
//
// Our decision: of several robots that wish for one free role, the one with the largest utility gets it, of equal ones
// the one with the lowest number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "message.hpp"

namespace role_exchange {

// A robot's line of the table. Who was not heard holds and wishes the same.
struct Holding {
  std::int32_t role = no_role, wish = no_role;
  bool wants_change() const { return wish != role; }
};

// Reuse one object: it keeps its memory.
class Agreement {
 public:
  static constexpr std::size_t nobody = static_cast<std::size_t>(-1);

  void reserve(std::size_t robots) { next_.reserve(robots); }

  // Makes all changes of `table` that are agreed. utility(robot, role): of the robot in the table's order.
  template <class Utility>
  void settle(std::span<Holding> table, const Utility& utility) {
    while (fill_free_role(table, utility) || relieve(table, utility) || turn_circle(table, utility)) {
    }
  }

  // Who plays the role. When several say so, the one with the largest utility, of equal ones the first.
  template <class Utility>
  static std::size_t holder(std::span<const Holding> table, std::int32_t role, const Utility& utility) {
    return best(table, role, utility, [&](const Holding& each) { return each.role == role; });
  }

 private:
  template <class Utility, class Fits>
  static std::size_t best(std::span<const Holding> table, std::int32_t role, const Utility& utility, const Fits& fits) {
    std::size_t found = nobody;
    for (std::size_t robot = 0; robot < table.size(); ++robot) {
      if (!fits(table[robot])) continue;
      if (found == nobody || utility(robot, role) > utility(found, role)) found = robot;
    }
    return found;
  }
  template <class Utility>
  static std::size_t best_who_wishes(std::span<const Holding> table, std::int32_t role, const Utility& utility) {
    return best(table, role, utility, [&](const Holding& each) { return each.wish == role && each.wants_change(); });
  }

  template <class Utility>
  static bool fill_free_role(std::span<Holding> table, const Utility& utility) {
    for (const Holding& each : table) {
      const std::int32_t role = each.wish;
      if (role == no_role || !each.wants_change() || holder(table, role, utility) != nobody) continue;
      table[best_who_wishes(table, role, utility)].role = role;
      return true;
    }
    return false;
  }

  // Somebody wishes for the role of a robot that wishes for none.
  template <class Utility>
  static bool relieve(std::span<Holding> table, const Utility& utility) {
    for (Holding& each : table) {
      if (each.role == no_role || each.wish != no_role) continue;
      const std::size_t winner = best_who_wishes(table, each.role, utility);
      if (winner == nobody) continue;
      table[winner].role = each.role;
      each.role = no_role;
      return true;
    }
    return false;
  }

  // A circle of robots, each of which wishes for the role of the next one.
  template <class Utility>
  bool turn_circle(std::span<Holding> table, const Utility& utility) {
    next_.assign(table.size(), nobody);
    for (std::size_t robot = 0; robot < table.size(); ++robot) {
      const Holding& each = table[robot];
      if (each.wish != no_role && each.wants_change()) next_[robot] = holder(table, each.wish, utility);
    }
    for (std::size_t first = 0; first < table.size(); ++first) {
      std::size_t robot = next_[first];
      for (std::size_t steps = 1; steps < table.size() && robot != nobody && robot != first; ++steps) {
        robot = next_[robot];
      }
      if (robot != first) continue;
      do {
        table[robot].role = table[robot].wish;
        robot = next_[robot];
      } while (robot != first);
      return true;
    }
    return false;
  }

  std::vector<std::size_t> next_;
};

}  // namespace role_exchange
