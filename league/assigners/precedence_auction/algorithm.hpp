// SPDX-License-Identifier: MIT
// Bids of an auction in which tasks come in groups: Luo, Chakraborty and Sycara, "Multi-robot assignment algorithm for
// tasks with set precedence constraints", ICRA 2011. The groups are disjoint and in order. A robot takes at most one
// task of each group, and at most so many in all; the sum of the values is to be large. For each group in which it
// holds nothing it finds the task with the largest margin, value minus price. The groups with the largest margins it
// bids in, and raises each price by how much the margin exceeds what it would turn to instead, and epsilon. That is the
// second best task of the group, the best group that it leaves out, or nothing at all, which is worth 0.
//
// When nobody bids any more, the sum is within (tasks that are held) x epsilon of the largest one.
//
// The publication's order of groups is one in time: a group may begin when the groups before it are done. Roles of
// soccer are never done, and with one task for each robot such an order would change nothing. Order::first is our
// reading for them: a robot bids in the first groups in which a margin is above 0, whatever later ones are worth. So
// the first group gets the robots that are best for it, the next one the best of the rest, and so on; each group is
// within (tasks of it that are held) x epsilon of the best that these robots can do.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../distributed_auction/algorithm.hpp"

namespace precedence {

using auction::Market, auction::NewBid;

enum class Order { sum, first };

// A rule for auction::Participant.
struct OneOfEachGroup {
  std::uint32_t epsilon = 1;  // steps, >= 1
  std::size_t most = 1;       // tasks for each robot
  Order order = Order::sum;
  // A robot's best task of each group, in order of the groups. Room for as many as there are columns.
  struct Best {
    std::size_t column;
    std::int64_t first, second;
  };
  std::vector<Best>* scratch = nullptr;

  static std::size_t held(const Market& market) {
    return static_cast<std::size_t>(std::count(market.mine.begin(), market.mine.end(), 1));
  }
  static bool holds_of(const Market& market, std::int32_t group) {
    for (std::size_t column = 0; column < market.size(); ++column) {
      if (market.mine[column] && market.groups[column] == group) return true;
    }
    return false;
  }

  // What it bids now, at most once in each group.
  void bids(const Market& market, std::vector<NewBid>& out) const {
    out.clear();
    const std::size_t have = held(market);
    if (have >= most) return;
    std::vector<Best>& best = *scratch;
    find_best(market, best);
    const std::size_t room = most - have;
    if (order == Order::sum) {
      std::sort(best.begin(), best.end(), [](const Best& a, const Best& b) {
        return a.first != b.first ? a.first > b.first : a.column < b.column;
      });
    } else {
      std::sort(best.begin(), best.end(),
                [&](const Best& a, const Best& b) { return market.groups[a.column] < market.groups[b.column]; });
    }
    const std::int64_t left_out = order == Order::sum && best.size() > room ? best[room].first : 0;
    for (std::size_t k = 0; k < std::min(room, best.size()); ++k) {
      const auto raise = static_cast<std::uint32_t>(best[k].first - std::max(best[k].second, left_out));
      out.push_back({best[k].column, market.prices[best[k].column] + raise + epsilon});
    }
  }

  // Of what is held the best task of each group may stay, and `most` in all.
  bool is_one_too_many(const Market& market, std::size_t column) const {
    if (!is_best_held_of_its_group(market, column)) return true;
    std::size_t before = 0;
    for (std::size_t other = 0; other < market.size(); ++other) {
      if (other == column || !market.mine[other] || !is_best_held_of_its_group(market, other)) continue;
      before += keeps_rather(market, other, column) ? 1u : 0u;
    }
    return before >= most;
  }

  // With new values a held task may no longer be within epsilon of the best that this robot may have instead. No
  // robot gives up a task for none.
  bool is_no_longer_best(const Market& market, std::size_t column) const {
    const std::int64_t enough = std::max(std::int64_t{0}, market.margin(column) + epsilon);
    const bool is_full = held(market) >= most;
    bool is_last = true;  // of those that are held, the one to give up first
    for (std::size_t other = 0; other < market.size(); ++other) {
      if (other == column || !market.mine[other]) continue;
      is_last = is_last && keeps_rather(market, other, column);
    }
    for (std::size_t other = 0; other < market.size(); ++other) {
      if (!market.allows(other) || market.mine[other]) continue;
      if (market.groups[other] == market.groups[column]) {
        if (market.margin(other) > enough) return true;
        continue;
      }
      if (!is_full || !is_last || holds_of(market, market.groups[other])) continue;
      if (order == Order::sum && market.margin(other) > enough) return true;
      if (order == Order::first && market.groups[other] < market.groups[column] && market.margin(other) > epsilon) {
        return true;
      }
    }
    return false;
  }

  // Whether the robot would take `column`, which nobody holds, if its price were 0 again.
  bool misses(const Market& market, std::size_t column, std::size_t robots) const {
    if (!market.allows(column) || market.values[column] == 0) return false;
    const std::int32_t group = market.groups[column];
    const auto in_group = static_cast<std::size_t>(std::count(market.groups.begin(), market.groups.end(), group));
    const bool some_stay_open = in_group > robots || market.size() > robots * most;
    const std::int64_t value = market.values[column];
    for (std::size_t own = 0; own < market.size(); ++own) {
      if (market.mine[own] && market.groups[own] == group) {
        return some_stay_open && value > market.margin(own) + epsilon;
      }
    }
    if (held(market) < most) return true;
    for (std::size_t own = 0; own < market.size(); ++own) {
      if (!market.mine[own]) continue;
      if (order == Order::first && market.groups[own] > group) return true;
      if (order == Order::sum && some_stay_open && value > market.margin(own) + epsilon) return true;
    }
    return false;
  }

 private:
  // Which of two held tasks of different groups stays longer.
  bool keeps_rather(const Market& market, std::size_t a, std::size_t b) const {
    return order == Order::first ? market.groups[a] < market.groups[b] : comes_before(market, a, b);
  }
  static bool is_best_held_of_its_group(const Market& market, std::size_t column) {
    for (std::size_t other = 0; other < market.size(); ++other) {
      if (other == column || !market.mine[other] || market.groups[other] != market.groups[column]) continue;
      if (comes_before(market, other, column)) return false;
    }
    return true;
  }
  static bool comes_before(const Market& market, std::size_t a, std::size_t b) {
    const std::int64_t first = market.margin(a), second = market.margin(b);
    return first != second ? first > second : a < b;
  }

  // Of groups in which nothing is held, and in which some margin is above 0.
  static void find_best(const Market& market, std::vector<Best>& out) {
    out.clear();
    for (std::size_t column = 0; column < market.size(); ++column) {
      const std::int64_t margin = market.margin(column);
      if (!market.allows(column) || margin <= 0 || holds_of(market, market.groups[column])) continue;
      const auto same = std::find_if(out.begin(), out.end(), [&](const Best& each) {
        return market.groups[each.column] == market.groups[column];
      });
      if (same == out.end()) {
        out.push_back({column, margin, 0});
      } else if (margin > same->first) {
        *same = {column, margin, same->first};
      } else {
        same->second = std::max(same->second, margin);
      }
    }
  }
};

}  // namespace precedence
