// SPDX-License-Identifier: MIT
// The map of robots to tasks that was broadcast last, as Nao Devils (released code, 2024) keep it: all adopt the newest
// map, whoever made it, and go on with it until there is a newer one.
//
// Ours: a map has a serial number, one more than that of the map that its author knew, and of two with the same number
// that of the lower robot counts as the newer. So robots that have heard the same maps, in whichever order, have the
// same one; the released code compares times. When a map is void: see look().
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../negotiation/epoch.hpp"

namespace nao_devils {

struct Stamp {
  std::uint8_t serial = 0;
  int author = 0;  // number of a robot
  friend bool operator==(Stamp, Stamp) = default;
};

constexpr bool is_newer(Stamp heard, Stamp own) {
  const negotiation::Order order = negotiation::compare_epochs(heard.serial, own.serial);
  return order == negotiation::Order::later || (order == negotiation::Order::same && heard.author < own.author);
}

class LastMap {
 public:
  void reserve(std::size_t robots) {
    tasks_.reserve(robots);
    numbers_.reserve(robots);
  }
  void forget() {
    exists_ = void_ = fitted_ = false;
    stamp_ = {};
    numbers_.clear();
  }

  // A map arrived, or the own one has just been sent. False: it is no newer than the last one.
  bool adopt(Stamp stamp, std::span<const std::int32_t> tasks) {
    if (exists_ && !is_newer(stamp, stamp_)) return false;
    stamp_ = stamp;
    tasks_.assign(tasks.begin(), tasks.end());
    exists_ = true;
    void_ = fitted_ = false;
    return true;
  }

  // Once per decision. numbers: the robots that play here; fits: the map is for just these robots and about the tasks
  // here, and gives this robot one of them if any. The map becomes void when it fitted before and no longer does, and
  // when it does not fit after robots have left or returned. A map that never fitted is not void: it comes from a robot
  // that sees other robots or tasks. If each of two such robots took the other's map for void, both would make new ones
  // for ever.
  void look(std::span<const std::int32_t> numbers, bool fits) {
    const bool others = !std::equal(numbers.begin(), numbers.end(), numbers_.begin(), numbers_.end());
    numbers_.assign(numbers.begin(), numbers.end());
    if (!exists_) return;
    if (!fits && (fitted_ || others)) void_ = true;
    if (fits) {
      fitted_ = true;
      void_ = false;
    }
  }

  // Anyone may make the next one: none was heard of yet, or it is void.
  bool is_wanting() const { return !exists_ || void_; }
  bool exists() const { return exists_; }
  // Of the last map; tasks live until the next call.
  Stamp stamp() const { return stamp_; }
  std::span<const std::int32_t> tasks() const { return tasks_; }
  Stamp next_of(int author) const { return {static_cast<std::uint8_t>(stamp_.serial + 1), author}; }

 private:
  Stamp stamp_;
  std::vector<std::int32_t> tasks_, numbers_;
  bool exists_ = false, void_ = false, fitted_ = false;
};

}  // namespace nao_devils
