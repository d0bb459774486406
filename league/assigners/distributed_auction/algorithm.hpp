// SPDX-License-Identifier: MIT
// One bid of the auction algorithm: Bertsekas, "A distributed algorithm for the assignment problem", MIT 1979, and "The
// auction algorithm: a distributed relaxation method for the assignment problem", Annals of Operations Research 14,
// 1988. A robot without a task finds the task with the largest margin, value minus price, and raises its price by how
// much that margin exceeds the second largest, and epsilon.
//
// Having no task is worth 0. This stands for the dummy tasks that the publication adds where robots outnumber tasks,
// and it keeps prices finite where some robots may take only tasks that others hold. So a margin of 0 or below is not
// bid for, and a second margin below 0 counts as 0.
//
// Whole numbers throughout. When nobody bids any more, the sum of the values is within (tasks that are held) x epsilon
// of the largest one, and equal to it where epsilon is 1 and all values are multiples of a number above that of the
// tasks.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace auction {

inline constexpr std::int32_t may_not = -1;  // the value of a task that the robot must not take

// What a robot bids on: one column for each task, ascending ids. Owned by the caller.
struct Market {
  std::span<const std::int32_t> values;  // steps of utility, >= 0, or may_not
  std::span<const std::uint32_t> prices;
  std::span<const std::int32_t> groups;  // ascending from the first group; all equal: there are no groups
  std::span<const char> mine;            // 1: this robot is its bidder

  std::size_t size() const { return values.size(); }
  bool allows(std::size_t column) const { return values[column] != may_not; }
  std::int64_t margin(std::size_t column) const { return std::int64_t{values[column]} - std::int64_t{prices[column]}; }
};

struct NewBid {
  std::size_t column;
  std::uint32_t price;
};

// The rule of Bertsekas: one task for each robot, whatever their groups.
struct OneTask {
  std::uint32_t epsilon = 1;  // steps, >= 1

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  static std::size_t held(const Market& market) {
    for (std::size_t column = 0; column < market.size(); ++column) {
      if (market.mine[column]) return column;
    }
    return none;
  }

  // What it bids now, at most once for each column.
  void bids(const Market& market, std::vector<NewBid>& out) const {
    out.clear();
    if (held(market) != none) return;
    std::size_t best = none;
    std::int64_t first = 0, second = 0;
    for (std::size_t column = 0; column < market.size(); ++column) {
      if (!market.allows(column)) continue;
      const std::int64_t margin = market.margin(column);
      if (margin > first) {
        second = first;
        first = margin;
        best = column;
      } else {
        second = std::max(second, margin);
      }
    }
    if (best == none) return;
    out.push_back({best, market.prices[best] + static_cast<std::uint32_t>(first - second) + epsilon});
  }

  // Of two held tasks at most one may stay: whether `column` is worse than another one that is held.
  bool is_one_too_many(const Market& market, std::size_t column) const {
    for (std::size_t other = 0; other < market.size(); ++other) {
      if (other == column || !market.mine[other]) continue;
      const std::int64_t own = market.margin(column), best = market.margin(other);
      if (best > own || (best == own && other < column)) return true;
    }
    return false;
  }

  // With new values a held task may no longer be within epsilon of the best: it is then given up. But no robot gives up
  // a task for none: what it has bid may be more than the task is worth to it now, and yet nobody bids more.
  bool is_no_longer_best(const Market& market, std::size_t column) const {
    const std::int64_t enough = std::max(std::int64_t{0}, market.margin(column) + epsilon);
    for (std::size_t other = 0; other < market.size(); ++other) {
      if (market.allows(other) && market.margin(other) > enough) return true;
    }
    return false;
  }

  // Whether the robot would take `column`, which nobody holds, if its price were 0 again. With no more tasks than
  // robots only who has none would: the others' turn comes when the chain of those that are outbid gets there.
  bool misses(const Market& market, std::size_t column, std::size_t robots) const {
    if (!market.allows(column) || market.values[column] == 0) return false;
    const std::size_t own = held(market);
    if (own == none) return true;
    return market.size() > robots && std::int64_t{market.values[column]} > market.margin(own) + epsilon;
  }
};

}  // namespace auction
