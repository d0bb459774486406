// SPDX-License-Identifier: MIT
// What a robot that passes tokens is given for a decision: settings, tasks that it perceives, teammates.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "token.hpp"

namespace token_passing {

enum class Takeover { never, last, always };

// Capabilities and thresholds in thousandths.
struct Settings {
  int threshold = 700, step = 100;     // the first one, and by how much it falls; step >= 1
  int give_up = 100;                   // below the threshold
  Takeover takeover = Takeover::last;  // last: at the last threshold only
  bool foresight = true;
  int repeats = 3;          // packets
  double patience = 10.0;   // s
  double silence = 25.0;    // s
  double stagger = 2.0;     // s
  double rest = 10.0;       // s
  double gone_after = 4.0;  // s

  // How often it can fall.
  int rounds() const { return (threshold + step - 1) / step; }
  int threshold_of(int round) const { return std::max(threshold - round * step, 0); }
  // The highest threshold that a capability reaches.
  int round_of(int capability) const {
    return capability >= threshold ? 0 : std::min((threshold - capability + step - 1) / step, rounds());
  }
};

// A token whose task this robot perceives. capability[number - 1]: of each robot, as this one believes; below 0: it may
// not do the task. A smaller importance is more important.
struct Work {
  int id = 0;
  int importance = 0;
  std::span<const std::int32_t> capability;
};

struct Situation {
  double now = 0.0;            // s
  int own = 1;                 // number
  Robots members = 0;          // those that play; without the own number: this robot does not
  std::span<const Work> work;  // the most important first, each id once
};

}  // namespace token_passing
