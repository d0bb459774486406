// SPDX-License-Identifier: MIT
// A whole team of one assigner, each robot with its own view, over a radio that loses, delays and reorders packets. Do
// they come to agree? How long does it take, how much do they say, and what happens when a robot leaves and returns?
//
//   const Rehearsal rehearsal = rehearse(auction, Values(auction), {.robots = 7, .radio = {.loss = 0.3}});
//   for (const Act& act : rehearsal.acts) print(act.name, act.settled_after);
//
// A rehearsal is a row of acts. What differs between two acts is what changes in play: the places of robots and tasks,
// which tasks there are, which of them a robot does not know, who is penalised, who is out of range. Within an act
// nothing changes but what the robots say to each other. At the beginning they do not know of each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <regista/testkit/loaded.hpp>
#include <regista/testkit/radio.hpp>

namespace regista::testkit {

struct RehearsalConditions {
  int robots = 7;  // 3 to 11
  RadioConditions radio{};
  double packet_period = 1.0;  // s between two packets of a robot; what is pending rides along, the most urgent first
  std::uint64_t seed = 1;
  bool may_idle = false;  // a robot may have no task although one is free for it
};

// The robots agree when somebody has a task, no two that can hear each other do the same one and, unless they may idle,
// nobody who could do a task that it knows and that nobody does is without one.
struct Act {
  std::string name;
  double length = 0.0;  // s
  // s from its beginning to the last moment without agreement; none: there was one in the last fifth of the act.
  std::optional<double> settled_after;
  std::string disagreement;  // the last one, as a sentence; empty: there was none
};

struct Rehearsal {
  std::vector<Act> acts;
  std::size_t offers = 0, bytes = 0;  // bytes that left in packets, headings of segments included
  double robot_seconds = 0.0;         // robots x s
  std::vector<std::string> broken;    // promises of abi.h, each once
};

// Throws CallFailed when a call of the plugin fails.
Rehearsal rehearse(const Loaded& plugin, const Values& values, const RehearsalConditions& conditions);

}  // namespace regista::testkit
