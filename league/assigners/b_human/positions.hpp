// SPDX-License-Identifier: MIT
// Who takes which position in B-Human (see active_player.hpp): the lexicographically least sorted list of the distances
// between base points and the poses that were last *sent*, where who holds a position counts as 1 m nearer to it. As
// all robots, the own one too, stand where their last packet says, all compute on one table. The search is that of
// SCRAM (MMDR; MacAlpine, Price and Stone 2015).
//
// Decided by us: of a position that several say to hold, the lowest number is the holder; distances are whole
// millimetres, so that no rounding decides. Teammates may know other tasks than this robot:
//   - one that says to do a task that this robot does not have, while it has some that this robot has, is at work
//     elsewhere and takes none here;
//   - one that has some of this robot's tasks takes none that it does not have.
// Who has none of them, or was not heard to say, is believed to follow soon (it spoke last in another context).
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <plugins/assigners/scram/algorithm.hpp>

#include "active_player.hpp"
#include "statement.hpp"

namespace b_human {

struct Member {
  std::int32_t x = 0, y = 0;      // mm: as last sent
  std::int32_t claims = -1;       // task that it says to do, unless that is too old
  const TaskList* has = nullptr;  // the tasks that it said to have; nullptr: it has said nothing of them
};

struct Position {
  std::int32_t id = 0;
  Point base;
};

// Whether the tasks of a teammate are those of this robot.
class Common {
 public:
  Common(const Member& member, std::span<const Position> tasks) : has_(member.has) {
    if (has_ == nullptr) return;
    bool knows_one = false, claims_one = false;
    for (const Position& task : tasks) {
      knows_one = knows_one || has_->has(task.id);
      claims_one = claims_one || member.claims == task.id;
    }
    if (!knows_one) has_ = nullptr;
    elsewhere_ = knows_one && member.claims >= 0 && !claims_one;
  }
  bool can_take(const Position& task) const { return has_ == nullptr || (!elsewhere_ && has_->has(task.id)); }

 private:
  const TaskList* has_;  // nullptr: it may take all
  bool elsewhere_ = false;
};

class Positions {
 public:
  void reserve(std::size_t robots, std::size_t tasks) {
    solver_.reserve(robots, tasks);
    costs_.reserve(robots * tasks);
  }

  // allowed(row, column): the pair is not forbidden. order: every column once, the most important first; choice: which
  // are taken when not all can be. out[row] := column or -1.
  template <class Allowed>
  void assign(std::span<const Member> members, std::span<const Position> tasks, const Allowed& allowed,
              std::int32_t holder_bonus, std::span<const std::uint32_t> order, std::span<const std::uint32_t> choice,
              std::span<std::int32_t> out) {
    const std::size_t columns = tasks.size();
    costs_.assign(members.size() * columns, scram::infinity);
    for (std::size_t i = 0; i < members.size(); ++i) {
      const Common common(members[i], tasks);
      for (std::size_t j = 0; j < columns; ++j) {
        if (!allowed(i, j) || !common.can_take(tasks[j])) continue;
        const Point from{static_cast<double>(members[i].x), static_cast<double>(members[i].y)};
        const Point to{1000.0 * tasks[j].base.x, 1000.0 * tasks[j].base.y};
        costs_[i * columns + j] = std::round(distance(from, to));
      }
    }
    for (std::size_t j = 0; j < columns; ++j) {
      for (std::size_t i = 0; i < members.size(); ++i) {
        if (members[i].claims != tasks[j].id) continue;
        costs_[i * columns + j] -= holder_bonus;  // infinity stays
        break;
      }
    }
    solver_.assign({costs_.data(), members.size(), columns, columns}, scram::Criterion::mmdr, order, choice, out);
  }

  // What the last assign() weighed: mm, infinity where a pair is forbidden.
  std::span<const double> costs() const { return costs_; }

 private:
  scram::Solver solver_;
  std::vector<double> costs_;
};

}  // namespace b_human
