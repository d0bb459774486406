// SPDX-License-Identifier: MIT
// The number of a negotiation. Who sees that the robots that play or the tasks are others than before begins the next
// one; who hears of a later one joins it; what belongs to an earlier one is ignored. Prices and bids may then only rise
// within an epoch, so that the order in which packets arrive does not matter.
//
// Compared as serial numbers of eight bits (RFC 1982): 3 comes after 250.
#pragma once

#include <cstdint>
#include <span>

namespace negotiation {

enum class Order { earlier, same, later };

// Of `heard` as seen from `own`. Numbers 128 apart are in no order: the larger one counts as later, on both sides.
constexpr Order compare_epochs(std::uint8_t heard, std::uint8_t own) {
  const auto ahead = static_cast<std::uint8_t>(heard - own);
  if (ahead == 0) return Order::same;
  if (ahead == 128) return heard > own ? Order::later : Order::earlier;
  return ahead < 128 ? Order::later : Order::earlier;
}

// What a negotiation is about, as one number: which robots play and which tasks there are, in any order.
class Subject {
 public:
  void add_robot(int number) { sum_ += mix(static_cast<std::uint64_t>(number)); }
  void add_task(int id) { sum_ += mix(0x10000u + static_cast<std::uint64_t>(id)); }
  // The same robots and tasks once more.
  void add_round(int number) { sum_ += mix(0x100000000u + static_cast<std::uint64_t>(number)); }
  friend bool operator==(Subject, Subject) = default;

 private:
  static constexpr std::uint64_t mix(std::uint64_t value) {  // SplitMix64's, Steele, Lea and Flood 2014
    value += 0x9e3779b97f4a7c15u;
    value = (value ^ value >> 30) * 0xbf58476d1ce4e5b9u;
    value = (value ^ value >> 27) * 0x94d049bb133111ebu;
    return value ^ value >> 31;
  }
  std::uint64_t sum_ = 0;
};

class Epoch {
 public:
  void forget() { *this = {}; }
  std::uint8_t number() const { return number_; }
  // True: a new epoch has begun, because the subject is another one than before. The first subject begins none.
  bool about(Subject subject) {
    const bool changes = known_ && !(subject == subject_);
    known_ = true;
    subject_ = subject;
    if (changes) ++number_;
    return changes;
  }
  // A teammate speaks of this epoch. True: it is a later one, which is the own one from now on. `same`: what it says
  // counts here.
  struct Heard {
    bool joined, counts;
  };
  Heard hear(std::uint8_t number) {
    const Order order = compare_epochs(number, number_);
    if (order == Order::later) number_ = number;
    return {order == Order::later, order != Order::earlier};
  }

 private:
  std::uint8_t number_ = 0;
  bool known_ = false;
  Subject subject_;
};

}  // namespace negotiation
