// SPDX-License-Identifier: MIT
// One robot of the consensus-based bundle algorithm (CBBA; with a bundle of one task CBAA) of Choi, Brunet and How
// (IEEE T-RO 25(4), 2009): it adds the tasks to its bundle that it can win, and corrects by what others tell whom it
// takes for the winner of each task (table.hpp). So a team comes to the assignment of a central greedy choice: of all
// robots and tasks always the pair that brings most. Gains must diminish: a task brings a robot the less the more tasks
// the robot has.
//
// Ours:
// - The time stamp of a robot is the tick at which it sent the newest packet of which one has news, directly or by
//   others; the paper counts the time of arrival. A packet that is older than other news of its sender is dropped.
// - A bid is lower than the one before it in the bundle; a gain that is not is cut. Then all can tell which task of a
//   robot is its first, and teams settle with gains of any kind. Of gains that strictly diminish none is cut while the
//   bundle is built from the beginning.
// - rebuild(). The paper only adds to a bundle. A task that was added while a better one looked taken then stays when
//   the better one becomes free, and about one random problem in a thousand ends beside the greedy assignment when the
//   bundle has room for two or more tasks and gains depend on which tasks are in it (test_networks.cpp). Who builds the
//   bundle anew at each decision ends at the greedy assignment in all that we tried, and no later.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "../negotiation/bids.hpp"
#include "table.hpp"

namespace consensus_bundle {

inline constexpr int nobody = 0;
inline constexpr std::int64_t never = std::numeric_limits<std::int64_t>::min();  // as a tick: no news at all

struct Claim {
  int winner = nobody;  // number of a robot, from 1
  std::uint32_t bid = 0;
  friend bool operator==(const Claim&, const Claim&) = default;
};

// What a packet says.
struct Told {
  int sender = 0;
  std::int64_t sent = never;         // tick
  std::vector<Claim> claims;         // by task
  std::vector<std::int64_t> stamps;  // by number - 1; the sender's own is not used
};

// What one more task would bring, and where in the path it would stand.
struct Gain {
  std::uint32_t value = 0;  // 0: the robot cannot take it
  std::size_t place = 0;
};

class Consensus {
 public:
  // own: from 1 to robots.
  void setup(int own, std::size_t robots, std::size_t tasks) {
    own_ = own;
    claims_.resize(tasks);
    stamps_.resize(robots);
    bundle_.reserve(tasks);
    path_.reserve(tasks);
    forget();
  }
  void forget() {
    std::ranges::fill(claims_, Claim{});
    std::ranges::fill(stamps_, never);
    bundle_.clear();
    path_.clear();
  }

  std::span<const Claim> claims() const { return claims_; }
  std::span<const std::int64_t> stamps() const { return stamps_; }
  // Which of a robot's tasks is its first: the one with the highest bid. The number of tasks when it wins none.
  std::size_t first_task_of(int number) const {
    std::size_t first = claims_.size();
    for (std::size_t task = 0; task < claims_.size(); ++task) {
      const bool higher = first == claims_.size() || claims_[task].bid > claims_[first].bid;
      if (claims_[task].winner == number && higher) first = task;
    }
    return first;
  }
  // Tasks in the order in which they were added, and in the order in which they would be done.
  std::span<const std::uint32_t> bundle() const { return bundle_; }
  std::span<const std::uint32_t> path() const { return path_; }

  // Phase 1 as published: adds tasks while the bundle has fewer than `limit`. gain(path, task) says what a task would
  // bring, for tasks that are not in the path.
  template <class GainOf>
  void extend(std::size_t limit, const GainOf& gain) {
    while (bundle_.size() < limit) {
      Gain best;
      std::uint32_t best_task = 0;
      for (std::uint32_t task = 0; task < claims_.size(); ++task) {
        if (claims_[task].winner == own_) continue;
        Gain each = gain(path(), task);
        if (!bundle_.empty()) each.value = std::min(each.value, claims_[bundle_.back()].bid - 1);
        if (each.value <= best.value || !wins(each.value, task)) continue;
        best = each;
        best_task = task;
      }
      if (best.value == 0) return;
      claims_[best_task] = {own_, best.value};
      bundle_.push_back(best_task);
      path_.insert(path_.begin() + static_cast<std::ptrdiff_t>(best.place), best_task);
    }
  }

