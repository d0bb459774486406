// SPDX-License-Identifier: MIT
// One event in the life of a segment as recordings and the log of decisions tell it: who offered which bytes, when they
// left in a packet or were dropped, and which teammates heard them. A packet carries places and bytes, no handles:
// SentSegments, which sees both ends, tells which offer a teammate heard.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "match/side.hpp"
#include "mind/world/segment_journal.hpp"
#include "texts/json_text.hpp"

namespace regista::recording {

class SentSegments {
 public:
  // To be told every event of every mind, in the order of time. Gives the handle of the offer that it is about, which
  // is the sender's where a teammate hears it; 0 when there is none, or none is known.
  std::uint64_t follow(match::Side side, int robot, const mind::SegmentEvent& event);

 private:
  void add(match::Side side, int robot, const mind::SegmentEvent& sent);
  std::uint64_t handle(match::Side side, const mind::SegmentEvent& heard) const;

  struct Sent {
    std::int64_t milliseconds;  // a packet tells no more of its time
    int at;                     // in its packet
    std::uint64_t handle;
  };
  std::array<std::vector<std::vector<Sent>>, 2> sent_;  // by side and robot (n - 1)
};

// What an event is to be told with.
struct SegmentRecord {
  match::Side side;
  int robot;  // whose mind it is of
  const mind::SegmentEvent& event;
  std::uint64_t handle;  // of the offer, whoever made it; 0: none is known
  bool left;             // of what is sent: the packet left the robot
};

// "side":"home","robot":3,"segment":"offered", ... into an object that is open: see docs/recordings.md.
void write(texts::JsonText& json, const SegmentRecord& record);

}  // namespace regista::recording