  // Phase 1 from an empty bundle.
  template <class GainOf>
  void rebuild(std::size_t limit, const GainOf& gain) {
    release();
    extend(limit, gain);
  }

  // Phase 2. False: the packet is older than other news of its sender, and dropped.
  bool hear(const Told& told) {
    assert(told.claims.size() == claims_.size() && told.stamps.size() == stamps_.size());
    std::int64_t& newest = stamp(told.sender);
    if (told.sent < newest) return false;
    for (std::size_t task = 0; task < claims_.size(); ++task) {
      switch (believe(case_of(told, task))) {
        case Action::update:
          claims_[task] = told.claims[task];
          break;
        case Action::reset:
          claims_[task] = {};
          break;
        case Action::leave:
          break;
      }
    }
    for (std::size_t k = 0; k < stamps_.size(); ++k) stamps_[k] = std::max(stamps_[k], told.stamps[k]);
    newest = told.sent;
    release_from_first_lost();
    return true;
  }

  // Gives all own tasks up.
  void release() { release_from(0); }

  // Another robot is known to win nothing.
  void release_all_of(int number) {
    for (Claim& claim : claims_) {
      if (claim.winner == number) claim = {};
    }
  }
  // What was said of a robot before this tick is out of date.
  void ignore_before(int number, std::int64_t tick) { stamp(number) = std::max(stamp(number), tick); }

 private:
  std::int64_t& stamp(int number) { return stamps_[static_cast<std::size_t>(number - 1)]; }

  bool wins(std::uint32_t bid, std::uint32_t task) const {
    const Claim& claim = claims_[task];
    return claim.winner == nobody || negotiation::beats(bid, own_, claim.bid, claim.winner);
  }

  Says says(int winner, int sender) const {
    if (winner == nobody) return Says::nobody;
    if (winner == own_) return Says::me;
    return winner == sender ? Says::sender : Says::third;
  }

  Case case_of(const Told& told, std::size_t task) const {
    const Claim &theirs = told.claims[task], &mine = claims_[task];
    Case out{says(theirs.winner, told.sender), says(mine.winner, told.sender), false, false, false, false, false};
    const auto their_stamp = [&](int number) { return told.stamps[static_cast<std::size_t>(number - 1)]; };
    const auto my_stamp = [&](int number) { return stamps_[static_cast<std::size_t>(number - 1)]; };
    if (out.sender_says == Says::third || out.i_say == Says::third) {
      const int m = out.sender_says == Says::third ? theirs.winner : mine.winner;
      out.newer_m = their_stamp(m) > my_stamp(m);
      out.older_m = their_stamp(m) < my_stamp(m);
    }
    if (out.sender_says == Says::third && out.i_say == Says::third) {
      out.same_third = theirs.winner == mine.winner;
      out.newer_n = their_stamp(mine.winner) > my_stamp(mine.winner);
    }
    out.higher = negotiation::beats(theirs.bid, theirs.winner, mine.bid, mine.winner);
    return out;
  }

  // Later tasks of the bundle were added for what they bring beside the lost one.
  void release_from_first_lost() {
    std::size_t k = 0;
    while (k < bundle_.size() && claims_[bundle_[k]].winner == own_) ++k;
    release_from(k);
  }
  void release_from(std::size_t first) {
    for (std::size_t k = first; k < bundle_.size(); ++k) {
      Claim& claim = claims_[bundle_[k]];
      if (claim.winner == own_) claim = {};
      std::erase(path_, bundle_[k]);
    }
    bundle_.resize(first);
  }

  int own_ = 0;
  std::vector<Claim> claims_;         // z and y of the paper, by task
  std::vector<std::int64_t> stamps_;  // s, by number - 1
  std::vector<std::uint32_t> bundle_, path_;
};

}  // namespace consensus_bundle
